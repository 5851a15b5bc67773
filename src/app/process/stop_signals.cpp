#include "src/app/process/stop_signals.hpp"

#include <array>
#include <csignal>

#include "comm/communicator.hpp"
#include "src/step/run/stop_request.hpp"

namespace percuss {
namespace {

constexpr std::array stop_signals{SIGINT, SIGTERM, SIGUSR1, SIGHUP, SIGXCPU};

extern "C" void stop_on_signal(int) { request_stop(); }
extern "C" void save_on_signal(int) { request_checkpoint(); }

void handle(int number, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART | flags;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

void change_mask(int how) {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : stop_signals) sigaddset(&set, number);
  sigprocmask(how, &set, nullptr);
}

bool is_ignored(int number) {
  struct sigaction present = {};
  return sigaction(number, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

/// Whether SIGHUP was ignored when the program was started (nohup).
bool was_hang_up_ignored = false;

extern "C" void note_hang_up(int, char**, char**) { was_hang_up_ignored = is_ignored(SIGHUP); }

// Before the initialisers of shared libraries: UCX, which Open MPI 5 loads, takes the signal in its own.
[[gnu::used, gnu::section(".preinit_array")]] void (*const noted)(int, char**, char**) = note_hang_up;

// The system sends SIGXCPU every second, and a terminal that goes away SIGHUP more than once.
bool does_second_end(int number) { return number == SIGINT || (number == SIGTERM && !is_launched()); }

}  // namespace

void hold_stop_signals() {
  if (was_hang_up_ignored) handle(SIGHUP, SIG_IGN, 0);
  change_mask(SIG_BLOCK);
}

void take_stop_signals() {
  for (const int number : stop_signals) {
    if (number == SIGHUP && was_hang_up_ignored) continue;
    handle(number, stop_on_signal, does_second_end(number) ? static_cast<int>(SA_RESETHAND) : 0);
  }
  if (is_launched()) handle(SIGCONT, save_on_signal, 0);
  change_mask(SIG_UNBLOCK);
}

void release_stop_signals() { change_mask(SIG_UNBLOCK); }

}  // namespace percuss
