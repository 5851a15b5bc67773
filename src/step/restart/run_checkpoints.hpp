#pragma once
// When a run writes checkpoints, and what it says of the last one.

#include <chrono>
#include <functional>
#include <string>

#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/step/results/run_output.hpp"

namespace percuss {

/// A word as a shell takes it: in single quotes where it has other characters than those of plain names and numbers.
std::string quote_for_shell(const std::string& word);

class RunCheckpoints {
 public:
  /// directory: where the file goes; empty: none is written. allows_external_files: a run that continues is to allow
  /// them, too. The deck outlives this.
  RunCheckpoints(const Deck& deck, const std::string& directory, bool allows_external_files);

  /// Whether one is left when the run comes to its end.
  bool is_wanted_at_end() const { return output_.checkpoint_at_end; }
  /// Whether one is due by simulated time.
  bool is_due(double time) const { return due_.is_due(time); }
  /// Whether one is due by the clock of this rank: all have to agree.
  bool is_clock_due() const;
  /// Step of the last one; -1: there is none.
  long step() const { return step_; }
  const std::string& path() const { return path_; }

  /// Removes what a run that was killed while it wrote one has left of it. By one rank.
  void remove_unfinished() const { remove_unfinished_checkpoint(file_); }
  /// The run begins at `time`, without one.
  void begin(double time) { due_.advance(time); }
  /// Takes the file at `path`, of this state, for the last one: a run that is restarted calls it.
  void note(const std::string& path, const State& state);
  /// Writes the state, where there is a directory; archive: everything that belongs to it. Collective. Throws
  /// SystemError, the same on all ranks.
  void write(const CheckpointHeader& header, const ChunkedMesh& chunked, const Communicator& ranks, const State& state,
             const std::function<void(CheckpointArchive&)>& archive);

  /// "to continue: percuss run DECK --set KEY=VALUE --restart CHECKPOINT --allow-external", from the last one: it fits
  /// the deck only with the same settings.
  std::string describe_resume() const;

  /// The last one, and how to continue from it; empty: there is none, or its file is gone.
  std::string describe() const;

 private:
  using Clock = std::chrono::steady_clock;

  const Deck& deck_;
  const OutputDeck& output_;
  std::string file_;  // empty: none is written
  bool allows_external_files_;
  Schedule due_;
  Clock::time_point clock_ = Clock::now();  // when the last one was written, or the run began
  std::string path_;                        // of the last one, as are the next
  long step_ = -1;
  double time_ = 0;
};

}  // namespace percuss
