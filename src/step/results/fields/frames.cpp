#include "src/step/results/fields/frames.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/named_sets.hpp"
#include "src/step/results/fields/element_fields.hpp"

namespace percuss {

namespace {

std::vector<double> list_rows(const Rows3<double>& rows) {
  const auto host = to_host(rows);
  return {host.data(), host.data() + host.extent(0) * 3};
}

bool has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The fields of every frame. The file always has the displacement and, where elements can die, who lives: without it
/// what is dead would look like the rest.
std::vector<std::string> list_fields(const Deck& deck, const Model& model) {
  std::vector<std::string> fields = deck.output.fields;
  if (!has(fields, "displacement")) fields.push_back("displacement");
  if (model.can_erode && !has(fields, "alive")) fields.push_back("alive");
  return fields;
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

FieldsOptions make_options(const Deck& deck, const Mesh& mesh) {
  FieldsOptions options{.title = deck.title, .units = deck.units};
  for (const WallDeck& wall : deck.walls) {
    if (wall.is_round()) {
      (wall.moves() ? options.moving_round_walls : options.round_walls).push_back(make_round_wall(wall));
      continue;
    }
    (wall.moves() ? options.moving_walls : options.walls).push_back(make_wall_plane(wall));
  }
  if (!deck.output.has_format(FieldsFormat::exodus)) return options;
  NamedSets sets = find_named_sets(deck, mesh);
  options.node_sets = std::move(sets.of_nodes);
  options.side_sets = std::move(sets.of_sides);
  return options;
}

}  // namespace

Frames::Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
               const ContactStage& contact)
    : model_(model), contact_(contact), names_(list_fields(deck, model)), drawn_walls_(list_drawn_walls(deck)) {
  const FieldsOptions options = make_options(deck, chunked.mesh);
  if (deck.output.has_format(FieldsFormat::vtkhdf)) vtkhdf_.emplace(directory, chunked, options, model.ranks);
  if (deck.output.has_format(FieldsFormat::exodus)) exodus_.emplace(directory, chunked, options, model.ranks);
  note_constant_fields(chunked);
}

Frames::Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
               const ContactStage& contact, std::int64_t frames)
    : model_(model),
      contact_(contact),
      names_(list_fields(deck, model)),
      drawn_walls_(list_drawn_walls(deck)),
      count_(frames) {
  const FieldsOptions options = make_options(deck, chunked.mesh);
  if (deck.output.has_format(FieldsFormat::vtkhdf))
    vtkhdf_.emplace(directory, chunked, options, model.ranks, frames, names_);
  if (deck.output.has_format(FieldsFormat::exodus))
    exodus_.emplace(directory, chunked, options, model.ranks, frames, names_);
  note_constant_fields(chunked);
}

void Frames::check(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                   std::int64_t frames) {
  const std::vector<std::string> fields = list_fields(deck, model);
  if (deck.output.has_format(FieldsFormat::vtkhdf)) FieldsFile::check(directory, chunked, model.ranks, frames, fields);
  if (deck.output.has_format(FieldsFormat::exodus))
    ExodusResults::check(directory, chunked, model.ranks, frames, fields);
}

void Frames::sync() {
  if (vtkhdf_) vtkhdf_->sync();
  if (exodus_) exodus_->sync();
}

void Frames::close() {
  if (vtkhdf_) vtkhdf_->close();
  if (exodus_) exodus_->close();
}

bool Frames::is_in_place() const {
  const bool vtkhdf = !vtkhdf_ || vtkhdf_->is_in_place(), exodus = !exodus_ || exodus_->is_in_place();
  return vtkhdf && exodus;
}

void Frames::note_constant_fields(const ChunkedMesh& chunked) {
  if (has(names_, "body")) {
    body_.assign(chunked.mesh.bodies.begin(), chunked.mesh.bodies.end());
  }
  if (has(names_, "chunk")) {
    chunk_.resize(chunked.mesh.elements.size());
    for (const Chunk& chunk : chunked.chunks) {
      const auto first = chunk_.begin() + chunk.first_element;
      std::fill(first, first + chunk.element_count, static_cast<double>(chunk.number));
    }
  }
}

