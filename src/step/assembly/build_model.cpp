#include <algorithm>
#include <utility>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/mesh/mesh.hpp"
#include "src/step/assembly/build_conditions.hpp"
#include "src/step/assembly/build_failing.hpp"
#include "src/step/assembly/build_masses.hpp"
#include "src/step/constraints/build_constraints.hpp"
#include "src/step/damping/build_damping.hpp"
#include "src/step/damping/build_stiffness_damping.hpp"
#include "src/step/elements/build_beams.hpp"
#include "src/step/elements/build_chunks.hpp"
#include "src/step/elements/build_shells.hpp"
#include "src/step/elements/build_tets.hpp"
#include "src/step/embedded/build_embedded.hpp"
#include "src/step/fluids/build_fluids.hpp"
#include "src/step/glue/build_glue.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/build_springs.hpp"
#include "src/step/springs/build_welds.hpp"
#include "src/step/turn_springs/build_turn_springs.hpp"

namespace percuss {

namespace {

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

void build_halo(const Deck& deck, const ChunkedMesh& chunked, const LocalSlots& slots, Model& model) {
  UnstructuredExchange exchange(model.ranks);
  SharedNodes shared{{}, {0}, {}, std::vector<int>(chunked.mesh.nodes.size(), 0)};
  if (model.ranks.size() > 1) shared = find_shared_nodes(exchange, chunked.mesh.node_numbers);
  Halo halo = build_halo(exchange, shared, slots);
  const auto first_slot = to_host(model.chunks.first_slot);
  const std::vector<char> sends =
      mark_sending_chunks(halo.plan, {first_slot.data(), first_slot.data() + first_slot.extent(0)});
  ElementBlocks::visit_pairs(*model.others, *model.sending,
                             [&](auto& block, auto& sending) { split_block(sends, block, sending); });
  model.nodes_to_slots = {to_view("percuss::first_slot_of_node", halo.nodes_to_slots.first),
                          to_view("percuss::slots_of_node", halo.nodes_to_slots.slots)};
  model.slot_count = halo.plan.slot_count();
  model.halo = std::move(halo.plan);
  if (model.mixes_solids) build_tet_nodes(deck, chunked, halo.nodes_to_slots, model);
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
  model.has_small_solids = has_small_solids(mesh);
  model.mixes_solids = model.has_small_solids && deck.elements.tetrahedra == ElementDeck::Tetrahedra::mixed;
  model.has_rotations = has_shells(mesh) || has_bending_beams(deck, mesh);
  model.ties_rotations = deck.contact.ties_rotations();
  build_chunks(deck, chunked, model);
  mark_uncomputed_chunks(deck, chunked, model);
  build_failing_chunks(deck, chunked, model);
  build_stiffness_damping(deck, chunked, model);
  build_numbers(chunked, model);
  LocalSlots slots = build_pressure_faces(deck, chunked, model);
  build_nodal_loads(deck, chunked, slots, model);
  build_springs(deck, chunked, slots, model);
  build_glue(deck, chunked, slots, model);
  build_fluids(deck, chunked, slots, model);
  build_halo(deck, chunked, slots, model);
  model.start = to_rows("percuss::start", mesh.nodes);
  const std::vector<double> mass = build_masses(deck, chunked, model);
  const RigidMap rigid = find_rigid_nodes(deck, chunked, model);
  build_rigid_bodies(deck, chunked, rigid, find_rigid_masses(deck, chunked, mass, model), model);
  move_glue_off_nodes(model);
  build_joints(deck, model);
  build_turn_springs(deck, model);
  build_welds(deck, chunked, model);
  build_spin_tensors(deck, chunked, model);
  build_switches(deck, model);
  build_held_directions(deck, chunked, rigid, mass, model);
  build_constraints(deck, chunked, model);
  build_embedded(deck, chunked, model);
  build_initial_velocities(deck, chunked, rigid, mass, model);
  start_rigid_bodies(deck, chunked, rigid, mass, model);
  build_damping(deck, chunked, rigid, model);
  model.gravity = deck.gravity.along;
  model.gravity_varies = !deck.gravity.is_constant();
  return model;
}

}  // namespace percuss
