#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <type_traits>
#include <utility>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/element/hex8/fold_resistance.hpp"
#include "src/deck/make_material.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/beams/build_beams.hpp"
#include "src/step/build/block_builder.hpp"
#include "src/step/build/build_conditions.hpp"
#include "src/step/build/build_failing.hpp"
#include "src/step/build/build_shells.hpp"
#include "src/step/build/check_precision.hpp"
#include "src/step/build/mass_scaling.hpp"
#include "src/step/damping/build_damping.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/pack_width.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/build_springs.hpp"
#include "src/step/springs/build_welds.hpp"
#include "src/step/tets/build_tets.hpp"

namespace percuss {

namespace {

// --- chunks

/// Fills the chunk tables: slots by first use within the chunk, corners as 16-bit slots, lane by lane.
struct ChunkTables {
  std::vector<int> first_element{0}, first_slot{0}, first_pack{0}, slots_to_nodes;
  std::vector<std::uint16_t> corner_slots;
  int largest_slot_count = 0;
};

void add_chunk(const Mesh& mesh, const Chunk& chunk, std::vector<int>& slot_of_node, ChunkTables& tables) {
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
  const std::size_t base = tables.corner_slots.size();
  tables.corner_slots.resize(base + static_cast<std::size_t>(packs) * 8 * pack_width);
  for (int i = 0; i < packs * pack_width; ++i) {
    const int element = chunk.first_element + std::min(i, chunk.element_count - 1);
    const auto nodes = mesh.elements.kernel_nodes(static_cast<std::size_t>(element));
    for (int corner = 0; corner < 8; ++corner) {
      const std::size_t place =
          base + (static_cast<std::size_t>(i / pack_width) * 8 + static_cast<std::size_t>(corner)) * pack_width +
          static_cast<std::size_t>(i % pack_width);
      tables.corner_slots[place] = find_slot(nodes[static_cast<std::size_t>(corner)]);
    }
  }
  tables.first_element.push_back(chunk.first_element + chunk.element_count);
  tables.first_slot.push_back(static_cast<int>(tables.slots_to_nodes.size()));
  tables.first_pack.push_back(tables.first_pack.back() + packs);
  tables.largest_slot_count = std::max(tables.largest_slot_count, tables.first_slot.back() - first_slot);
}

ChunkTables make_chunk_tables(const ChunkedMesh& chunked) {
  ChunkTables tables;
  std::vector<int> slot_of_node(chunked.mesh.nodes.size(), -1);
  for (const Chunk& chunk : chunked.chunks) add_chunk(chunked.mesh, chunk, slot_of_node, tables);
  return tables;
}

// --- folding

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
    model.state_size += static_cast<std::size_t>(packs) * static_cast<std::size_t>(record_size[c]) * pack_width;
  }
  return first_state;
}

void take_tables(const ChunkTables& tables, HexChunks& chunks) {
  chunks.largest_slot_count = tables.largest_slot_count;
  chunks.first_element = to_view("percuss::first_element", tables.first_element);
  chunks.first_slot = to_view("percuss::first_slot", tables.first_slot);
  chunks.slots_to_nodes = to_view("percuss::slots_to_nodes", tables.slots_to_nodes);
  chunks.first_pack = to_view("percuss::first_pack", tables.first_pack);
  chunks.corner_slots = to_view("percuss::corner_slots", tables.corner_slots);
}

// --- blocks