namespace {

/// From what the fields of a frame are made.
struct FrameSource {
  const Model& model;
  const State& state;
  const ContactStage& contact;
  const std::vector<double>&body, &chunk;
  std::vector<double> stresses;  // where a field asks for them
};

std::vector<double> find_contact_forces(const State& state) {
  std::vector<double> force = list_rows(state.impulse);
  for (double& f : force) f = state.dt > 0 ? f / state.dt : 0;
  return force;
}

std::vector<double> find_masses(const State& state) {
  const auto mass = to_host(state.mass);
  return {mass.data(), mass.data() + mass.extent(0)};
}

std::vector<double> find_fe_ranks(const Model& model) {
  return std::vector<double>(static_cast<std::size_t>(model.element_count), model.ranks.rank());
}

/// A field by its name, and how to find it.
struct FrameField {
  const char* name;
  FieldPlace place;
  int components;
  std::vector<double> (*find)(const FrameSource& of);
  FieldNumber number = FieldNumber::real;
};

constexpr FrameField frame_fields[] = {
    {"velocity", FieldPlace::node, 3, [](const FrameSource& of) { return list_rows(of.state.v); }},
    {"contact_force", FieldPlace::node, 3, [](const FrameSource& of) { return find_contact_forces(of.state); }},
    {"contact_pressure", FieldPlace::node, 1,
     [](const FrameSource& of) { return of.contact.find_pressures(of.state.x, of.state.dt); }},
    {"mass", FieldPlace::node, 1, [](const FrameSource& of) { return find_masses(of.state); }},
    {"stress", FieldPlace::element, 6, [](const FrameSource& of) { return of.stresses; }},
    {"pressure", FieldPlace::element, 1, [](const FrameSource& of) { return find_pressures(of.stresses); }},
    {"von_mises", FieldPlace::element, 1, [](const FrameSource& of) { return find_von_mises(of.stresses); }},
    {"equivalent_plastic_strain", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_plastic_strains(of.model, of.state); }},
    {"temperature", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_history(of.model, of.state, HistoryScalar::temperature); }},
    {"internal_energy", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_history(of.model, of.state, HistoryScalar::internal_energy); }},
    {"alive", FieldPlace::element, 1, [](const FrameSource& of) { return find_alive(of.model, of.state); },
     FieldNumber::byte},
    {"damage", FieldPlace::element, 1, [](const FrameSource& of) { return find_damage(of.model, of.state); }},
    {"stress_bottom", FieldPlace::element, 6,
     [](const FrameSource& of) { return find_point_stresses(of.model, of.state, ShellPoint::lowest); }},
    {"stress_top", FieldPlace::element, 6,
     [](const FrameSource& of) { return find_point_stresses(of.model, of.state, ShellPoint::highest); }},
    {"thickness", FieldPlace::element, 1, [](const FrameSource& of) { return find_thicknesses(of.model, of.state); }},
    {"axial_force", FieldPlace::element, 1,
     [](const FrameSource& of) { return find_axial_forces(of.model, of.state); }},
    {"section_force", FieldPlace::element, 3,
     [](const FrameSource& of) { return find_section_forces(of.model, of.state); }},
    {"section_moment", FieldPlace::element, 3,
     [](const FrameSource& of) { return find_section_moments(of.model, of.state); }},
    {"body", FieldPlace::element, 1, [](const FrameSource& of) { return of.body; }},
    {"chunk", FieldPlace::element, 1, [](const FrameSource& of) { return of.chunk; }},
    {"fe_rank", FieldPlace::element, 1, [](const FrameSource& of) { return find_fe_ranks(of.model); }},
    {"contact_rank", FieldPlace::node, 1, [](const FrameSource& of) { return of.contact.contact_ranks(); }},
};

/// Finds the values of a field. field: out, without them.
std::vector<double> find_field(const std::string& name, const FrameSource& of, FieldData& field) {
  for (const FrameField& known : frame_fields) {
    if (name != known.name) continue;
    field = {name, known.place, known.components, {}, known.number};
    return known.find(of);
  }
  field = {name, FieldPlace::element, 6, {}};
  if (const auto stress = find_thickness_point(name, stress_points))
    return find_point_stresses(of.model, of.state, *stress - 1);
  field.components = 1;
  if (const auto strain = find_thickness_point(name, plastic_strain_points))
    return find_point_plastic_strains(of.model, of.state, *strain - 1);
  throw std::logic_error("no field is called '" + name + "' (the deck reader lets it through)");
}

}  // namespace

Frames::Frame Frames::collect(const State& state) const {
  Frame frame;
  frame.time = state.time;
  frame.step = state.step;
  FrameSource source{model_, state, contact_, body_, chunk_, {}};
  if (has(names_, "stress") || has(names_, "pressure") || has(names_, "von_mises"))
    source.stresses = find_stresses(model_, state);
  for (const std::string& name : names_) {
    if (name == "displacement") continue;  // the file always has it
    FieldData field;
    std::vector<double> found = find_field(name, source, field);
    field.values = frame.values.emplace(name, std::move(found)).first->second;
    frame.fields.push_back(field);
  }
  frame.positions = list_rows(state.x);
  const std::vector<double> motions = contact_.list_wall_motions();  // displacement and speed of each
  for (const std::size_t i : drawn_walls_) frame.walls.push_back(motions[2 * i]);
  return frame;
}

void Frames::put(const Frame& frame) {
  const std::span<const double> positions(frame.positions);
  if (vtkhdf_) vtkhdf_->write_frame(frame.time, frame.step, positions, frame.fields, frame.walls);
  if (exodus_) exodus_->write_frame(frame.time, frame.step, positions, frame.fields);
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
