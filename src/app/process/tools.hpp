#pragma once
// The commands that are tools of the Python package: import, plot, report, watch, stop, render, view, export, sweep,
// build-law.

#include <string>
#include <vector>

#include "src/error.hpp"

namespace percuss {

/// Their names.
const std::vector<std::string>& tool_names();

/// Becomes the tool that the first argument names, with the arguments behind it; of `help TOOL` the tool with --help.
/// Returns false if it names none. Throws InputError where the package is not found, or under mpirun.
bool become_tool(int argc, char** argv);

}  // namespace percuss
