#pragma once
// The commands that are programs of their own, written in Python: import, plot, report, watch, stop, render.

#include <string>
#include <vector>

#include "src/error.hpp"

namespace percuss {

/// Their names.
const std::vector<std::string>& tool_names();

/// Becomes the tool that the first argument names, with the arguments behind it; of `help TOOL` the tool with --help.
/// Returns false if it names none. Throws InputError where the tool is not found, or under mpirun.
bool become_tool(int argc, char** argv);

}  // namespace percuss
