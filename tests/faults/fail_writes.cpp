// A preloaded library that fails one of a program's calls which change files in a folder, or all from there on.
//
// LD_PRELOAD takes it; the environment says what is to happen:
//   FAULT_FOLDER  absolute path of the folder; only calls on files below it count
//   FAULT_CALL    number of the call that fails, from 0; without it none does
//   FAULT_KIND    once: it fails with EIO; always: it and all after it fail with ENOSPC; kill: the process is killed
//                 in the middle of it; lose: a write is not done, and told as done; flip: of what a read gives one bit
//                 is another
//   FAULT_CALLS   reads: calls that read files count, and no others
//   FAULT_RANK    the MPI rank that is to fail; without it the program has one
//   FAULT_REPORT  a file for the report: "N FUNCTION PATH" of the call that failed, or "N calls" at the end of a
//                 program in which none was to fail
//
// Calls that the C library makes within itself (fopen, fwrite) do not pass here.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

enum class Kind { none, once, always, kill, lose, flip };

std::string read_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_on_chosen_rank() {
  const std::string wanted = read_environment("FAULT_RANK");
  if (wanted.empty()) return true;
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"}) {  // Open MPI, MPICH, others
    if (const std::string rank = read_environment(name); !rank.empty()) return rank == wanted;
  }
  return false;
}

struct Plan {
  std::string folder = read_environment("FAULT_FOLDER"), report = read_environment("FAULT_REPORT");
  Kind kind = Kind::none;
  long call = -1;
  bool counts = !folder.empty() && is_on_chosen_rank(), is_of_reads = read_environment("FAULT_CALLS") == "reads";

  Plan() {
    const std::string number = read_environment("FAULT_CALL"), name = read_environment("FAULT_KIND");
    if (number.empty()) return;
    call = std::stol(number);
    kind = name == "once"     ? Kind::once
           : name == "always" ? Kind::always
           : name == "lose"   ? Kind::lose
           : name == "flip"   ? Kind::flip
                              : Kind::kill;
  }
};

const Plan& plan() {
  static const Plan only;
  return only;
}

std::atomic<long> calls = 0;

// By system calls alone, which do not pass here again.
void report(const std::string& text) {
  if (plan().report.empty()) return;
  const long file = ::syscall(SYS_open, plan().report.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) return;
  ::syscall(SYS_write, file, text.data(), text.size());
  ::syscall(SYS_close, file);
}

bool is_below_folder(const std::string& path) { return path.starts_with(plan().folder + "/"); }

std::string find_path(int descriptor) {
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = ::readlink(link.c_str(), path, sizeof path);
  return length <= 0 ? "" : std::string(path, static_cast<std::size_t>(length));
}

enum class Fate { succeeds, fails, dies, is_lost };

/// Fate of this call.
Fate meet(const char* function, const std::string& path) {
  if (!plan().counts || plan().is_of_reads || !is_below_folder(path)) return Fate::succeeds;
  const long number = calls++;
  if (plan().kind == Kind::none) return Fate::succeeds;
  if (number == plan().call) {
    report(std::to_string(number) + " " + function + " " + path + "\n");
    return plan().kind == Kind::kill ? Fate::dies : plan().kind == Kind::lose ? Fate::is_lost : Fate::fails;
  }
  return plan().kind == Kind::always && number > plan().call ? Fate::fails : Fate::succeeds;
}

int find_error() { return plan().kind == Kind::once ? EIO : ENOSPC; }

template <class Function>
Function find_next(const char* symbol) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, symbol));
}

/// Calls real(), fails, does half() of the work and dies, or answers lost().
template <class Real, class Half, class Lost>
auto follow(const char* function, const std::string& path, const Real& real, const Half& half, const Lost& lost) {
  switch (meet(function, path)) {
    case Fate::succeeds:
      return real();
    case Fate::is_lost:
      return lost();
    case Fate::dies:
      half();
      ::kill(::getpid(), SIGKILL);
      break;
    case Fate::fails:
      break;
  }
  errno = find_error();
  return decltype(real()){-1};
}

template <class Real>
auto follow(const char* function, const std::string& path, const Real& real) {
  return follow(
      function, path, real, [] {}, real);  // no write, which cannot be lost
}

ssize_t count_bytes(const iovec* pieces, int count) {
  std::size_t bytes = 0;
  for (int i = 0; i < count; ++i) bytes += pieces[i].iov_len;
  return static_cast<ssize_t>(bytes);
}

using Pwrite = ssize_t (*)(int, const void*, std::size_t, off_t);
using Pwritev = ssize_t (*)(int, const iovec*, int, off_t);
using Truncate = int (*)(int, off_t);
using Reserve = int (*)(int, off_t, off_t);
using Open = int (*)(const char*, int, ...);

ssize_t follow_pwrite(const char* symbol, int file, const void* data, std::size_t size, off_t offset) {
  const auto next = find_next<Pwrite>(symbol);
  return follow(
      symbol, find_path(file), [&] { return next(file, data, size, offset); },
      [&] { next(file, data, size / 2, offset); }, [&] { return static_cast<ssize_t>(size); });
}

/// Turns a bit in the middle of what was read, if it is this call's turn.
ssize_t follow_read(const char* function, int file, void* data, ssize_t got) {
  if (!plan().counts || !plan().is_of_reads || got <= 0) return got;
  const std::string path = find_path(file);
  if (!is_below_folder(path) || calls++ != plan().call || plan().kind != Kind::flip) return got;
  report(std::to_string(plan().call) + " " + function + " " + path + "\n");
  static_cast<unsigned char*>(data)[got / 2] ^= 4;
  return got;
}