void build_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  const ChunkTables tables = make_chunk_tables(chunked);
  const std::size_t count = chunked.chunks.size();
  const std::vector<int> empty(count);
  std::vector<KernelMaterial> materials;
  for (const MaterialDeck& material : deck.materials) materials.push_back(make_kernel_material(material));
  BlockBuilder builder{deck,
                       chunked,
                       std::move(materials),
                       empty,
                       empty,
                       empty,
                       empty,
                       std::vector<int>(count * history_scalars),
                       std::vector<std::size_t>(count),
                       empty,
                       {}};
  std::apply([&](auto&... block) { (builder.build(block), ...); }, model.blocks);
  std::apply([&](auto&... block) { (builder.build(block), ...); }, model.tet_blocks);
  std::apply([&](auto&... block) { (builder.build(block), ...); }, model.one_point_blocks);
  build_shell_blocks(deck, chunked,
                     {builder.record_size, builder.history, builder.points, builder.parameters, builder.scalars,
                      builder.first_start, builder.start_count, builder.start_values},
                     model);
  build_beam_block(deck, chunked,
                   {builder.record_size, builder.history, builder.points, builder.parameters, builder.scalars}, model);

  HexChunks& chunks = model.chunks;
  chunks.count = static_cast<int>(count);
  take_tables(tables, chunks);
  if (deck.elements.resist_folding)
    chunks.fold_threshold = to_view("percuss::fold_threshold", find_fold_thresholds(chunked));
  chunks.first_state = to_view("percuss::first_state", place_records(tables, builder.record_size, model));
  chunks.parameters = to_view("percuss::parameters_of_chunk", builder.parameters);
  chunks.record_size = to_view("percuss::record_size", builder.record_size);
  chunks.history = to_view("percuss::history", builder.history);
  chunks.points = to_view("percuss::points", builder.points);
  model.start_history = {to_view("percuss::first_start", builder.first_start),
                         to_view("percuss::start_count", builder.start_count),
                         to_view("percuss::start_history", builder.start_values)};
  chunks.scalars = to_view("percuss::history_scalars", builder.scalars);
}

// --- places in the whole mesh

void build_numbers(const ChunkedMesh& chunked, Model& model) {
  const Numbering& numbering = chunked.numbering;
  const std::vector<std::int64_t>& nodes = chunked.mesh.node_numbers;
  const auto find_place = [&](std::int64_t number) {
    return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), number) - nodes.begin());
  };
  std::vector<int> first, end;
  std::vector<std::int64_t> first_elements;
  for (const Chunk& chunk : chunked.chunks) {
    const auto number = static_cast<std::size_t>(chunk.number);
    first.push_back(find_place(numbering.first_node[number]));
    end.push_back(find_place(numbering.first_node[number + 1]));
    first_elements.push_back(numbering.first_element[number]);
  }
  model.owned_nodes = {static_cast<int>(first.size()), to_view("percuss::first_owned_node", first),
                       to_view("percuss::end_owned_node", end)};
  model.node_numbers = to_view("percuss::node_numbers", nodes);
  model.first_elements = to_view("percuss::first_elements", first_elements);
}

// --- halo

/// Leaves to `block` the chunks that no other rank waits for and puts the others into `sending`.
template <class Block>
void split_block(const std::vector<char>& sends, Block& block, Block& sending) {
  const auto all = to_host(block.chunks);
  std::vector<int> first, rest;
  for (std::size_t i = 0; i < all.extent(0); ++i) {
    (sends[static_cast<std::size_t>(all(i))] != 0 ? first : rest).push_back(all(i));
  }
  sending = block;
  sending.chunks = to_view("percuss::sending_chunks_of_block", first);
  block.chunks = to_view("percuss::chunks_of_block", rest);
}

template <class Blocks, std::size_t... Is>
void split_blocks(const std::vector<char>& sends, Blocks& blocks, Blocks& sending, std::index_sequence<Is...>) {
  (split_block(sends, std::get<Is>(blocks), std::get<Is>(sending)), ...);
}

void build_halo(const ChunkedMesh& chunked, const LocalSlots& slots, Model& model) {
  UnstructuredExchange exchange(model.ranks);
  SharedNodes shared{{}, {0}, {}, std::vector<int>(chunked.mesh.nodes.size(), 0)};
  if (model.ranks.size() > 1) shared = find_shared_nodes(exchange, chunked.mesh.node_numbers);
  Halo halo = build_halo(exchange, shared, slots);
  const auto first_slot = to_host(model.chunks.first_slot);
  const std::vector<char> sends =
      mark_sending_chunks(halo.plan, {first_slot.data(), first_slot.data() + first_slot.extent(0)});
  split_blocks(sends, model.blocks, model.sending_blocks, std::make_index_sequence<std::tuple_size_v<HexBlocks>>());
  split_blocks(sends, model.shell_blocks, model.sending_shell_blocks,
               std::make_index_sequence<std::tuple_size_v<ShellBlocks>>());
  split_blocks(sends, model.tet_blocks, model.sending_tet_blocks,
               std::make_index_sequence<std::tuple_size_v<TetBlocks>>());
  split_blocks(sends, model.one_point_blocks, model.sending_one_point_blocks,
               std::make_index_sequence<std::tuple_size_v<OnePointBlocks>>());
  if (model.has_beams) split_block(sends, model.beam_block, model.sending_beam_block);
  model.nodes_to_slots = {to_view("percuss::first_slot_of_node", halo.nodes_to_slots.first),
                          to_view("percuss::slots_of_node", halo.nodes_to_slots.slots)};
  model.slot_count = halo.plan.slot_count();
  model.halo = std::move(halo.plan);
  if (model.mixes_tets) build_tet_nodes(chunked, halo.nodes_to_slots, model);
}

