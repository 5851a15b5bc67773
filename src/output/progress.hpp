#pragma once
// The progress of a run: one live line on a terminal, sparse plain lines elsewhere (log files, pipes).

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include "src/output/files/safe_text.hpp"

namespace percuss {

/// Prints progress messages. A closed pipe or a full disk must not end a run, so errors of the stream are ignored,
/// where fmt::print would throw. Control characters are made visible.
template <class... Args>
void print_quietly(std::FILE* stream, fmt::format_string<Args...> format, Args&&... args) {
  std::fputs(make_printable(fmt::format(format, std::forward<Args>(args)...)).c_str(), stream);
}

/// "45 s", "12 min 05 s", "3 h 07 min"; "?" for what is not finite. time: [s]
std::string format_duration(double time);

struct ProgressState {
  long step = 0;
  double time = 0, end_time = 0, dt = 0;
  double energy_error = 0;  // relative
  long contacts = 0;        // interactions in force
  std::int64_t eroded = 0;  // eroded elements
};

class Progress {
 public:
  enum class Style { live, plain, quiet };

  /// live if the stream is a terminal, plain otherwise.
  static Style choose_style(std::FILE* stream);
  Progress(std::FILE* stream, Style style);

  /// Cheap to call every step: prints only when a line is due (live: 10 a second; plain: every 10 % and every 30 s).
  void report(const ProgressState& state);

  /// Removes an open live line, so that something else can be printed in its place; the next report draws it again.
  void clear();

  /// Prints the last line (100 % if the run is complete) and ends the live line.
  void finish(const ProgressState& state);

 private:
  enum class Ending { open, closed };
  using Clock = std::chrono::steady_clock;
  void print(const ProgressState& state, Clock::time_point now, Ending ending);

  std::FILE* stream_;
  Style style_;
  Clock::time_point start_, last_;  // last_: of the line printed before
  long first_step_ = 0, last_step_ = 0;
  double first_share_ = 0;  // a restart does not begin at 0
  int last_tenth_ = -1;     // -1: nothing printed yet
  bool is_open_ = false;    // a live line stands that has no end
};

}  // namespace percuss
