#include "src/step/results/run_output.hpp"

#include <algorithm>
#include <utility>

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

RunOutput::RunOutput(const Deck& deck, const ChunkedMesh& chunked, const Model& model, const ContactStage& contact,
                     Stepper& stepper, std::string directory)
    : deck_(deck),
      chunked_(chunked),
      model_(model),
      contact_(contact),
      stepper_(stepper),
      directory_(std::move(directory)),
      rows_(deck.output.history_every) {
  for (const FieldsDeck* const fields : deck.output.list_fields())
    fields_.emplace_back(FrameScene{deck, chunked, model, contact, directory_}, *fields);
}

void RunOutput::create() {
  if (wants_rows()) history_.emplace(directory_, history_scene());
  for (FieldOutput& fields : fields_) fields.create();
}

void RunOutput::check_earlier() const {
  if (wants_rows() && history_bytes_ != no_file) History::check(directory_, history_scene(), history_bytes_);
  for (const FieldOutput& fields : fields_) fields.check_earlier();
}

CutStates RunOutput::find_cut_states(const SavedState& from, const SavedState& end) const {
  CutStates cut;
  if (wants_rows()) {
    cut.rows = keep_lost(find_later_rows(directory_ + "/history.csv", history_bytes_), from, end, rows_.is_thinned());
  }
  for (const FieldOutput& fields : fields_) {
    cut.frames.push_back(fields.find_later());
    cut.frames.back().frames = keep_lost(cut.frames.back().frames, from, end, fields.is_thinned());
  }
  return cut;
}

void RunOutput::go_on() {
  if (wants_rows() && history_bytes_ != no_file) {
    history_.emplace(directory_, history_scene(), history_bytes_);
  } else if (wants_rows()) {
    history_.emplace(directory_, history_scene());
  }
  for (FieldOutput& fields : fields_) fields.go_on();
}

void RunOutput::write_row(const State& state, const AuditResult& audit) {
  if (!history_ || last_row_ == state.step) return;
  const Vec3 wall_force = stepper_.find_wall_force();
  const std::vector<double> pair_work = contact_.sum_pair_work();
  history_->write(model_, {state, audit, stepper_.contact_report(), wall_force, pair_work, stepper_,
                           stepper_.find_limiting_approach(state) != nullptr});
  last_row_ = state.step;
}

bool RunOutput::is_frame_due(double time) const {
  return std::any_of(fields_.begin(), fields_.end(), [&](const FieldOutput& fields) { return fields.is_due(time); });
}

template <class IsWanted>
void RunOutput::write_some_frames(const State& state, const IsWanted& is_wanted) {
  bool has_written = false;
  for (FieldOutput& fields : fields_) has_written = (is_wanted(fields) && fields.write(state)) || has_written;
  if (has_written && history_) history_->flush();
}

void RunOutput::write_frames(const State& state) {
  write_some_frames(state, [](const FieldOutput&) { return true; });
}

void RunOutput::write_due_frames(const State& state) {
  write_some_frames(state, [&](const FieldOutput& fields) { return fields.is_due(state.time); });
}

void RunOutput::keep_frames(const State& state) {
  for (FieldOutput& fields : fields_) fields.keep(state);
}

void RunOutput::write_kept_frames(const State& failed) {
  for (FieldOutput& fields : fields_) fields.write_kept(failed);
}

int RunOutput::count_lost_frames(const State& failed, std::int64_t start) const {
  int lost = 0;
  for (const FieldOutput& fields : fields_) lost += fields.count_lost(failed, start);
  return lost;
}

void RunOutput::advance(double time) {
  rows_.advance(time);
  for (FieldOutput& fields : fields_) fields.advance(time);
}

void RunOutput::note_lengths() {
  history_bytes_ = history_ ? history_->find_length() : no_file;
  for (FieldOutput& fields : fields_) fields.note_length();
}

void RunOutput::sync() {
  if (history_) history_->sync();
  for (FieldOutput& fields : fields_) fields.sync();
}

void RunOutput::archive(CheckpointArchive& archive, double time) {
  rows_.archive(archive, "output/history", time);
  archive.number("output/history/last_step", last_row_);
  archive.number("output/history/bytes", history_bytes_);
  for (FieldOutput& fields : fields_) fields.archive(archive, time);
}

void RunOutput::close() {
  for (FieldOutput& fields : fields_) fields.close();
  if (history_) history_->close();
}

bool RunOutput::are_files_in_place() const {
  bool in_place = !history_ || history_->is_in_place();
  for (const FieldOutput& fields : fields_) in_place = fields.are_files_in_place() && in_place;
  return in_place;
}

}  // namespace percuss
