#include "src/step/elements/build_chunks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/hex8/fold_resistance.hpp"
#include "src/deck/laws/laminates.hpp"
#include "src/deck/laws/make_material.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/elements/block_builder.hpp"
#include "src/step/elements/build_beams.hpp"
#include "src/step/elements/build_shells.hpp"
#include "src/step/elements/thick_corners.hpp"
#include "src/step/model/element_blocks.hpp"

namespace percuss {
namespace {

/// Fills the chunk tables: slots by first use within the chunk, corners as 16-bit slots, lane by lane.
struct ChunkTables {
  std::vector<int> first_element{0}, first_slot{0}, first_pack{0}, slots_to_nodes;
  std::vector<std::uint16_t> corner_slots;
  int largest_slot_count = 0;
};

void add_chunk(const Deck& deck, const Mesh& mesh, const Chunk& chunk, std::vector<int>& slot_of_node,
               ChunkTables& tables) {
  const int first_slot = tables.first_slot.back();
  const auto find_slot = [&](int node) {
    int& slot = slot_of_node[static_cast<std::size_t>(node)];
    if (slot < first_slot) {
      slot = static_cast<int>(tables.slots_to_nodes.size());
      tables.slots_to_nodes.push_back(node);
    }
    return static_cast<std::uint16_t>(slot - first_slot);
  };
  const int packs = (chunk.element_count + pack_width - 1) / pack_width;
  const int first_pack = tables.first_pack.back();
  tables.corner_slots.resize(find_corner_place(first_pack + packs, 0, 0));
  for (int i = 0; i < packs * pack_width; ++i) {
    const int element = chunk.first_element + std::min(i, chunk.element_count - 1);
    const auto nodes = find_kernel_nodes(deck, mesh, static_cast<std::size_t>(element));
    for (int corner = 0; corner < 8; ++corner)
      tables.corner_slots[find_corner_place(first_pack, i, corner)] =
          find_slot(nodes[static_cast<std::size_t>(corner)]);
  }
  tables.first_element.push_back(chunk.first_element + chunk.element_count);
  tables.first_slot.push_back(static_cast<int>(tables.slots_to_nodes.size()));
  tables.first_pack.push_back(tables.first_pack.back() + packs);
  tables.largest_slot_count = std::max(tables.largest_slot_count, tables.first_slot.back() - first_slot);
}

ChunkTables make_chunk_tables(const Deck& deck, const ChunkedMesh& chunked) {
  ChunkTables tables;
  std::vector<int> slot_of_node(chunked.mesh.nodes.size(), -1);
  for (const Chunk& chunk : chunked.chunks) add_chunk(deck, chunked.mesh, chunk, slot_of_node, tables);
  return tables;
}

/// Share of the volume of the sharpest corner of a hexahedron at the start.
double find_sharpest_corner(const Mesh& mesh, std::size_t element) {
  const auto corners = gather_corners(mesh.elements, element, mesh.nodes);
  double u[3][8];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 8; ++i) u[k][i] = corners[i][k];
    to_modes(u[k]);
  }
  VectorModes<double> a;
  for (int m = 1; m <= 7; ++m) a[m] = {u[0][m], u[1][m], u[2][m]};
  return find_smallest_share(find_corner_shares(find_edges(a), find_volume_gradient(a).volume));
}

/// Thresholds below which corners resist, well below the sharpest corner of the chunk at the start, so that nothing
/// acts on a mesh at rest. A chunk with an inverted corner has none.
std::vector<Real> find_fold_thresholds(const ChunkedMesh& chunked) {
  std::vector<Real> thresholds(chunked.chunks.size());
  for (std::size_t c = 0; c < thresholds.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    if (find_topology(find_block(chunked, chunk).topology).family != ElementFamily::hexahedra) continue;
    double least = 1;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      least = std::min(least, find_sharpest_corner(chunked.mesh, static_cast<std::size_t>(e)));
    }
    thresholds[c] = static_cast<Real>(std::clamp(fold_threshold_share * least, 0.0, largest_fold_threshold));
  }
  return thresholds;
}

/// Gives the records of each chunk their place. Returns the first scalar of each.
std::vector<std::size_t> place_records(const ChunkTables& tables, const std::vector<int>& record_size, Model& model) {
  std::vector<std::size_t> first_state(record_size.size());
  for (std::size_t c = 0; c < first_state.size(); ++c) {
    first_state[c] = model.state_size;
    const int packs = tables.first_pack[c + 1] - tables.first_pack[c];
    model.state_size += find_record_place(packs * pack_width, record_size[c]);
  }
  return first_state;
}

std::vector<ElementFamily> list_families(const ChunkedMesh& chunked) {
  std::vector<ElementFamily> families;
  for (const Chunk& chunk : chunked.chunks)
    families.push_back(find_topology(find_block(chunked, chunk).topology).family);
  return families;
}

