#pragma once
// A whole run: set-up, time loop, output, summary.

#include <functional>
#include <string>

#include "src/deck/deck.hpp"
#include "src/error.hpp"
#include "src/output/progress.hpp"
#include "src/output/summary.hpp"

namespace percuss {

struct RunOptions {
  std::string out_dir;  // exists; empty: write no files at all (tests, studies)
  Progress::Style progress = Progress::Style::quiet;
  std::function<void()> prepare_output = {};  // called once set-up has succeeded, before the first file is made
};

struct RunResult {
  ExitCode exit_code = ExitCode::done;  // done or interrupted
  Summary summary;
};

/// Asks the run in progress to stop after its step; async-signal-safe. run_scene installs nothing: main does.
void request_stop();

/// Runs a scene to its end. Files in out_dir: fields, history and summary as the deck asks; once the loop has begun
/// the summary is written in any case, with status and error. Throws InputError, RunError, SystemError; what was
/// written before stays.
RunResult run_scene(const Deck& deck, const RunOptions& options);

}  // namespace percuss
