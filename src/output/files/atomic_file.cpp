#include "src/output/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>

#include "src/output/files/posix_file.hpp"

namespace percuss {
namespace {

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

void sync_folder_of(const std::string& path) {
  const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // it may be written to but not read
  const int error_number = ::fsync(folder) == 0 ? 0 : errno;
  ::close(folder);
  // Some file systems cannot sync a folder; the file itself is safe there.
  if (error_number == EIO || error_number == ENOSPC || error_number == EDQUOT)
    throw make_io_error("write", path, error_number);
}

std::string suggest_for_errno(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return ": free some space, or choose another folder with --out";
    case EFBIG:
      return ": raise the limit on file sizes (ulimit -f), or write fewer frames and fields";
    case EACCES:
    case EPERM:
    case EROFS:
      return ": choose a folder that you may write to with --out";
    case EIO:
      return ": check the disk (dmesg shows its errors), or choose another folder with --out";
    case ENOENT:
    case ENOTDIR:
      return ": check that its folder exists";
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
  // Made again, never taken over: what stands there may be a link that leads elsewhere.
  ::unlink(temporary.c_str());
  PosixFile file(temporary, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, path);
  try {
    file.write(text.data(), 0, static_cast<std::int64_t>(text.size()));
    if (durability == Durability::disk) file.sync();
    std::string found(text.size(), '\0');
    file.read(found.data(), 0, std::ssize(found));
    if (found != text || file.size() != std::ssize(found))
      throw SystemError(fmt::format("cannot write '{}' (read back, it is not what was written): check the disk", path));
    file.close();
    if (std::rename(temporary.c_str(), path.c_str()) != 0) throw make_io_error("write", path, errno);
  } catch (...) {  // memory may be exhausted, too
    ::unlink(temporary.c_str());
    throw;
  }
  if (durability == Durability::disk) sync_folder_of(path);
}

}  // namespace percuss
