#include "src/output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace percuss {
namespace {

// Closes on every way out; close_now() tells whether the system accepted all of it (some report a full disk only here).
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool close_now() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(fd, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

// Some file systems cannot sync a folder; the file itself is safe there.
void sync_folder_of(const std::string& path) {
  const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) ::fsync(folder.get());
}

std::string suggest_for_errno(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "; free some space, or choose another folder with --out";
    case EFBIG:
      return "; raise the limit on file sizes (ulimit -f), or write fewer frames and fields";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a folder that you may write to with --out";
    case ENOENT:
    case ENOTDIR:
      return "; check that its folder exists";
    default:
      return "";
  }
}

SystemError make_io_error(std::string_view action, const std::string& path, int error_number) {
  return SystemError(
      fmt::format("cannot {} '{}' ({}){}", action, path, std::strerror(error_number), suggest_for_errno(error_number)));
}

void write_file_atomically(const std::string& path, std::string_view text, Durability durability) {
  const std::string temporary = path + ".tmp";
  const auto fail = [&](int error_number) {
    ::unlink(temporary.c_str());
    throw make_io_error("write", path, error_number);
  };
  // Made anew, never taken over: what stands there may be a link that leads elsewhere.
  ::unlink(temporary.c_str());
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (file.get() < 0) throw make_io_error("write", path, errno);
  if (!write_all(file.get(), text)) fail(errno);
  if (durability == Durability::disk && ::fsync(file.get()) != 0) fail(errno);
  if (!file.close_now()) fail(errno);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(errno);
  if (durability == Durability::disk) sync_folder_of(path);
}

}  // namespace percuss
