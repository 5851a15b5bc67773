#include "src/step/results/fields/field_output.hpp"

#include "src/output/formats/frame_formats.hpp"

namespace percuss {

FieldOutput::FieldOutput(const FrameScene& scene, const FieldsDeck& fields)
    : scene_(scene),
      fields_(fields),
      region_(find_field_region(scene.deck, fields, scene.chunked, scene.model.ranks)),
      frames_due_(fields.every) {}

void FieldOutput::create() {
  if (!wants()) return;
  frames_.emplace(scene_, fields_, region_.get());
  frames_->create(scene_, fields_);
}

void FieldOutput::check_earlier() const {
  if (wants() && frame_count_ != no_file) Frames::check(scene_, fields_, region_.get(), frame_count_);
}

CutFrames FieldOutput::find_later() const {
  const FrameLayout& layout = list_formats(fields_).front()->layout;  // all have the same frames
  CutFrames cut{layout.name_file(fields_.name), {}};
  if (wants()) cut.frames = find_later_frames(layout, scene_.directory + "/" + cut.file, frame_count_);
  return cut;
}

void FieldOutput::go_on() {
  if (!wants() || frame_count_ == no_file) return create();
  frames_.emplace(scene_, fields_, region_.get());
  frames_->go_on(scene_, fields_, frame_count_);
}

bool FieldOutput::write(const State& state) {
  if (!frames_ || last_frame_ == state.step) return false;
  frames_->write(state);
  last_frame_ = state.step;
  return true;
}

void FieldOutput::keep(const State& state) {
  if (frames_ && fields_.before_failure && state.step % *fields_.before_failure == 0) frames_->keep(state);
}

void FieldOutput::write_kept(const State& failed) {
  if (frames_) frames_->write_kept(last_frame_, failed.step);
}

int FieldOutput::count_lost(const State& failed, std::int64_t start) const {
  if (!frames_ || !fields_.before_failure) return 0;
  const std::int64_t every = *fields_.before_failure, newest = (failed.step - 1) / every * every;
  int lost = 0;
  for (const std::int64_t step : {newest, newest - every})
    lost += step > last_frame_ && step > 0 && step < start ? 1 : 0;
  return lost;
}

void FieldOutput::note_length() { frame_count_ = frames_ ? frames_->count() : no_file; }

void FieldOutput::sync() {
  if (frames_) frames_->sync();
}

void FieldOutput::archive(CheckpointArchive& archive, double time) {
  const std::string name = fields_.name.empty() ? "output/fields" : "output/field_outputs/" + fields_.name;
  frames_due_.archive(archive, name, time);
  if (!archive.has_number(name + "/frames")) return;
  archive.number(name + "/last_step", last_frame_);
  archive.number(name + "/frames", frame_count_);
}

void FieldOutput::close() {
  if (frames_) frames_->close();
}

}  // namespace percuss
