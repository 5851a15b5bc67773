#include "src/step/audit/block_energies.hpp"

#include <algorithm>

#include "comm/exact_reduction.hpp"
#include "comm/halo/halo_swap.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/node/motion.hpp"
#include "src/deck/asked_for.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/step/model/moving_nodes.hpp"

namespace percuss {
namespace {

/// Whether the part of a block can fail; for a name without a part, whether any part can.
bool can_block_fail(const Deck& deck, const std::string& name) {
  const std::string part = name.substr(0, name.find('/'));
  const auto found = std::find_if(deck.parts.begin(), deck.parts.end(), [&](const auto& p) { return p.name == part; });
  return found == deck.parts.end() ? can_fail(deck) : can_fail(deck, *found);
}

std::vector<BookedPart> find_booked_blocks(const Deck& deck) {
  std::vector<BookedPart> blocks;
  for (const Selector& block : deck.output.blocks)
    blocks.push_back(
        {block.name, static_cast<int>(blocks.size()), can_block_fail(deck, block.name), deck.elements.resist_folding});
  return blocks;
}

/// Part of each chunk in the lumped mass and the rotary inertia of its nodes, in the first two columns.
Rows3<double> sum_masses_by_slot(const ChunkedMesh& chunked, const Model& model, const State& state) {
  const Rows3<double> by_slot("percuss::masses_by_slot", static_cast<std::size_t>(model.slot_count));
  const auto host = Kokkos::create_mirror_view(by_slot);
  const HostChunks chunks(model.chunks);
  const auto mass = to_host(state.element_mass), gyration_square = to_host(model.gyration_square);
  for (int c = 0; c < chunks.count; ++c) {
    for (int i = 0; i < count_elements(chunks, c); ++i) {
      const auto element = static_cast<std::size_t>(find_element(chunks, c, i));
      const double eighth = mass(element) / 8,
                   turning = gyration_square.extent(0) > 0 ? eighth * gyration_square(element) : 0;
      const Topology& topology = chunked.mesh.elements.topology_of(element);
      for (int corner = 0; corner < 8; ++corner) {
        const int slot = number_corner_slot(chunks, c, i, corner);
        const double share = topology.find_mass_share(static_cast<std::size_t>(corner));
        host(slot, 0) += share * eighth;
        host(slot, 1) += share * turning;
      }
    }
  }
  copy_values(by_slot, host);
  return by_slot;
}

}  // namespace

std::vector<HistoryColumn> list_block_columns(const Deck& deck) {
  return list_sum_columns(find_booked_blocks(deck), "block");
}

BlockEnergies::BlockEnergies(const Deck& deck, const ChunkedMesh& chunked)
    : chunked_(chunked), blocks_(find_booked_blocks(deck)) {
  if (blocks_.empty()) return;
  std::vector<std::vector<char>> marks;
  for (const Selector& block : deck.output.blocks) marks.push_back(mark_elements(chunked.mesh, deck, {block}));
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const auto first = static_cast<std::size_t>(chunked.chunks[c].first_element);
    const std::size_t before = ownership_.size();
    for (std::size_t b = 0; b < marks.size(); ++b)
      if (marks[b][first] != 0) ownership_.emplace_back(static_cast<int>(chunks_.size()), static_cast<int>(b));
    if (ownership_.size() > before) chunks_.push_back(static_cast<int>(c));
  }
  listed_ = to_view("percuss::chunks_of_blocks", chunks_);
  node_sums_ = ChunkSums("percuss::block_sums", chunks_.size(), ChunkSum::count);
}

/// Room for the shares of the listed chunks.
void BlockEnergies::lay_out(const Model& model) {
  const auto first_slot = to_host(model.chunks.first_slot);
  std::vector<int> first_share;
  int count = 0;
  for (const int chunk : chunks_) {
    const auto c = static_cast<std::size_t>(chunk);
    first_share.push_back(count);
    count += first_slot(c + 1) - first_slot(c);
  }
  first_share_ = to_view("percuss::first_shares", first_share);
  shares_ = Shares("percuss::block_shares", static_cast<std::size_t>(count));
}

/// Once; at each row where mass scaling changes them. Collective.
void BlockEnergies::find_shares(const Model& model, const State& state) {
  if (has_shares_ && !model.scales_in_run) return;
  if (!has_shares_) lay_out(model);
  has_shares_ = true;
  const Rows3<double> by_slot = sum_masses_by_slot(chunked_, model, state);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), by_slot);
  swap.end();
  const Rows3<double> by_node("percuss::masses_by_node", static_cast<std::size_t>(model.node_count));
  assemble_slots(ExecSpace(), model.nodes_to_slots, by_slot, by_node);
  const auto listed = listed_, first_share = first_share_;
  const auto shares = shares_;
  const ElementChunks chunks = model.chunks;
  parallel_for(
      "percuss::find_block_shares", RangeOf(ExecSpace(), 0, static_cast<int>(chunks_.size())),
      KOKKOS_LAMBDA(const int i) {
        const int first = chunks.first_slot(listed(i));
        for (int s = first; s < chunks.first_slot(listed(i) + 1); ++s) {
          const int n = chunks.slots_to_nodes(s);
          for (int k = 0; k < 2; ++k)
            shares(first_share(i) + s - first, k) = by_node(n, k) > 0 ? by_slot(s, k) / by_node(n, k) : 0;
        }
      });
}