// --- masses

/// By the modes of the element's kernel.
double find_kernel_volume(const Mesh& mesh, std::size_t element) {
  if (mesh.topology_of(element).family != ElementFamily::hexahedra) return find_element_volume(mesh, element);
  const HexCorners corners = gather_corners(mesh.elements, element, mesh.nodes);
  double x[8], y[8], z[8];
  for (std::size_t i = 0; i < 8; ++i) {
    x[i] = corners[i][0];
    y[i] = corners[i][1];
    z[i] = corners[i][2];
  }
  to_modes(x);
  to_modes(y);
  to_modes(z);
  VectorModes<double> a{};
  for (int m = 1; m < 8; ++m) a[m] = {x[m], y[m], z[m]};
  return find_volume_gradient(a).volume;
}

/// The share of each chunk in the mass of its nodes, in the first column: elements in ascending order.
Rows3<double> sum_mass_by_slot(const Model& model, const Elements& elements, const std::vector<double>& element_mass) {
  const Rows3<double> slot_mass("percuss::slot_mass", static_cast<std::size_t>(model.slot_count));
  const auto host = Kokkos::create_mirror_view(slot_mass);
  const auto first_element = to_host(model.chunks.first_element), first_slot = to_host(model.chunks.first_slot),
             first_pack = to_host(model.chunks.first_pack);
  const auto corner_slots = to_host(model.chunks.corner_slots);
  for (std::size_t c = 0; c < static_cast<std::size_t>(model.chunks.count); ++c) {
    for (int e = first_element(c); e < first_element(c + 1); ++e) {
      const int i = e - first_element(c);
      const double share = element_mass[static_cast<std::size_t>(e)] / 8;
      const auto slot = [&](int corner) {
        return corner_slots(
            (static_cast<std::size_t>(first_pack(c) + i / pack_width) * 8 + static_cast<std::size_t>(corner)) *
                pack_width +
            static_cast<std::size_t>(i % pack_width));
      };
      const Topology& topology = elements.topology_of(static_cast<std::size_t>(e));
      for (int corner = 0; corner < 8; ++corner) {
        const double eighths = topology.find_mass_share(static_cast<std::size_t>(corner));
        host(static_cast<std::size_t>(first_slot(c) + slot(corner)), 0) += eighths * share;
      }
    }
  }
  Kokkos::deep_copy(slot_mass, host);
  return slot_mass;
}

/// Masses of the nodes, as forces are summed: so every copy of a node has the same bits.
std::vector<double> assemble_masses(const Model& model, const Elements& elements,
                                    const std::vector<double>& element_mass) {
  const Rows3<double> slot_mass = sum_mass_by_slot(model, elements, element_mass);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), slot_mass);
  swap.end();
  const Rows3<double> rows("percuss::node_mass", static_cast<std::size_t>(model.node_count));
  assemble_slots(ExecSpace(), model.nodes_to_slots, slot_mass, rows);
  const auto host = to_host(rows);
  std::vector<double> mass(host.extent(0));
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = host(n, 0);
  return mass;
}

/// Rotary inertia of the nodes, summed as their masses are.
void build_inertia(const Deck& deck, const Mesh& mesh, std::vector<double> element_mass, Model& model) {
  std::vector<double> gyration_square = find_gyration_squares(deck, mesh);
  set_beam_gyrations(deck, mesh, gyration_square);
  for (std::size_t e = 0; e < element_mass.size(); ++e) element_mass[e] *= gyration_square[e];
  model.gyration_square = to_view("percuss::gyration_square", gyration_square);
  model.inertia = to_view("percuss::inertia", assemble_masses(model, mesh.elements, element_mass));
}

