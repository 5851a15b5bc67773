#pragma once
// What a run that continues in a folder would take away from it for good, in words.

#include <string>

#include "src/step/results/run_output.hpp"

namespace percuss {

/// A restart in the folder of its checkpoint.
struct RestartInPlace {
  std::string folder;
  std::string checkpoint;  // that it continues from
  SavedState from;         // the state of that
  SavedState end;          // where the run will end at the latest
};

/// Rows, frames, a completed summary and another checkpoint that lie beyond what the run makes anew; empty if nothing
/// does. By one rank; reads files and changes none.
std::string describe_removals(const RestartInPlace& restart, const CutStates& cut);

/// The message that refuses such a restart.
std::string refuse_removals(const RestartInPlace& restart, const std::string& removals);

}  // namespace percuss