/// Refuses what only shells have. On all ranks alike: they know all blocks.
void refuse_plies(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    const MaterialDeck& material = deck.materials[static_cast<std::size_t>(block.material)];
    const bool is_fabric = find_traits(material).is_of_membranes_alone, is_skin = find_traits(material).is_skin;
    if (find_topology(block.topology).is_surface() || !(is_laminate(material) || is_fabric || is_skin)) continue;
    const PartDeck& part = deck.parts[static_cast<std::size_t>(block.part)];
    const char* what = is_fabric ? "a material of the model fabric"
                       : is_skin ? "a material of the model skin"
                                 : nullptr;
    if (!part.plies.empty()) what = "plies";
    visit_law(material, [&]<class Law>(const Law& law) {
      if constexpr (requires { law.constants.follows_elements; }) {
        if (law.constants.follows_elements) what = "a material with axes: elements";
      }
      if constexpr (requires { law.constants.has_strength(); }) {
        if (law.constants.has_strength()) what = "a material with strengths of plies";
      }
      if constexpr (requires { law.constants.is_quadratic(); }) {
        if (!law.constants.is_quadratic()) what = "a material whose exponent is not 2";
      }
    });
    if (what == nullptr || part.rigid) continue;
    throw InputError(
        fmt::format("{}: error: part '{}' has {} elements and {} (only shells can): make them shells, or "
                    "give them another material",
                    deck.where(part.place), part.name, find_topology(block.topology).name, what));
  }
}

/// Parts that cannot be what they say.
void refuse_parts(const Deck& deck, const Mesh& mesh) {
  refuse_plies(deck, mesh);
  refuse_other_solids(deck, mesh);
}

void take_tables(const ChunkedMesh& chunked, const ChunkTables& tables, ElementChunks& chunks) {
  chunks.count = static_cast<int>(chunked.chunks.size());
  chunks.family = to_view("percuss::family_of_chunk", list_families(chunked));
  chunks.largest_slot_count = tables.largest_slot_count;
  chunks.first_element = to_view("percuss::first_element", tables.first_element);
  chunks.first_slot = to_view("percuss::first_slot", tables.first_slot);
  chunks.slots_to_nodes = to_view("percuss::slots_to_nodes", tables.slots_to_nodes);
  chunks.first_pack = to_view("percuss::first_pack", tables.first_pack);
  chunks.corner_slots = to_view("percuss::corner_slots", tables.corner_slots);
}

std::vector<KernelMaterial> make_materials(const Deck& deck) {
  std::vector<KernelMaterial> materials;
  for (const MaterialDeck& material : deck.materials) materials.push_back(make_kernel_material(material));
  return materials;
}

}  // namespace

void build_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  refuse_parts(deck, chunked.mesh);
  const ChunkTables tables = make_chunk_tables(deck, chunked);
  const std::size_t count = chunked.chunks.size();
  const std::vector<int> empty(count);
  BlockBuilder builder{deck,
                       chunked,
                       make_materials(deck),
                       empty,
                       empty,
                       empty,
                       empty,
                       empty,
                       std::vector<int>(count * history_scalars),
                       std::vector<std::size_t>(count),
                       empty,
                       {}};
  std::apply([&](auto&... block) { (builder.build(block), ...); }, model.others->hexahedra);
  std::apply([&](auto&... block) { (builder.build(block), ...); }, model.others->tetrahedra);
  std::apply([&](auto&... block) { (builder.build(block), ...); }, model.others->one_point);
  build_shell_blocks(deck, chunked,
                     {builder.record_size, builder.history, builder.points, builder.rule, builder.parameters,
                      builder.scalars, builder.first_start, builder.start_count, builder.start_values},
                     model);
  build_beam_block(deck, chunked,
                   {builder.record_size, builder.history, builder.points, builder.parameters, builder.scalars}, model);

  ElementChunks& chunks = model.chunks;
  take_tables(chunked, tables, chunks);
  if (deck.elements.resist_folding)
    chunks.fold_threshold = to_view("percuss::fold_threshold", find_fold_thresholds(chunked));
  chunks.first_state = to_view("percuss::first_state", place_records(tables, builder.record_size, model));
  chunks.parameters = to_view("percuss::parameters_of_chunk", builder.parameters);
  chunks.record_size = to_view("percuss::record_size", builder.record_size);
  chunks.history = to_view("percuss::history", builder.history);
  chunks.points = to_view("percuss::points", builder.points);
  chunks.rule = to_view("percuss::rule_of_chunk", builder.rule);
  model.start_history = {to_view("percuss::first_start", builder.first_start),
                         to_view("percuss::start_count", builder.start_count),
                         to_view("percuss::start_history", builder.start_values)};
  chunks.scalars = to_view("percuss::history_scalars", builder.scalars);
}

void mark_uncomputed_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  std::vector<int> rigid, uncomputed;
  bool has_any = false;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) has_any = has_any || is_uncomputed(deck, p);
  if (!has_any) return;
  for (const Chunk& chunk : chunked.chunks) {
    rigid.push_back(deck.parts[static_cast<std::size_t>(chunk.part)].rigid ? 1 : 0);
    uncomputed.push_back(is_uncomputed_chunk(deck, chunk) ? 1 : 0);
  }
  model.is_rigid_chunk = to_view("percuss::is_rigid_chunk", rigid);
  model.is_uncomputed_chunk = to_view("percuss::is_uncomputed_chunk", uncomputed);
}

}  // namespace percuss
