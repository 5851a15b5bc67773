#include "src/mesh/formats/exodus/trial_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>

#include "src/error.hpp"

namespace percuss {
namespace {

enum TrialOutcome : int { passed = 0, wrong_input = 1, system_failed = 2 };

void write_all(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(pipe, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string read_all(int pipe) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(pipe, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

/// The child: never returns, and leaves without the clean-up that belongs to its parent (MPI, open files).
[[noreturn]] void run_child(const std::function<void()>& trial, unsigned seconds, int pipe) {
  // The parent's handlers write backtraces. What asks a run to stop (Ctrl-C reaches both) stays with its handler: a
  // child that it ended would look like one that crashed on the file.
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGALRM}) std::signal(signal, SIG_DFL);
  const int silence = open("/dev/null", O_WRONLY);
  if (silence >= 0) {
    dup2(silence, STDOUT_FILENO);
    dup2(silence, STDERR_FILENO);
  }
  alarm(seconds);
  try {
    trial();
    _exit(passed);
  } catch (const InputError& error) {
    write_all(pipe, error.what());
    _exit(wrong_input);
  } catch (const std::exception& error) {
    write_all(pipe, error.what());
    _exit(system_failed);
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw SystemError(fmt::format("cannot wait for a trial process ({})", std::strerror(errno)));
  }
  return status;
}

}  // namespace

void run_trial_process(const std::function<void()>& trial, unsigned seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw SystemError(fmt::format("cannot make a pipe ({})", std::strerror(errno)));
  const pid_t child = fork();
  if (child < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    throw SystemError(fmt::format("cannot start a trial process ({})", std::strerror(reason)));
  }
  if (child == 0) run_child(trial, seconds, ends[1]);
  close(ends[1]);
  const std::string message = read_all(ends[0]);
  close(ends[0]);
  const int status = wait_for(child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == passed) return;
  if (WIFSIGNALED(status) || message.empty()) {  // a process that says nothing was ended by the library itself
    const bool hangs = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    const char* how = hangs ? "hangs" : "crashes";
    throw InputError(fmt::format("the file is damaged (its library {} on it): write or copy it again", how));
  }
  if (WEXITSTATUS(status) == wrong_input) throw InputError(message);
  throw SystemError(message);
}

unsigned find_patience(std::uintmax_t bytes) {
  constexpr std::uintmax_t least = 60, most = 86400, bytes_a_second = 1'000'000;
  return static_cast<unsigned>(std::min(most, least + bytes / bytes_a_second));
}

void rehearse(const std::string& path, std::uintmax_t bytes, const std::function<void()>& work) {
  const auto trial = [&] {
    try {
      work();
    } catch (const std::exception&) {  // thrown again in earnest
    }
  };
  try {
    run_trial_process(trial, find_patience(bytes));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: error: {}", path, error.what()));
  }
}

}  // namespace percuss
