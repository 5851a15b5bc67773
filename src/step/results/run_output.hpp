#pragma once
// When a run writes rows and frames, and where: into new files, or behind those of the run that a restart goes on with.

#include <cmath>
#include <optional>
#include <string>

#include "src/contact/contact_stage.hpp"
#include "src/output/later_states.hpp"
#include "src/step/results/fields/frames.hpp"
#include "src/step/results/history.hpp"

namespace percuss {

/// Due at multiples of a period; never twice for one state.
class Schedule {
 public:
  explicit Schedule(std::optional<double> period) : period_(period) {}
  bool is_due(double time) const { return period_ && time >= next_ * (1 - 1e-12); }
  void advance(double time) {
    if (period_ && *period_ > 0) next_ = *period_ * (std::floor(time / *period_ * (1 + 1e-12)) + 1);
  }
  bool is_set() const { return period_.has_value(); }
  /// After archive() has loaded: whether less is due than in the run before.
  bool is_thinned() const { return is_thinned_; }

  /// Goes on with what another run of the same period has; `time` is where.
  void archive(CheckpointArchive& archive, const std::string& name, double time);

 private:
  std::optional<double> period_;
  double next_ = 0;
  bool is_thinned_ = false;
};

/// What a run that goes on in a folder cuts off its files, and does not write again.
struct CutStates {
  LaterStates rows, frames;
  std::string frames_file = "fields.vtkhdf";  // the file of the frames
};

/// All calls are collective.
class RunOutput {
 public:
  /// directory: empty: nothing is written. The others outlive this.
  RunOutput(const Deck& deck, const ChunkedMesh& chunked, const Model& model, const ContactStage& contact,
            std::string directory);

  /// Makes new files. Throws SystemError, InputError, the same on all ranks, as everything below.
  void create();

  /// After archive() has loaded: looks whether the files of the run that wrote the checkpoint are there, and changes
  /// nothing.
  void check_earlier() const;

  /// After archive() has loaded: what go_on() would remove for good, if the checkpoint is of `from` and the run ends at
  /// `end` (of its step the largest number). By rank 0 alone; changes nothing.
  CutStates find_cut_states(const SavedState& from, const SavedState& end) const;

  /// Goes on with them. What the run did not write before begins here.
  void go_on();

  bool is_row_due(double time) const { return rows_.is_due(time); }
  bool is_frame_due(double time) const { return frames_due_.is_due(time); }

  /// Whether there is a history, written or only for sensors.
  bool has_rows() const { return history_.has_value(); }
  /// The last row of it, on rank 0.
  std::vector<double> last_row() const { return history_ ? history_->row() : std::vector<double>(); }

  /// Writes the state, unless it was written.
  void write_row(const State& state, const AuditResult& audit, Stepper& stepper);
  void write_frame(const State& state);
  /// Keeps the frame of a state in memory, where the deck asks for it and it is due.
  void keep_frame(const State& state);
  /// Before that of a failed state: the frames kept that are not in the file.
  void write_kept_frames(const State& failed);
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
  bool wants_frames() const { return !directory_.empty() && frames_due_.is_set(); }

  const Deck& deck_;
  const ChunkedMesh& chunked_;
  const Model& model_;
  const ContactStage& contact_;
  const std::string directory_;
  std::optional<Frames> frames_;
  std::optional<History> history_;
  Schedule frames_due_, rows_;
  std::int64_t last_row_ = -1, last_frame_ = -1;                  // steps
  std::int64_t history_bytes_ = no_file, frame_count_ = no_file;  // at the last checkpoint
};

}  // namespace percuss
