#include "src/step/results/run_output.hpp"

#include <algorithm>
#include <utility>

#include "src/output/earlier/earlier_results.hpp"

namespace percuss {

namespace {

/// Leaves those that a run from `from` to `end` does not write again.
LaterStates keep_lost(LaterStates states, const SavedState& from, const SavedState& end, bool is_thinned) {
  const auto is_written_again = [&](const SavedState& s) {
    if (s.time > end.time * (1 + same_time) || s.step > end.step) return false;
    if (s.time < from.time * (1 - same_time)) return false;
    // The last state of a run that was stopped is in the checkpoint, whatever is due.
    return !is_thinned || s.time <= from.time * (1 + same_time);
  };
  states.erase(std::remove_if(states.begin(), states.end(), is_written_again), states.end());
  return states;
}

}  // namespace

void Schedule::archive(CheckpointArchive& archive, const std::string& name, double time) {
  double period = period_.value_or(-1), next = next_;
  archive.number(name + "/period", period);
  archive.number(name + "/next", next);
  if (!archive.is_loading()) return;
  is_thinned_ = period_ && period >= 0 && *period_ > period;
  if (period_ && *period_ == period) {
    next_ = next;
  } else {
    advance(time);
  }
}

RunOutput::RunOutput(const Deck& deck, const ChunkedMesh& chunked, const Model& model, const ContactStage& contact,
                     std::string directory)
    : deck_(deck),
      chunked_(chunked),
      model_(model),
      contact_(contact),
      directory_(std::move(directory)),
      frames_due_(deck.output.fields_every),
      rows_(deck.output.history_every) {}

void RunOutput::create() {
  if (wants_rows()) history_.emplace(directory_, deck_, chunked_, model_);
  if (wants_frames()) frames_.emplace(directory_, deck_, chunked_, model_, contact_);
}

void RunOutput::check_earlier() const {
  if (wants_rows() && history_bytes_ != no_file) History::check(directory_, deck_, chunked_, model_, history_bytes_);
  if (wants_frames() && frame_count_ != no_file) Frames::check(directory_, deck_, chunked_, model_, frame_count_);
}

CutStates RunOutput::find_cut_states(const SavedState& from, const SavedState& end) const {
  CutStates cut;
  if (wants_rows()) {
    cut.rows = keep_lost(find_later_rows(directory_ + "/history.csv", history_bytes_), from, end, rows_.is_thinned());
  }
  if (wants_frames()) {
    const FramesFormat& format = deck_.output.has_format(FieldsFormat::vtkhdf) ? vtkhdf_frames : exodus_frames;
    cut.frames_file = format.file_name;
    const LaterStates later = find_later_frames(format, directory_ + "/" + cut.frames_file, frame_count_);
    cut.frames = keep_lost(later, from, end, frames_due_.is_thinned());
  }
  return cut;
}

void RunOutput::go_on() {
  if (wants_rows() && history_bytes_ != no_file) {
    history_.emplace(directory_, deck_, chunked_, model_, history_bytes_);
  } else if (wants_rows()) {
    history_.emplace(directory_, deck_, chunked_, model_);
  }
  if (wants_frames() && frame_count_ != no_file) {
    frames_.emplace(directory_, deck_, chunked_, model_, contact_, frame_count_);
  } else if (wants_frames()) {
    frames_.emplace(directory_, deck_, chunked_, model_, contact_);
  }
}

void RunOutput::write_row(const State& state, const AuditResult& audit, Stepper& stepper) {
  if (!history_ || last_row_ == state.step) return;
  const Vec3 wall_force = stepper.find_wall_force();
  const std::vector<double> pair_work = contact_.sum_pair_work();
  const std::vector<double> walls = contact_.list_wall_motions();
  const std::vector<double> forces = stepper.forces().take(state);
  const std::vector<double> accelerations = stepper.accelerometers().take(state);
  history_->write(model_, {state, audit, stepper.contact_report(), wall_force, pair_work, walls, forces, accelerations,
                           stepper.find_limiting_approach(state) != nullptr});
  last_row_ = state.step;
}

void RunOutput::write_frame(const State& state) {
  if (!frames_ || last_frame_ == state.step) return;
  frames_->write(state);
  if (history_) history_->flush();
  last_frame_ = state.step;
}

void RunOutput::keep_frame(const State& state) {
  const auto every = deck_.output.fields_before_failure;
  if (frames_ && every && state.step % *every == 0) frames_->keep(state);
}

void RunOutput::write_kept_frames(const State& failed) {
  if (frames_) frames_->write_kept(last_frame_, failed.step);
}

void RunOutput::advance(double time) {
  rows_.advance(time);
  frames_due_.advance(time);
}

void RunOutput::note_lengths() {
  history_bytes_ = history_ ? history_->find_length() : no_file;
  frame_count_ = frames_ ? frames_->count() : no_file;
}

void RunOutput::sync() {
  if (history_) history_->sync();
  if (frames_) frames_->sync();
}

void RunOutput::archive(CheckpointArchive& archive, double time) {
  rows_.archive(archive, "output/history", time);
  frames_due_.archive(archive, "output/fields", time);
  archive.number("output/history/last_step", last_row_);
  archive.number("output/fields/last_step", last_frame_);
  archive.number("output/history/bytes", history_bytes_);
  archive.number("output/fields/frames", frame_count_);
}

void RunOutput::close() {
  if (frames_) frames_->close();
  if (history_) history_->close();
}

bool RunOutput::are_files_in_place() const {
  const bool rows = !history_ || history_->is_in_place(), frames = !frames_ || frames_->is_in_place();
  return rows && frames;
}

}  // namespace percuss
