#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/assembly/build_conditions.hpp"
#include "src/step/loads/blast_pressure.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Force on each corner of a face by unit pressure along a direction: a quarter of the area.
Vec3 find_dead_share(const Mesh& mesh, const std::array<int, 4>& nodes, const Vec3& direction) {
  const auto corner = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(nodes[i])]; };
  const Vec3 twice = cross(subtract(corner(2), corner(0)), subtract(corner(3), corner(1)));
  const double quarter = 0.125 * std::sqrt(twice[0] * twice[0] + twice[1] * twice[1] + twice[2] * twice[2]);
  return {quarter * direction[0], quarter * direction[1], quarter * direction[2]};
}

/// The slots of the chunks, which come first in the sum of a node.
LocalSlots list_chunk_slots(const ChunkedMesh& chunked, const Model& model) {
  const auto nodes = to_host(model.chunks.slots_to_nodes);
  const auto first_slot = to_host(model.chunks.first_slot);
  LocalSlots slots{{nodes.data(), nodes.data() + nodes.extent(0)}, std::vector<std::int64_t>(nodes.extent(0))};
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    std::fill(slots.orders.begin() + first_slot(c), slots.orders.begin() + first_slot(c + 1), chunked.chunks[c].number);
  }
  return slots;
}

/// Takes the least of the values of all ranks, one by one.
void find_least(const Mesh& mesh, std::vector<int>& values) {
  if (!mesh.ranks) return;
  all_reduce(*mesh.ranks, Reduce::least, values);
}

/// The first part of the deck of whose shells, on any rank, both sides are among the faces; as many as there are
/// parts: none. Faces ascending.
std::size_t find_part_with_both_sides(const Mesh& mesh, const std::vector<ElementFace>& faces) {
  std::vector<int> first{static_cast<int>(mesh.parts.size())};
  for (std::size_t i = 1; i < faces.size(); ++i) {
    const auto element = static_cast<std::size_t>(faces[i].element);
    if (faces[i - 1].element == faces[i].element && mesh.topology_of(element).is_surface())
      first[0] = std::min(first[0], mesh.part_of(element));
  }
  find_least(mesh, first);
  return static_cast<std::size_t>(first[0]);
}

/// Sets of a part that have faces on any rank; the edges of shells have none.
std::string list_sides(const Mesh& mesh, const std::string& part) {
  std::vector<int> is_empty;
  for (const auto& [name, faces] : mesh.side_sets) is_empty.push_back(faces.empty() ? 1 : 0);
  find_least(mesh, is_empty);
  std::string sides;
  auto empty = is_empty.begin();
  for (const auto& [name, faces] : mesh.side_sets) {
    if (*empty++ == 0 && name.starts_with(part + "/")) sides += (sides.empty() ? "" : ", ") + name;
  }
  return sides;
}

/// Throws, on all ranks, if a load takes shells from both sides: it would cancel, and a dead load would count twice.
void require_one_side(const Deck& deck, const Mesh& mesh, const PressureDeck& pressure,
                      const std::vector<ElementFace>& faces) {
  const std::size_t part = find_part_with_both_sides(mesh, faces);
  if (part == mesh.parts.size()) return;
  const std::string sides = list_sides(mesh, mesh.parts[part].name);
  throw InputError(
      fmt::format("{}: error: the pressure acts on both sides of the shells of part '{}' ({}): name one side: {}",
                  deck.where(pressure.where.place), mesh.parts[part].name,
                  pressure.direction ? "it would count them twice" : "on which it cancels", sides));
}

/// The curve of a load, or those of a blast on each of its faces.
void add_pressures(const Deck& deck, const PressureDeck& pressure, const ChunkedMesh& chunked,
                   const std::vector<ElementFace>& faces, Model& model) {
  if (pressure.blast) require_blast_range(deck, pressure, chunked, faces);
  if (pressure.blast)
    for (const Pulse& pulse : list_blast_pulses(deck, pressure, chunked.mesh, faces))
      model.pressures.push_back(Curve::pulse(pulse));
  else
    model.pressures.push_back(pressure.value);
  model.pressure_entries.resize(model.pressures.size(), static_cast<int>(&pressure - deck.pressures.data()));
}

/// Where faces of another entry of the deck or of another chunk begin.
struct RunList {
  std::vector<int> first;
  int entry = -1, chunk = -1;

  void note(int of_entry, int of_chunk, int face) {
    if (of_entry == entry && of_chunk == chunk) return;
    entry = of_entry;
    chunk = of_chunk;
    first.push_back(face);
  }
};

/// Place of the chunk that has an element.
int find_chunk(const ChunkedMesh& chunked, int element) {
  const auto after = std::upper_bound(chunked.chunks.begin(), chunked.chunks.end(), element,
                                      [](int e, const Chunk& chunk) { return e < chunk.first_element; });
  return static_cast<int>(after - chunked.chunks.begin()) - 1;
}

}  // namespace

LocalSlots build_pressure_faces(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  const Mesh& mesh = chunked.mesh;
  const Numbering& numbering = chunked.numbering;
  LocalSlots slots = list_chunk_slots(chunked, model);
  PressureFaces& faces = model.pressure_faces;
  faces.first_slot = static_cast<int>(slots.nodes.size());
  std::vector<std::array<int, 4>> corners;
  std::vector<int> loads;
  std::vector<Vec3> dead_shares;
  RunList runs;
  for (const PressureDeck& pressure : deck.pressures) {
    const auto entry = &pressure - deck.pressures.data();
    const std::vector<ElementFace> selected = select_faces(mesh, deck, pressure.where);
    require_one_side(deck, mesh, pressure, selected);
    const auto first_load = static_cast<int>(model.pressures.size()), first_face = static_cast<int>(corners.size());
    add_pressures(deck, pressure, chunked, selected, model);
    for (const ElementFace& face : selected) {
      runs.note(static_cast<int>(entry), find_chunk(chunked, face.element), static_cast<int>(corners.size()));
      const std::int64_t order =
          numbering.chunk_count() +
          find_face_number(entry * numbering.element_count() + find_element_number(chunked, face.element), face.face);
      const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
      slots.nodes.insert(slots.nodes.end(), nodes.begin(), nodes.end());
      slots.orders.insert(slots.orders.end(), nodes.size(), order);
      corners.push_back(nodes);
      loads.push_back(first_load + (pressure.blast ? static_cast<int>(corners.size()) - first_face - 1 : 0));
      dead_shares.push_back(pressure.direction ? find_dead_share(mesh, nodes, *pressure.direction) : Vec3{});
    }
  }
  faces.count = static_cast<int>(corners.size());
  faces.load = to_view("percuss::pressure_load", loads);
  faces.run_count = static_cast<int>(runs.first.size());
  runs.first.push_back(faces.count);
  faces.first_of_run = to_view("percuss::pressure_runs", runs.first);
  faces.nodes = to_rows("percuss::pressure_nodes", corners);
  faces.dead_share = to_rows("percuss::pressure_dead_share", dead_shares);
  return slots;
}

}  // namespace percuss
