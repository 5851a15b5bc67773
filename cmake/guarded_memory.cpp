#include "kernels/core/guarded_memory.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <signal.h>
#include <sys/mman.h>
#include <ucontext.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <vector>

namespace percuss {
namespace {

constexpr std::size_t page = 4096, arena_bytes = std::size_t{1} << 36;
constexpr std::size_t header_bytes = sizeof(Kokkos::Impl::SharedAllocationHeader);
constexpr int trap_flag = 1 << 8;  // of the processor: a trap after each instruction

/// The call that touched the memory, from the inside, and how often it did.
struct Touch {
  static constexpr int depth = 24;
  std::array<void*, depth> frames{};
  int count = 0;
  long times = 0;
};

struct Guard {
  std::mutex mutex;
  char* start = nullptr;
  std::size_t used = 0;                            // bytes from start that were ever handed out
  std::map<std::size_t, std::vector<char*>> free;  // by bytes
  std::vector<bool> is_header;                     // [pages] what Kokkos notes of an array, which its host code reads
  std::array<Touch, 2048> touches;
  int num_touches = 0, open = 0;
  long unplaced = 0;
  bool works = false, stops = false;

  void protect(int access) const {
    if (works && used > 0) ::mprotect(start, used, access);
  }
};

Guard& guard() {
  static Guard& it = *new Guard;  // arrays of statics may outlive others
  return it;
}

void open_guard() {
  if (guard().open++ == 0) guard().protect(PROT_READ | PROT_WRITE);
}

void close_guard() {
  if (--guard().open == 0) guard().protect(PROT_NONE);
}

void note_touch(Guard& of) {
  std::array<void*, Touch::depth + 3> frames{};
  const int found = ::backtrace(frames.data(), static_cast<int>(frames.size()));
  const int first = std::min(3, found);  // this, the handler, the return from it
  Touch touch;
  touch.count = found - first;
  std::copy(frames.begin() + first, frames.begin() + found, touch.frames.begin());
  const auto end = of.touches.begin() + of.num_touches;
  const auto known =
      std::find_if(of.touches.begin(), end, [&](const Touch& other) { return other.frames == touch.frames; });
  if (known == of.touches.end()) {  // of more calls than there is room for
    ++of.unplaced;
    return;
  }
  if (known == end) {
    *known = touch;
    ++of.num_touches;
  }
  ++known->times;
}

/// In one piece: other ranks write there too.
void write_touch(const Touch& touch) {
  constexpr int bytes_of_frame = 20, bytes_before = 80;
  std::array<char, bytes_before + bytes_of_frame * Touch::depth> line{};
  int used = std::snprintf(line.data(), line.size(), "host reads memory of kernels: %ld times at", touch.times);
  Dl_info program;
  ::dladdr(reinterpret_cast<void*>(&open_guard), &program);
  for (int i = 0; i < touch.count; ++i) {
    void* const frame = touch.frames[static_cast<std::size_t>(i)];
    Dl_info info;
    if (::dladdr(frame, &info) == 0 || info.dli_fbase != program.dli_fbase) continue;
    const auto offset = static_cast<std::size_t>(static_cast<char*>(frame) - static_cast<char*>(info.dli_fbase));
    used += std::snprintf(line.data() + used, line.size() - static_cast<std::size_t>(used), " %#zx",
                          offset - (i > 0 ? 1 : 0));
  }
  line[static_cast<std::size_t>(used)] = '\n';
  std::fputs(line.data(), stderr);
}

/// A touch from outside: noted, then let pass for one instruction.
void pass_touch(int, siginfo_t* info, void* context) {
  Guard& it = guard();
  const auto* const place = static_cast<const char*>(info->si_addr);
  if (!it.works || place < it.start || place >= it.start + it.used) {  // a fault like any other
    ::signal(SIGSEGV, SIG_DFL);
    return;
  }
  if (!it.is_header[static_cast<std::size_t>(place - it.start) / page]) {
    note_touch(it);
    if (it.stops) {
      write_touch(it.touches[0]);
      ::_exit(70);
    }
  }
  it.protect(PROT_READ | PROT_WRITE);
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] |= trap_flag;
}

void close_after_step(int, siginfo_t*, void* context) {
  Guard& it = guard();
  if (it.open == 0) it.protect(PROT_NONE);
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] &= ~static_cast<greg_t>(trap_flag);
}

