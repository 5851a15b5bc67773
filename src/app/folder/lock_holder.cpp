#include "src/app/folder/lock_holder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>
#include <random>
#include <sstream>
#include <utility>

namespace percuss {
namespace {

std::string read_first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string read_link(const std::string& path) {
  std::array<char, 256> target{};
  const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
  return length > 0 ? std::string(target.data(), static_cast<std::size_t>(length)) : "";
}

std::string find_host() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// Start time of a process: field 22 of stat in proc(5), behind the name, which may hold anything. -1: there is none.
long long find_process_start(long process) {
  const std::string stat = read_first_line(fmt::format("/proc/{}/stat", process));
  const auto name_end = stat.rfind(')');
  if (name_end == std::string::npos) return -1;
  std::istringstream fields(stat.substr(name_end + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;
  long long start = -1;
  return fields >> start ? start : -1;
}

/// A process that has ended and that its parent has not looked after.
bool is_zombie(long process) {
  const std::string stat = read_first_line(fmt::format("/proc/{}/stat", process));
  const auto name_end = stat.rfind(')');
  return name_end != std::string::npos && stat.compare(name_end, 3, ") Z") == 0;
}

/// Arguments with blanks between them; control characters would reach the terminals of others.
std::string read_command() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string command((std::istreambuf_iterator<char>(file)), {});
  while (!command.empty() && command.back() == '\0') command.pop_back();
  for (char& c : command) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return command;
}

std::string make_nonce() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

double find_seconds_since_boot() {
  std::ifstream file("/proc/uptime");
  double seconds = 0;
  return file >> seconds ? seconds : 0;
}

}  // namespace

LockHolder describe_this_process() {
  LockHolder self;
  self.host = find_host();
  self.boot = read_first_line("/proc/sys/kernel/random/boot_id");
  self.pid_namespace = read_link("/proc/self/ns/pid");
  self.process = ::getpid();
  self.process_start = find_process_start(self.process);
  self.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  self.command = read_command();
  self.nonce = make_nonce();
  return self;
}

std::string format_holder(const LockHolder& h) {
  return fmt::format(
      "host: {}\nboot: {}\npid_namespace: {}\nprocess: {}\nprocess_start: {}\nstarted: {}\ncommand: {}\nnonce: {}\n",
      h.host, h.boot, h.pid_namespace, h.process, h.process_start, h.started, h.command, h.nonce);
}

LockHolder parse_holder(const std::string& text) {
  LockHolder holder;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto colon = line.find(": ");
    if (colon == std::string::npos) continue;
    const std::string key = line.substr(0, colon), value = line.substr(colon + 2);
    for (const auto& [name, member] :
         {std::pair{"host", &holder.host}, std::pair{"boot", &holder.boot},
          std::pair{"pid_namespace", &holder.pid_namespace}, std::pair{"started", &holder.started},
          std::pair{"command", &holder.command}, std::pair{"nonce", &holder.nonce}}) {
      if (key == name) *member = value;
    }
    if (key == "process") std::istringstream(value) >> holder.process;
    if (key == "process_start") std::istringstream(value) >> holder.process_start;
  }
  return holder;
}

HolderState find_state(const LockHolder& holder, double silent_s) {
  const LockHolder self = describe_this_process();
  if (holder.process <= 0 || holder.boot.empty() || self.boot.empty()) return HolderState::unknown;
  if (holder.boot == self.boot) {  // the same kernel, whatever the host is called
    if (holder.pid_namespace != self.pid_namespace) return HolderState::unknown;
    const bool is_there = find_process_start(holder.process) == holder.process_start && !is_zombie(holder.process);
    return is_there ? HolderState::running : HolderState::ended;
  }
  // Machines may share a name: it counts only if the holder has been silent since this one was started.
  const bool before_boot = silent_s > find_seconds_since_boot();
  return holder.host == self.host && before_boot ? HolderState::ended : HolderState::unknown;
}

std::string describe_holder(const LockHolder& holder) {
  if (holder.process <= 0) return "a process that its lock does not name";
  return fmt::format("process {} on host {}, started {}: {}", holder.process, holder.host, holder.started,
                     holder.command);
}

}  // namespace percuss
