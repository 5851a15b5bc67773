#include "src/deck/laws/user_exits.hpp"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <utility>

#include "kernels/material/user/user_call.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

constexpr int run_failed = static_cast<int>(ExitCode::run_failed);

std::function<void()>& end_of_ranks() {
  static std::function<void()> end;
  return end;
}

/// Signals that end code at once, with their description.
struct WatchedSignal {
  int number;
  const char* how;
  struct sigaction before;
};
std::array<WatchedSignal, 5>& watched_signals() {
  static std::array<WatchedSignal, 5> all = {
      {{SIGABRT, "by abort, or an exception that nothing catches", {}},
       {SIGSEGV, "by an access outside its memory, SIGSEGV", {}},
       {SIGBUS, "by an access outside its memory, SIGBUS", {}},
       {SIGFPE, "by a division of integers, SIGFPE", {}},
       {SIGILL, "by an instruction that the machine does not have, SIGILL", {}}}};
  return all;
}

[[noreturn]] void end_process(int code) {
  for (;;) ::syscall(SYS_exit_group, code);
}

/// The library that this thread is in; null also in a process that the library has made of this one.
const char* find_running_library() {
  static const pid_t own = ::getpid();
  return ::getpid() == own ? running_library : nullptr;
}

void end_if_in_library(const char* how) {
  if (const char* const library = find_running_library()) end_by_user_code(library, how);
}
void end_at_exit() { end_if_in_library("by exit, as STOP does"); }

/// A signal from elsewhere does what it did before.
void end_at_signal(int number) {
  for (WatchedSignal& watched : watched_signals()) {
    if (watched.number != number) continue;
    end_if_in_library(watched.how);
    ::sigaction(number, &watched.before, nullptr);
    ::raise(number);
  }
}

}  // namespace

void set_end_of_ranks(std::function<void()> end) { end_of_ranks() = std::move(end); }

// Ends all ranks. Broken code may hold the locks of memory and of files: the message needs neither, and the rest has
// ten seconds.
void end_by_user_code(const char* library, const char* how) {
  static std::atomic<bool> has_ended = false;
  running_library = nullptr;
  while (has_ended.exchange(true)) std::this_thread::sleep_for(std::chrono::seconds(1));
  std::signal(SIGALRM, [](int) { end_process(run_failed); });
  ::alarm(10);
  std::array<char, 4096> text{};
  const int size = std::snprintf(text.data(), text.size(),
                                 "error: the code of %s has ended the run (%s): its messages above, or its own files, "
                                 "say why\n",
                                 library, how);
  const auto count = std::min(static_cast<std::size_t>(std::max(size, 0)), text.size() - 1);
  if (::write(STDERR_FILENO, text.data(), count) < 0) std::perror("percuss");
  std::fflush(nullptr);
  if (const auto& end = end_of_ranks()) end();
  end_process(run_failed);
}

void watch_user_exits() {
  static const bool is_watching = [] {
    for (WatchedSignal& watched : watched_signals()) {
      struct sigaction action {};
      action.sa_handler = end_at_signal;
      action.sa_flags = SA_ONSTACK | SA_NODEFER;
      ::sigaction(watched.number, &action, &watched.before);
    }
    find_running_library();  // knows its process from now on
    return std::atexit(end_at_exit) == 0 && std::at_quick_exit(end_at_exit) == 0;
  }();
  (void)is_watching;
}

void guard_user_stacks() {
#pragma omp parallel
  {
    constexpr std::size_t size = std::size_t{256} << 10;
    thread_local const auto own = std::make_unique<char[]>(size);
    stack_t stack{};
    stack.ss_sp = own.get();
    stack.ss_size = size;
    ::sigaltstack(&stack, nullptr);
  }
}

}  // namespace percuss

using percuss::end_if_in_library;
using percuss::end_process;
using percuss::run_failed;

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have their own
#define PERCUSS_IN_PLACE_OF_LIBC extern "C" __attribute__((used, visibility("default"), noreturn)) void

// In the place of those of the C library, for libraries of users (user_routines.map): they call no handler.
PERCUSS_IN_PLACE_OF_LIBC _exit(int code) {
  end_if_in_library("by _exit");
  end_process(code);
}
PERCUSS_IN_PLACE_OF_LIBC _Exit(int code) noexcept {
  end_if_in_library("by _Exit");
  end_process(code);
}
PERCUSS_IN_PLACE_OF_LIBC pthread_exit(void* value) {
  end_if_in_library("by pthread_exit");
  reinterpret_cast<void (*)(void*)>(::dlsym(RTLD_NEXT, "pthread_exit"))(value);
  end_process(run_failed);
}
#endif
