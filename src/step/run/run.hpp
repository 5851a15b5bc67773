#pragma once
// A whole run: set-up, time loop, output, summary.

#include <functional>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/error.hpp"
#include "src/output/progress.hpp"
#include "src/output/summary.hpp"
#include "src/step/run/stop_request.hpp"

namespace percuss {

struct RunOptions {
  std::string out_dir;  // exists; empty: write no files at all (tests, studies)
  Progress::Style progress = Progress::Style::quiet;
  std::string restart = {};            // checkpoint to continue from; empty: the run begins at time 0
  bool goes_on_in_place = false;       // with it: out_dir holds the files of the run that wrote it, which are continued
  bool may_remove_results = false;     // with that: also if the files hold what this run does not write again
  bool allows_external_files = false;  // HDF5 files may take data from others: a run that continues needs that, too
  std::function<void()> prepare_output = {};  // called once set-up has succeeded, before the first file is made; rank 0
  // Called in the handler of an error that this rank alone has met, while the others wait for it; ends all of them.
  std::function<void()> end_all_ranks = {};
  std::vector<Warning> warnings = {};  // that the caller has of the run, besides those of the deck
};

struct RunResult {
  ExitCode exit_code = ExitCode::done;  // done or interrupted
  Summary summary;
  std::string checkpoint;  // the last one written, or gone on from; empty: none
  std::string resume;      // how to continue from it
  bool has_end = false;    // whether that checkpoint is of the last state
};

/// Runs a scene to its end on all ranks of the program; rank 0 writes and speaks. Files in out_dir: fields, history and
/// summary as the deck asks, checkpoints when they are due and when the run is stopped. The summary is there from the
/// first step on, then with status "running", and written again at the end in any case. A restart that is refused has
/// changed no file. Collective: deck and options are the same on every rank, and so is the result. Throws InputError,
/// RunError, SystemError and, where a stop is requested before the first file is made, Interruption, the same on all
/// ranks; what was written before stays.
RunResult run_scene(const Deck& deck, const RunOptions& options);

}  // namespace percuss