/// Sums over the slots of the listed chunks, in ascending order. A chunk is the same everywhere. Those of rigid parts
/// have none: add_rigid_chunks() counts them.
void BlockEnergies::sum_nodes(const Model& model, const State& state) {
  const MovingNodes moving = find_translations(model, state);
  const MovingNodes turning = model.has_rotations ? find_rotations(model, state) : MovingNodes{};
  const bool turns = model.has_rotations, has_bodies = model.rigid.any();
  const Array<const int> is_rigid = model.is_rigid_chunk;
  const auto listed = listed_, first_share = first_share_;
  const auto shares = shares_;
  const auto sums = node_sums_;
  const ElementChunks chunks = model.chunks;
  parallel_for(
      "percuss::sum_blocks", RangeOf(ExecSpace(), 0, static_cast<int>(chunks_.size())), KOKKOS_LAMBDA(const int i) {
        double sum[ChunkSum::count] = {}, f[3];
        const int first = chunks.first_slot(listed(i));
        const bool counts = !has_bodies || is_rigid(listed(i)) == 0;
        for (int s = first; counts && s < chunks.first_slot(listed(i) + 1); ++s) {
          const int n = chunks.slots_to_nodes(s);
          const double share = shares(first_share(i) + s - first, 0), turned = shares(first_share(i) + s - first, 1);
          moving.find_force(n, f);
          for (int k = 0; k < 3; ++k) {
            sum[ChunkSum::kinetic] += share * moving.find_energy(n, k, f[k]);
            sum[ChunkSum::momentum + k] += share * moving.inertia(n) * moving.velocity(n, k);
          }
          sum[ChunkSum::mass] += share * moving.inertia(n);
          if (!turns) continue;
          turning.find_force(n, f);
          for (int k = 0; k < 3; ++k) sum[ChunkSum::rotation] += turned * turning.find_energy(n, k, f[k]);
        }
        for (int k = 0; k < ChunkSum::count; ++k) sums(i, k) = sum[k];
      });
}

/// Adds the chunks of rigid bodies by the shapes of their elements; of a body whose masses the deck gives, nothing.
void BlockEnergies::add_rigid_chunks(const Model& model, const State& state, std::vector<ExactSum>& sums) {
  if (!model.rigid.any()) return;
  if (!find_forces_) find_forces_.emplace(model);
  const std::vector<BodyForces> forces = (*find_forces_)(state);
  for (const RigidChunk& chunk : model.rigid.chunks) {
    const auto b = static_cast<std::size_t>(chunk.body);
    const auto own = std::lower_bound(chunks_.begin(), chunks_.end(), chunk.chunk);
    if (model.rigid.bodies[b].has_given_masses || own == chunks_.end() || *own != chunk.chunk) continue;
    const RigidSums of = sum_rigid_chunk(model, state, chunk, forces[b]);
    for (const auto& [place, block] : ownership_) {
      if (place != own - chunks_.begin()) continue;
      ExactSum* const sum = &sums[PartSum::count * static_cast<std::size_t>(block)];
      sum[PartSum::kinetic].add(of.kinetic);
      for (int k = 0; k < 3; ++k) sum[PartSum::momentum + k].add(get(of.momentum, k));
      sum[PartSum::mass].add(chunk.mass);
    }
  }
}

void BlockEnergies::append(const Model& model, const State& state, std::vector<double>& row) {
  if (blocks_.empty()) return;
  find_shares(model, state);
  sum_nodes(model, state);
  const auto of_nodes = to_host(node_sums_);
  const ChunkWork work(chunked_, model, state);
  std::vector<ExactSum> sums(PartSum::count * blocks_.size());
  for (const auto& [place, block] : ownership_) {
    ExactSum* const owner = &sums[PartSum::count * static_cast<std::size_t>(block)];
    add_chunk_nodes(of_nodes, static_cast<std::size_t>(place), owner);
    work.add(chunks_[static_cast<std::size_t>(place)], owner);
  }
  add_rigid_chunks(model, state, sums);
  sum_over_ranks(model.ranks, sums);
  append_sums(blocks_, sums, row);
}

}  // namespace percuss