void begin_kernel(const char*, std::uint32_t, std::uint64_t*) { open_guard(); }
void end_kernel(std::uint64_t) { close_guard(); }

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action = {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  ::sigaction(signal, &action, nullptr);
}

/// Data begin at a page: what Kokkos notes before them has the page before.
std::size_t find_bytes(std::size_t bytes) { return page + (bytes - header_bytes + page - 1) / page * page; }

}  // namespace

void* GuardedPages::impl_allocate(const char* label, std::size_t bytes, std::size_t logical,
                                  Kokkos::Tools::SpaceHandle space) const {
  Guard& it = guard();
  const std::scoped_lock lock(it.mutex);
  if (it.start == nullptr) {
    void* const arena =
        ::mmap(nullptr, arena_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (arena == MAP_FAILED) throw std::bad_alloc();
    it.start = static_cast<char*>(arena);
    it.is_header.resize(arena_bytes / page);
  }
  const std::size_t whole = find_bytes(bytes);
  auto& unused = it.free[whole];
  char* place = it.start + it.used;
  if (unused.empty()) {
    if (it.used + whole > arena_bytes) throw std::bad_alloc();
    it.is_header[it.used / page] = true;
    it.used += whole;
    if (it.open == 0) it.protect(PROT_NONE);
  } else {
    place = unused.back();
    unused.pop_back();
  }
  place += page - header_bytes;
  if (Kokkos::Profiling::profileLibraryLoaded())
    Kokkos::Profiling::allocateData(space, label, place, logical > 0 ? logical : bytes);
  return place;
}

void GuardedPages::impl_deallocate(const char* label, void* place, std::size_t bytes, std::size_t logical,
                                   Kokkos::Tools::SpaceHandle space) const {
  if (place == nullptr) return;
  Guard& it = guard();
  if (Kokkos::Profiling::profileLibraryLoaded())
    Kokkos::Profiling::deallocateData(space, label, place, logical > 0 ? logical : bytes);
  const std::scoped_lock lock(it.mutex);
  it.free[find_bytes(bytes)].push_back(static_cast<char*>(place) - (page - header_bytes));
}

OpenGuard::OpenGuard() { open_guard(); }
OpenGuard::~OpenGuard() { close_guard(); }

MemoryGuard::MemoryGuard() {
  namespace Tools = Kokkos::Tools::Experimental;
  Guard& it = guard();
  const char* const wish = std::getenv("PERCUSS_HOST_READS");
  it.stops = wish != nullptr && std::strcmp(wish, "stop") == 0;
  std::array<void*, 2> frames{};
  ::backtrace(frames.data(), 2);  // loads what a handler cannot
  Tools::set_begin_parallel_for_callback(begin_kernel);
  Tools::set_end_parallel_for_callback(end_kernel);
  Tools::set_begin_parallel_reduce_callback(begin_kernel);
  Tools::set_end_parallel_reduce_callback(end_kernel);
  Tools::set_begin_parallel_scan_callback(begin_kernel);
  Tools::set_end_parallel_scan_callback(end_kernel);
  handle(SIGSEGV, pass_touch);
  handle(SIGTRAP, close_after_step);
  it.works = true;
  it.protect(PROT_NONE);
}

MemoryGuard::~MemoryGuard() {
  Guard& it = guard();
  it.protect(PROT_READ | PROT_WRITE);
  it.works = false;
  for (int i = 0; i < it.num_touches; ++i) write_touch(it.touches[static_cast<std::size_t>(i)]);
  if (it.unplaced > 0) std::fprintf(stderr, "host reads memory of kernels: %ld times elsewhere\n", it.unplaced);
  if (it.open == 0) std::fprintf(stderr, "host reads memory of kernels: %d calls\n", it.num_touches);
}

long MemoryGuard::count_touches() {
  long count = guard().unplaced;
  for (int i = 0; i < guard().num_touches; ++i) count += guard().touches[static_cast<std::size_t>(i)].times;
  return count;
}

}  // namespace percuss
