#include "src/step/results/fields/frames.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/named_sets.hpp"
#include "src/output/formats/frame_formats.hpp"
#include "src/step/results/fields/element_fields.hpp"
#include "src/step/results/fields/frame_values.hpp"

namespace percuss {

namespace {

bool has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The fields of every frame. The file always has the displacement and, where elements can die, who lives: without it
/// what is dead would look like the rest.
std::vector<std::string> list_field_names(const FieldsDeck& fields, const Model& model) {
  std::vector<std::string> names = fields.write;
  if (!has(names, "displacement")) names.push_back("displacement");
  if (model.can_erode && !has(names, "alive")) names.push_back("alive");
  return names;
}

WallPlane make_wall_plane(const WallDeck& wall) {
  WallPlane plane{wall.point, wall.normal, {}};
  if (!wall.rectangle) return plane;
  const auto& [along, size] = *wall.rectangle;
  const Vec3 across = cross(wall.normal, along);
  for (std::size_t k = 0; k < 3; ++k) {
    plane.edges[0][k] = size[0] * along[k];
    plane.edges[1][k] = size[1] * across[k];
  }
  return plane;
}

RoundWall make_round_wall(const WallDeck& wall) {
  RoundWall made{wall.point, {}, 0, 0, wall.direction};
  if (wall.cylinder) made.axis = wall.cylinder->axis;
  made.radius = wall.cylinder ? wall.cylinder->radius : wall.sphere->radius;
  made.length = wall.cylinder ? wall.cylinder->length.value_or(0) : 0;
  return made;
}

/// Walls that move, planes first, by their places among all that move.
std::vector<std::size_t> list_drawn_walls(const Deck& deck) {
  std::vector<std::size_t> planes, round;
  for (const WallDeck& wall : deck.walls)
    if (wall.moves()) (wall.is_round() ? round : planes).push_back(planes.size() + round.size());
  planes.insert(planes.end(), round.begin(), round.end());
  return planes;
}

FieldsOptions make_options(const FrameScene& scene, const FieldsDeck& fields, const FieldRegion* region) {
  const Deck& deck = scene.deck;
  FieldsOptions options{.title = deck.title, .units = deck.units, .name = fields.name};
  options.are_faces = region != nullptr && region->are_faces;
  for (const WallDeck& wall : deck.walls) {
    if (wall.is_round()) {
      (wall.moves() ? options.moving_round_walls : options.round_walls).push_back(make_round_wall(wall));
      continue;
    }
    (wall.moves() ? options.moving_walls : options.walls).push_back(make_wall_plane(wall));
  }
  const std::vector<const FrameFormat*> formats = list_formats(fields);
  if (std::none_of(formats.begin(), formats.end(), [](const FrameFormat* format) { return format->wants_sets; }))
    return options;
  NamedSets sets = find_named_sets(deck, scene.chunked.mesh);
  options.node_sets = std::move(sets.of_nodes);
  options.side_sets = std::move(sets.of_sides);
  return options;
}

}  // namespace

Frames::Frames(const FrameScene& scene, const FieldsDeck& fields, const FieldRegion* region)
    : model_(scene.model),
      contact_(scene.contact),
      region_(region),
      names_(list_field_names(fields, scene.model)),
      drawn_walls_(list_drawn_walls(scene.deck)) {
  note_constant_fields(scene.chunked);
}

void Frames::create(const FrameScene& scene, const FieldsDeck& fields) {
  const FieldsOptions options = make_options(scene, fields, region_);
  const FrameTarget target{scene.directory, find_shown(scene, region_), options, model_.ranks};
  for (const FrameFormat* format : list_formats(fields)) writers_.push_back(format->create(target));
}

void Frames::go_on(const FrameScene& scene, const FieldsDeck& fields, std::int64_t frames) {
  const FieldsOptions options = make_options(scene, fields, region_);
  const FrameTarget target{scene.directory, find_shown(scene, region_), options, model_.ranks};
  for (const FrameFormat* format : list_formats(fields)) writers_.push_back(format->resume(target, frames, names_));
  count_ = frames;
}

void Frames::check(const FrameScene& scene, const FieldsDeck& fields, const FieldRegion* region, std::int64_t frames) {
  const std::vector<std::string> names = list_field_names(fields, scene.model);
  const EarlierFrames earlier{scene.directory, fields.name, frames, names};
  for (const FrameFormat* format : list_formats(fields))
    check_earlier_frames(*format, earlier, find_shown(scene, region), scene.model.ranks);
}

void Frames::sync() {
  for (const auto& writer : writers_) writer->sync();
}

void Frames::close() {
  for (const auto& writer : writers_) writer->close();
}

bool Frames::is_in_place() const {
  bool all = true;
  for (const auto& writer : writers_) all = writer->is_in_place() && all;  // collective: every one is asked
  return all;
}

void Frames::note_constant_fields(const ChunkedMesh& chunked) {
  if (has(names_, "body")) {
    body_.assign(chunked.mesh.bodies.begin(), chunked.mesh.bodies.end());
    choose_elements(body_);
  }
  if (has(names_, "chunk")) {
    chunk_.resize(chunked.mesh.elements.size());
    for (const Chunk& chunk : chunked.chunks) {
      const auto first = chunk_.begin() + chunk.first_element;
      std::fill(first, first + chunk.element_count, static_cast<double>(chunk.number));
    }
    choose_elements(chunk_);
  }
}

/// Leaves those of the region.
void Frames::choose_elements(std::vector<double>& values) const {
  if (region_ == nullptr) return;
  std::vector<double> chosen;
  for (const int element : region_->elements) chosen.push_back(values[static_cast<std::size_t>(element)]);
  values = std::move(chosen);
}

Frames::Frame Frames::collect(const State& state) const {
  Frame frame;
  frame.time = state.time;
  frame.step = state.step;
  FrameSource source{model_, state, contact_, region_, body_, chunk_};
  if (has(names_, "stress") || has(names_, "pressure") || has(names_, "von_mises"))
    source.stresses = find_stresses(model_, state, source.elements());
  for (const std::string& name : names_) {
    if (name == "displacement") continue;  // the file always has it
    FieldData field;
    std::vector<double> found = find_field(name, source, field);
    field.values = frame.values.emplace(name, std::move(found)).first->second;
    frame.fields.push_back(field);
  }
  frame.positions = list_rows(state.x, source.nodes());
  const std::vector<double> motions = contact_.list_wall_motions();  // displacement and speed of each
  for (const std::size_t i : drawn_walls_) frame.walls.push_back(motions[2 * i]);
  return frame;
}

void Frames::put(const Frame& frame) {
  const std::span<const double> positions(frame.positions);
  for (const auto& writer : writers_) writer->write_frame(frame.time, frame.step, positions, frame.fields, frame.walls);
  ++count_;
}

void Frames::keep(const State& state) {
  if (kept_.size() == 2) kept_.erase(kept_.begin());
  kept_.push_back(collect(state));
}

void Frames::write_kept(std::int64_t after_step, std::int64_t before_step) {
  for (const Frame& frame : kept_)
    if (frame.step > after_step && frame.step < before_step) put(frame);
  kept_.clear();
}

}  // namespace percuss
