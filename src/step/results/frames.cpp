#include "src/step/results/frames.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "kernels/core/host_copy.hpp"
#include "src/step/results/element_fields.hpp"

namespace percuss {

namespace {

std::vector<double> copy_rows(const Rows3<double>& rows) {
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

FieldsOptions make_options(const Deck& deck) {
  FieldsOptions options{.title = deck.title, .units = deck.units};
  for (const WallDeck& wall : deck.walls) options.walls.push_back({wall.point, wall.normal});
  return options;
}

}  // namespace

Frames::Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
               const ContactStage& contact)
    : model_(model),
      contact_(contact),
      names_(list_fields(deck, model)),
      file_(directory, chunked, make_options(deck), model.ranks) {
  note_constant_fields(chunked);
}

Frames::Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
               const ContactStage& contact, std::int64_t frames)
    : model_(model),
      contact_(contact),
      names_(list_fields(deck, model)),
      file_(directory, chunked, make_options(deck), model.ranks, frames, names_),
      count_(frames) {
  note_constant_fields(chunked);
}

void Frames::check(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                   std::int64_t frames) {
  FieldsFile::check(directory, chunked, model.ranks, frames, list_fields(deck, model));
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

void Frames::write(const State& state) {
  std::map<std::string, std::vector<double>> values;  // keeps what the frame's spans point to
  std::vector<double> stresses;
  if (has(names_, "stress") || has(names_, "pressure") || has(names_, "von_mises")) {
    stresses = find_stresses(model_, state);
  }
  std::vector<FieldData> frame;
  const auto add = [&](const std::string& name, FieldPlace place, int components, std::vector<double> data) {
    const auto entry = values.emplace(name, std::move(data)).first;
    frame.push_back({name, place, components, entry->second});
  };
  for (const std::string& name : names_) {
    if (name == "displacement") continue;  // the file always has it
    if (name == "velocity") {
      add(name, FieldPlace::node, 3, copy_rows(state.v));
    } else if (name == "contact_force") {
      std::vector<double> force = copy_rows(state.impulse);
      for (double& f : force) f = state.dt > 0 ? f / state.dt : 0;
      add(name, FieldPlace::node, 3, std::move(force));
    } else if (name == "mass") {
      const auto mass = to_host(state.mass);
      add(name, FieldPlace::node, 1, {mass.data(), mass.data() + mass.extent(0)});
    } else if (name == "stress") {
      add(name, FieldPlace::element, 6, stresses);
    } else if (name == "pressure") {
      add(name, FieldPlace::element, 1, find_pressures(stresses));
    } else if (name == "von_mises") {
      add(name, FieldPlace::element, 1, find_von_mises(stresses));
    } else if (name == "equivalent_plastic_strain") {
      add(name, FieldPlace::element, 1, find_plastic_strains(model_, state));
    } else if (name == "temperature") {
      add(name, FieldPlace::element, 1, find_history(model_, state, HistoryScalar::temperature));
    } else if (name == "internal_energy") {
      add(name, FieldPlace::element, 1, find_history(model_, state, HistoryScalar::internal_energy));
    } else if (name == "alive") {
      add(name, FieldPlace::element, 1, find_alive(model_, state));
      frame.back().number = FieldNumber::byte;
    } else if (name == "damage") {
      add(name, FieldPlace::element, 1, find_damage(model_, state));
    } else if (name == "stress_bottom") {
      add(name, FieldPlace::element, 6, find_point_stresses(model_, state, ShellPoint::lowest));
    } else if (name == "stress_top") {
      add(name, FieldPlace::element, 6, find_point_stresses(model_, state, ShellPoint::highest));
    } else if (const auto stress = find_thickness_point(name, stress_points)) {
      add(name, FieldPlace::element, 6, find_point_stresses(model_, state, *stress - 1));
    } else if (const auto strain = find_thickness_point(name, plastic_strain_points)) {
      add(name, FieldPlace::element, 1, find_point_plastic_strains(model_, state, *strain - 1));
    } else if (name == "thickness") {
      add(name, FieldPlace::element, 1, find_thicknesses(model_, state));
    } else if (name == "body") {
      add(name, FieldPlace::element, 1, body_);
    } else if (name == "chunk") {
      add(name, FieldPlace::element, 1, chunk_);
    } else if (name == "fe_rank") {
      add(name, FieldPlace::element, 1,
          std::vector<double>(static_cast<std::size_t>(model_.element_count), model_.ranks.rank()));
    } else if (name == "contact_rank") {
      add(name, FieldPlace::node, 1, contact_.contact_ranks());
    } else {
      throw std::logic_error("no field is called '" + name + "' (the deck reader lets it through)");
    }
  }
  const auto x = to_host(state.x);
  file_.write_frame(state.time, state.step, {x.data(), x.extent(0) * 3}, frame);
  ++count_;
}

}  // namespace percuss