std::vector<double> build_masses(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  const Mesh& mesh = chunked.mesh;
  std::vector<double> element_mass(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto material = static_cast<std::size_t>(mesh.block_of(e).material);
    element_mass[e] = deck.materials[material].density * find_kernel_volume(mesh, e);
  }
  if constexpr (is_single_precision) check_single_precision(deck, chunked, element_mass);
  scale_masses(deck, chunked, element_mass, model);
  model.scales_in_run = deck.scales_mass_in_run();
  model.resists_folding = deck.elements.resist_folding;
  std::vector<double> mass = assemble_masses(model, mesh.elements, element_mass);
  add_deck_masses(deck, chunked, mass, model);
  std::vector<int> all(mass.size());
  std::iota(all.begin(), all.end(), 0);
  const MassPoint scene = find_mass_point(chunked, all, mass);
  model.total_mass = scene.mass;
  model.mass_center = scene.center;
  model.mass = to_view("percuss::mass", mass);
  model.element_mass = to_view("percuss::element_mass", element_mass);
  if (model.has_rotations) build_inertia(deck, mesh, element_mass, model);
  return mass;
}

/// Lumped masses of what deforms, and of what the deck adds at nodes; only where a rigid body's mass is given.
std::vector<double> find_masses_of_others(const Deck& deck, const ChunkedMesh& chunked, const Model& model) {
  if (!gives_rigid_masses(deck)) return {};
  const auto of_elements = to_host(model.element_mass), extra = to_host(model.extra_mass);
  std::vector<double> element_mass(chunked.mesh.elements.size(), 0);
  for (const Chunk& chunk : chunked.chunks) {
    if (is_rigid_chunk(deck, chunk)) continue;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
      element_mass[static_cast<std::size_t>(e)] = of_elements(e);
  }
  std::vector<double> mass = assemble_masses(model, chunked.mesh.elements, element_mass);
  for (std::size_t n = 0; n < extra.extent(0); ++n) mass[n] += extra(n);
  return mass;
}

/// Chunks of rigid parts, of which nobody computes anything.
void mark_rigid_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  if (!has_rigid_bodies(deck)) return;
  std::vector<int> is_rigid;
  for (const Chunk& chunk : chunked.chunks) is_rigid.push_back(is_rigid_chunk(deck, chunk) ? 1 : 0);
  model.is_rigid_chunk = to_view("percuss::is_rigid_chunk", is_rigid);
}

}  // namespace

Model::Model() = default;
Model::Model(const Model&) = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(const Model&) = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

Model build_model(const Deck& deck, const ChunkedMesh& chunked) {
  const Mesh& mesh = chunked.mesh;
  Model model;
  model.ranks = find_ranks(mesh);
  model.node_count = static_cast<int>(mesh.nodes.size());
  model.element_count = static_cast<int>(mesh.elements.size());
  check_small_solids(deck, mesh);
  model.has_tets = has_tetrahedra(mesh);
  model.mixes_tets = model.has_tets && deck.elements.tetrahedra == ElementDeck::Tetrahedra::mixed;
  model.has_rotations = has_shells(mesh) || has_bending_beams(deck, mesh);
  build_chunks(deck, chunked, model);
  mark_rigid_chunks(deck, chunked, model);
  build_failing_chunks(deck, chunked, model);
  build_numbers(chunked, model);
  LocalSlots slots = build_pressure_faces(deck, chunked, model);
  build_nodal_loads(deck, chunked, slots, model);
  build_springs(deck, chunked, slots, model);
  build_halo(chunked, slots, model);
  model.start = to_rows("percuss::start", mesh.nodes);
  const std::vector<double> mass = build_masses(deck, chunked, model);
  const RigidMap rigid = find_rigid_nodes(deck, chunked, model);
  build_rigid_bodies(deck, chunked, rigid, {mass, find_masses_of_others(deck, chunked, model)}, model);
  build_joints(deck, model);
  build_welds(deck, chunked, model);
  build_held_directions(deck, chunked, rigid, mass, model);
  build_initial_velocities(deck, chunked, mass, model);
  start_rigid_bodies(deck, chunked, rigid, mass, model);
  build_damping(deck, chunked, rigid, model);
  model.gravity = deck.gravity.along;
  model.gravity_varies = !deck.gravity.is_constant();
  return model;
}

}  // namespace percuss
