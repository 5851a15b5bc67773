#pragma once
// When a run writes rows and frames, and where: into new files, or behind those of the run that a restart continues.

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/output/later_states.hpp"
#include "src/step/results/fields/field_output.hpp"
#include "src/step/results/history.hpp"

namespace percuss {

/// Rows and frames that a run that continues in a folder removes from its files, and does not write again.
struct CutStates {
  LaterStates rows;
  std::vector<CutFrames> frames;  // of each output of fields
};

/// All calls are collective.
class RunOutput {
 public:
  /// directory: empty: nothing is written. The others outlive this.
  RunOutput(const Deck& deck, const ChunkedMesh& chunked, const Model& model, const ContactStage& contact,
            Stepper& stepper, std::string directory);

  /// Makes new files. Throws SystemError, InputError, the same on all ranks, as everything below.
  void create();

  /// Checks, after archive() has loaded, whether the files of the run that wrote the checkpoint are there, and changes
  /// nothing.
  void check_earlier() const;

  /// What go_on() would remove after archive() has loaded, for good, if the checkpoint is of `from` and the run ends at
  /// `end` (of its step the largest number). By rank 0 alone; changes nothing.
  CutStates find_cut_states(const SavedState& from, const SavedState& end) const;

  /// Goes on with them. What the run did not write before begins here.
  void go_on();

  bool is_row_due(double time) const { return rows_.is_due(time); }
  /// Whether a frame of some output is.
  bool is_frame_due(double time) const;

  /// Whether there is a history, written or only for sensors.
  bool has_rows() const { return history_.has_value(); }
  /// The last row of it, on rank 0.
  std::vector<double> last_row() const { return history_ ? history_->row() : std::vector<double>(); }

  /// Writes the state, unless it was written.
  void write_row(const State& state, const AuditResult& audit);
  /// A frame of each output, or of those that are due.
  void write_frames(const State& state);
  void write_due_frames(const State& state);
  /// Keeps frames of a state in memory, where the deck requests it and they are due.
  void keep_frames(const State& state);
  /// Writes kept frames that are not in the file, before that of a failed state.
  void write_kept_frames(const State& failed);
  /// How many there would be besides, had the run not begun at a checkpoint of step `start`: call before.
  int count_lost_frames(const State& failed, std::int64_t start) const;
  void advance(double time);

  /// Hands all to the system and notes how long the files are: call before saving.
  void note_lengths();
  /// Waits until the disk has all.
  void sync();
  /// Schedules and the lengths of the files. time: of the state.
  void archive(CheckpointArchive& archive, double time);

  void close();

  /// Whether the files still have their names: not if somebody removed or replaced one.
  bool are_files_in_place() const;

 private:
  static constexpr std::int64_t no_file = -1;

  bool wants_rows() const { return (!directory_.empty() || !deck_.sensors.empty()) && rows_.is_set(); }
  HistoryScene history_scene() const { return {deck_, chunked_, stepper_}; }
  template <class IsWanted>
  void write_some_frames(const State& state, const IsWanted& is_wanted);

  const Deck& deck_;
  const ChunkedMesh& chunked_;
  const Model& model_;
  const ContactStage& contact_;
  Stepper& stepper_;
  const std::string directory_;
  std::list<FieldOutput> fields_;  // output.fields first
  std::optional<History> history_;
  Schedule rows_;
  std::int64_t last_row_ = -1;            // step
  std::int64_t history_bytes_ = no_file;  // at the last checkpoint
};

}  // namespace percuss
