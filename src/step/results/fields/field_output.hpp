#pragma once
// One output of fields: output.fields, or an entry of output.field_outputs. When its frames are due, what they show,
// and their files: new ones, or those of the run that a restart continues.

#include <memory>
#include <optional>
#include <string>

#include "src/output/later_states.hpp"
#include "src/step/results/fields/frame_scene.hpp"
#include "src/step/results/fields/frames.hpp"
#include "src/step/results/fields/schedule.hpp"

namespace percuss {

/// Frames that a run that continues in a folder removes from a file of fields.
struct CutFrames {
  std::string file;
  LaterStates frames;
};

/// All calls are collective.
class FieldOutput {
 public:
  /// Finds the region. scene and fields outlive this. Throws InputError on all ranks alike.
  FieldOutput(const FrameScene& scene, const FieldsDeck& fields);

  bool is_due(double time) const { return frames_due_.is_due(time); }
  void advance(double time) { frames_due_.advance(time); }
  /// Whether, after archive() has loaded, less is due than in the run before.
  bool is_thinned() const { return frames_due_.is_thinned(); }

  /// Makes new files. Throws SystemError, InputError, the same on all ranks, as everything below.
  void create();
  /// Checks, after archive() has loaded, whether the files of the run that wrote the checkpoint are there, and changes
  /// nothing.
  void check_earlier() const;
  /// The frames behind the checkpoint, after archive() has loaded. By rank 0 alone; changes nothing.
  CutFrames find_later() const;
  /// Goes on with them. What the run did not write before begins here.
  void go_on();

  /// Writes the state, unless it was written; returns whether it was not.
  bool write(const State& state);
  /// Keeps the frame of a state in memory, where the deck requests it and it is due.
  void keep(const State& state);
  /// Writes kept frames that are not in the file, before that of a failed state.
  void write_kept(const State& failed);

  /// Frames that would have been written by that, had the run not begun at a checkpoint of step `start`: call before.
  int count_lost(const State& failed, std::int64_t start) const;

  /// Notes how many frames there are: call before saving.
  void note_length();
  void sync();
  /// Schedule and number of frames. time: of the state.
  void archive(CheckpointArchive& archive, double time);
  void close();
  bool are_files_in_place() const { return !frames_ || frames_->is_in_place(); }

 private:
  static constexpr std::int64_t no_file = -1;
  bool wants() const { return !scene_.directory.empty(); }

  FrameScene scene_;
  const FieldsDeck& fields_;
  std::unique_ptr<FieldRegion> region_;
  std::optional<Frames> frames_;
  Schedule frames_due_;
  std::int64_t last_frame_ = -1;        // step
  std::int64_t frame_count_ = no_file;  // at the last checkpoint
};

}  // namespace percuss