ssize_t follow_pwritev(const char* symbol, int file, const iovec* pieces, int count, off_t offset) {
  const auto next = find_next<Pwritev>(symbol);
  return follow(
      symbol, find_path(file), [&] { return next(file, pieces, count, offset); },
      [&] { next(file, pieces, count / 2, offset); }, [&] { return count_bytes(pieces, count); });
}

int follow_truncate(const char* symbol, int file, off_t size) {
  return follow(symbol, find_path(file), [&] { return find_next<Truncate>(symbol)(file, size); });
}

// Returns its error, and leaves errno alone.
int follow_reserve(const char* symbol, int file, off_t offset, off_t size) {
  const int before = errno;
  const int result = follow(symbol, find_path(file), [&] { return find_next<Reserve>(symbol)(file, offset, size); });
  errno = before;
  return result == -1 ? find_error() : result;
}

int follow_open(const char* symbol, const char* path, int flags, unsigned mode) {
  const auto real = [&] { return find_next<Open>(symbol)(path, flags, mode); };
  if ((flags & (O_CREAT | O_TRUNC)) == 0) return real();
  return follow(symbol, path, real);
}

// A file that was written to is told of a failure at its end; it is closed all the same.
int follow_close(int file) {
  const auto next = find_next<int (*)(int)>("close");
  if (!plan().counts) return next(file);
  const int flags = ::fcntl(file, F_GETFL), before = errno;
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) return next(file);
  const std::string path = find_path(file);
  errno = before;
  const int result = next(file);
  return follow("close", path, [&] { return result; });
}

struct CountReport {
  CountReport() { plan(); }  // which then outlives this
  ~CountReport() {
    if (plan().counts && plan().kind == Kind::none) report(std::to_string(calls) + " calls\n");
  }
} const count_report;

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const unsigned mode = va_arg(rest, unsigned);
  va_end(rest);
  return follow_open("open", path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const unsigned mode = va_arg(rest, unsigned);
  va_end(rest);
  return follow_open("open64", path, flags, mode);
}
int close(int file) { return follow_close(file); }

ssize_t write(int file, const void* data, std::size_t size) {
  const auto next = find_next<ssize_t (*)(int, const void*, std::size_t)>("write");
  return follow(
      "write", find_path(file), [&] { return next(file, data, size); }, [&] { next(file, data, size / 2); },
      [&] { return static_cast<ssize_t>(size); });
}
ssize_t pwrite(int file, const void* data, std::size_t size, off_t offset) {
  return follow_pwrite("pwrite", file, data, size, offset);
}
ssize_t pwrite64(int file, const void* data, std::size_t size, off_t offset) {
  return follow_pwrite("pwrite64", file, data, size, offset);
}
ssize_t writev(int file, const iovec* pieces, int count) {
  const auto next = find_next<ssize_t (*)(int, const iovec*, int)>("writev");
  return follow(
      "writev", find_path(file), [&] { return next(file, pieces, count); }, [&] { next(file, pieces, count / 2); },
      [&] { return count_bytes(pieces, count); });
}
ssize_t pwritev(int file, const iovec* pieces, int count, off_t offset) {
  return follow_pwritev("pwritev", file, pieces, count, offset);
}
ssize_t pwritev64(int file, const iovec* pieces, int count, off_t offset) {
  return follow_pwritev("pwritev64", file, pieces, count, offset);
}

ssize_t read(int file, void* data, std::size_t size) {
  return follow_read("read", file, data, find_next<ssize_t (*)(int, void*, std::size_t)>("read")(file, data, size));
}
ssize_t pread(int file, void* data, std::size_t size, off_t offset) {
  using Pread = ssize_t (*)(int, void*, std::size_t, off_t);
  return follow_read("pread", file, data, find_next<Pread>("pread")(file, data, size, offset));
}
ssize_t pread64(int file, void* data, std::size_t size, off_t offset) {
  using Pread = ssize_t (*)(int, void*, std::size_t, off_t);
  return follow_read("pread64", file, data, find_next<Pread>("pread64")(file, data, size, offset));
}

int fsync(int file) {
  return follow("fsync", find_path(file), [&] { return find_next<int (*)(int)>("fsync")(file); });
}
int fdatasync(int file) {
  return follow("fdatasync", find_path(file), [&] { return find_next<int (*)(int)>("fdatasync")(file); });
}
int ftruncate(int file, off_t size) noexcept { return follow_truncate("ftruncate", file, size); }
int ftruncate64(int file, off_t size) noexcept { return follow_truncate("ftruncate64", file, size); }
int posix_fallocate(int file, off_t offset, off_t size) {
  return follow_reserve("posix_fallocate", file, offset, size);
}
int posix_fallocate64(int file, off_t offset, off_t size) {
  return follow_reserve("posix_fallocate64", file, offset, size);
}

int rename(const char* from, const char* to) noexcept {
  return follow("rename", to, [&] { return find_next<int (*)(const char*, const char*)>("rename")(from, to); });
}
int link(const char* from, const char* to) noexcept {
  return follow("link", to, [&] { return find_next<int (*)(const char*, const char*)>("link")(from, to); });
}
int unlink(const char* path) noexcept {
  return follow("unlink", path, [&] { return find_next<int (*)(const char*)>("unlink")(path); });
}
int remove(const char* path) noexcept {
  return follow("remove", path, [&] { return find_next<int (*)(const char*)>("remove")(path); });
}

}  // extern "C"
