#pragma once
// What the user asks for on the command line.

#include <string>
#include <variant>
#include <vector>

#include "src/error.hpp"

namespace percuss {

struct Command {
  enum class Kind { run, check, info };
  Kind kind = Kind::run;
  std::string file;                   // the deck; for info, any file or folder of results
  std::vector<std::string> settings;  // --set path.to.key=value
  std::string out_dir;                // run: empty for the default
  bool force = false;                 // run: earlier results may be overwritten
  bool quiet = false;                 // run: no progress
};

/// Text to print instead of doing anything: help and version (stdout, done) or what is wrong (stderr, wrong_input).
struct Answer {
  std::string text;
  ExitCode exit_code = ExitCode::done;
};

/// Reads the arguments. Unknown commands and options are answered with the nearest known one.
std::variant<Command, Answer> parse_command_line(int argc, const char* const* argv);

}  // namespace percuss
