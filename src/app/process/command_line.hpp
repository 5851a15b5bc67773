#pragma once
// The request of the user on the command line.

#include <string>
#include <variant>
#include <vector>

#include "src/error.hpp"

namespace percuss {

/// Figures of the machine and of the run for `percuss plan`; the defaults are explained in docs/plan.md.
struct PlanFigures {
  double latency = 2e-6;          // of a message [s]
  double bandwidth = 1e9;         // of a rank [byte/s]
  double element_ns = 60;         // of a core, an element and step
  double contact_node_ns = 500;   // of a core, a contact node or face and step
  double iterations = 14;         // of the contact enforcement in a step
  double steps_per_search = 7.5;  // for which candidate pairs are used
  bool all_touch = false;         // each node touches the nearest face that it may touch
};

struct Command {
  enum class Kind { run, check, plan, info, schema };
  Kind kind = Kind::run;
  std::string file;                                 // the deck; for info, any file or folder of results
  std::vector<std::string> settings;                // --set path.to.key=value
  std::string out_dir;                              // run: empty for the default
  bool json = false;                                // check: what was found as JSON
  std::string restart = {};                         // run: checkpoint to continue from
  bool force = false;                               // run: earlier results may be overwritten
  bool quiet = false;                               // run: no progress
  bool allow_external = false;                      // run, check, plan, info: HDF5 files may take data from other files
  std::vector<std::string> allowed_libraries = {};  // run, check, plan: code of users that may be loaded
  std::vector<int> rank_counts = {};                // plan: numbers of ranks, each at least 1
  PlanFigures figures = {};                         // plan
};

/// Text to print instead of doing anything: help and version (stdout, done) or what is wrong (stderr, wrong_input).
struct Answer {
  std::string text;
  ExitCode exit_code = ExitCode::done;
};

/// Reads the arguments. Unknown commands and options are answered with the nearest known one.
std::variant<Command, Answer> parse_command_line(int argc, const char* const* argv);

}  // namespace percuss
