#include "src/output/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace percuss {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr auto live_interval = milliseconds(100);
constexpr auto plain_interval = seconds(30);

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return duration<double>(to - from).count();
}

double share_done(const ProgressState& state) {
  if (!(state.end_time > 0) || !(state.time > 0)) return 0;
  return std::min(1.0, state.time / state.end_time);
}

// 45 s, 12 min 05 s, 3 h 07 min
std::string format_duration(double time) {
  if (!std::isfinite(time)) return "?";
  const auto whole = static_cast<long long>(std::min(time, 1e9) + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::size_t terminal_width(std::FILE* stream) {
  winsize size{};
  const bool known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 200;
}

}  // namespace

Progress::Style Progress::choose_style(std::FILE* stream) {
  return ::isatty(::fileno(stream)) == 1 ? Style::live : Style::plain;
}

Progress::Progress(std::FILE* stream, Style style)
    : stream_(stream), style_(style), start_(std::chrono::steady_clock::now()), last_(start_) {}

void Progress::report(const ProgressState& state) {
  if (style_ == Style::quiet) return;
  const auto now = std::chrono::steady_clock::now();
  const int tenth = static_cast<int>(10 * share_done(state));
  const bool first = last_tenth_ < 0;
  const bool due =
      style_ == Style::live ? now - last_ >= live_interval : tenth > last_tenth_ || now - last_ >= plain_interval;
  if (first) first_step_ = last_step_ = state.step;
  if (first) first_share_ = share_done(state);
  if (!first && !due) return;
  print(state, now, Ending::open);
  last_ = now;
  last_step_ = state.step;
  last_tenth_ = tenth;
}

void Progress::clear() {
  if (is_open_) print_quietly(stream_, "\r\x1b[K");
  is_open_ = false;
}

void Progress::finish(const ProgressState& state) {
  if (style_ == Style::quiet) return;
  print(state, std::chrono::steady_clock::now(), Ending::closed);
}

void Progress::print(const ProgressState& state, std::chrono::steady_clock::time_point now, Ending ending) {
  const double share = share_done(state);
  const double elapsed = seconds_between(start_, now);
  const bool closed = ending == Ending::closed;
  // The speed of late for the live line, of the whole run for the last line.
  const double interval = closed ? elapsed : seconds_between(last_, now);
  const long steps = state.step - (closed ? first_step_ : last_step_);
  const double speed = interval > 0 ? static_cast<double>(steps) / interval : 0;
  // What is left takes as long as what was done since the start of this process (a restart does not begin at 0).
  const double done = share - first_share_;
  const double left = done > 0 ? elapsed * (1 - share) / done : HUGE_VAL;
  std::string line = fmt::format(
      "{:5.1f} %  t = {:.4e}  step {}  dt {:.2e}  {:.4g} steps/s  {} {}  energy error {:.1e}"
      "  contacts {}",
      100 * share, state.time, state.step, state.dt, speed, closed ? "took" : "ETA",
      format_duration(closed ? elapsed : left), state.energy_error, state.contacts);
  if (state.eroded > 0) line += fmt::format("  eroded {}", state.eroded);
  if (style_ == Style::plain) {
    print_quietly(stream_, "{}\n", line);
  } else {
    line.resize(std::min(line.size(), terminal_width(stream_) - 1));  // a wrapped line could not be overwritten
    print_quietly(stream_, "\r{}\x1b[K{}", line, closed ? "\n" : "");
    is_open_ = !closed;
  }
  std::fflush(stream_);
}

}  // namespace percuss
