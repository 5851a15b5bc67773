#include "src/step/audit/part_energies.hpp"

#include <algorithm>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/step/model/moving_nodes.hpp"

namespace percuss {

namespace {

using P = PartSum;

/// Sums over the nodes of the listed chunks, in ascending order. A chunk is the same everywhere. has_own_mass: bodies
/// whose nodes are left out; may be empty.
void sum_chunks(const Model& model, const State& state, const Array<int>& listed, const Array<int>& has_own_mass,
                const ChunkSums& sums) {
  const MovingNodes moving = find_translations(model, state);
  const MovingNodes turning = model.has_rotations ? find_rotations(model, state) : MovingNodes{};
  const bool turns = model.has_rotations;
  const NodeRuns owned = model.owned_nodes;
  const bool leaves_out = has_own_mass.extent(0) > 0;
  const Array<const int> left_out = has_own_mass, body_of_node = model.rigid.body_of_node;
  parallel_for(
      "percuss::sum_parts", RangeOf(ExecSpace(), 0, static_cast<int>(listed.extent(0))), KOKKOS_LAMBDA(const int i) {
        double sum[ChunkSum::count] = {}, f[3];
        for (int n = owned.first(listed(i)); n < owned.end(listed(i)); ++n) {
          if (leaves_out && body_of_node(n) >= 0 && left_out(body_of_node(n)) != 0) continue;
          moving.find_force(n, f);
          for (int k = 0; k < 3; ++k) {
            sum[ChunkSum::kinetic] += moving.find_energy(n, k, f[k]);
            sum[ChunkSum::momentum + k] += moving.inertia(n) * moving.velocity(n, k);
          }
          sum[ChunkSum::mass] += moving.inertia(n);
          if (!turns) continue;
          turning.find_force(n, f);
          for (int k = 0; k < 3; ++k) sum[ChunkSum::rotation] += turning.find_energy(n, k, f[k]);
        }
        for (int k = 0; k < ChunkSum::count; ++k) sums(i, k) = sum[k];
      });
}

}  // namespace

std::vector<PartEnergy> sum_part_energies(const ChunkedMesh& chunked, const Model& model, const State& state) {
  const ChunkWork work(chunked, model, state);
  std::vector<ExactSum> sums(P::count * chunked.mesh.parts.size());
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c)
    work.add(static_cast<int>(c), &sums[P::count * static_cast<std::size_t>(chunked.chunks[c].part)]);
  sum_over_ranks(model.ranks, sums);
  std::vector<PartEnergy> parts;
  for (std::size_t p = 0; p < chunked.mesh.parts.size(); ++p)
    parts.push_back({sums[P::count * p + P::internal].round(), sums[P::count * p + P::internal + 1].round()});
  return parts;
}

std::vector<BookedPart> find_booked_parts(const Deck& deck) {
  std::vector<BookedPart> parts;
  for (const HistoryPoint& point : deck.output.points) {
    for (std::size_t p = 0; names_parts(point) && p < deck.parts.size(); ++p) {
      if (!point.part.empty() && point.part != deck.parts[p].name) continue;
      parts.push_back(
          {deck.parts[p].name, static_cast<int>(p), can_fail(deck, deck.parts[p]), deck.elements.resist_folding});
    }
  }
  return parts;
}

std::vector<HistoryColumn> list_part_columns(const std::vector<BookedPart>& parts) {
  return list_sum_columns(parts, "part");
}

PartEnergies::PartEnergies(const Deck& deck, const ChunkedMesh& chunked)
    : chunked_(chunked), parts_(find_booked_parts(deck)) {
  if (parts_.empty()) return;
  std::vector<int> place(chunked.mesh.parts.size(), -1);
  for (std::size_t p = 0; p < parts_.size(); ++p)
    place[static_cast<std::size_t>(parts_[p].index)] = static_cast<int>(p);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const int part = place[static_cast<std::size_t>(chunked.chunks[c].part)];
    if (part < 0) continue;
    chunks_.push_back(static_cast<int>(c));
    part_of_chunk_.push_back(part);
  }
  listed_ = to_view("percuss::chunks_of_booked_parts", chunks_);
  node_sums_ = ChunkSums("percuss::part_sums", chunks_.size(), ChunkSum::count);
  find_bodies(deck, place);
}

/// place: of a part of the deck among those with columns, -1: it has none.
void PartEnergies::find_bodies(const Deck& deck, const std::vector<int>& place) {
  const std::vector<int> has_own = mark_bodies_of_parts(deck);
  if (has_own.empty()) return;
  const RigidNames names = name_rigid_bodies(deck);
  part_of_body_.assign(has_own.size(), -1);
  for (std::size_t p = deck.parts.size(); p-- > 0;) {
    if (!deck.parts[p].rigid) continue;
    const auto body = static_cast<std::size_t>(names.body_of_part[p]);
    if (has_own[body] != 0) part_of_body_[body] = place[p];  // of its first part
  }
  has_own_mass_ = to_view("percuss::bodies_with_own_mass", has_own);
}

/// Whole bodies for their first parts, on the first rank, as all know them; then what the chunks of each rank take of
/// that for their own.
void PartEnergies::add_bodies(const Model& model, const State& state, std::vector<ExactSum>& sums) {
  if (part_of_body_.empty()) return;
  if (!find_forces_) find_forces_.emplace(model);
  const std::vector<BodyForces> forces = (*find_forces_)(state);
  const auto add = [&](int part, double sign, const RigidSums& of, double mass) {
    if (part < 0) return;
    ExactSum* const sum = &sums[P::count * static_cast<std::size_t>(part)];
    sum[P::kinetic].add(sign * of.kinetic);
    for (int k = 0; k < 3; ++k) sum[P::momentum + k].add(sign * get(of.momentum, k));
    sum[P::mass].add(sign * mass);
  };
  for (std::size_t b = 0; b < forces.size() && model.ranks.rank() == 0; ++b)
    add(part_of_body_[b], 1, sum_rigid_body(model, state, b, forces[b]), model.rigid.bodies[b].mass);
  for (const RigidChunk& chunk : model.rigid.chunks) {
    const auto b = static_cast<std::size_t>(chunk.body);
    if (model.rigid.bodies[b].has_given_masses) continue;
    const RigidSums of = sum_rigid_chunk(model, state, chunk, forces[b]);
    const auto own = std::lower_bound(chunks_.begin(), chunks_.end(), chunk.chunk);
    if (own != chunks_.end() && *own == chunk.chunk)
      add(part_of_chunk_[static_cast<std::size_t>(own - chunks_.begin())], 1, of, chunk.mass);
    add(part_of_body_[b], -1, of, chunk.mass);
  }
}

/// The sums of this rank, part after part.
std::vector<ExactSum> PartEnergies::sum_parts(const Model& model, const State& state) {
  sum_chunks(model, state, listed_, has_own_mass_, node_sums_);
  const auto of_nodes = to_host(node_sums_);
  const ChunkWork work(chunked_, model, state);
  std::vector<ExactSum> sums(P::count * parts_.size());
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    ExactSum* const part = &sums[P::count * static_cast<std::size_t>(part_of_chunk_[i])];
    add_chunk_nodes(of_nodes, i, part);
    work.add(chunks_[i], part);
  }
  add_bodies(model, state, sums);
  return sums;
}

void PartEnergies::append(const Model& model, const State& state, std::vector<double>& row) {
  if (parts_.empty()) return;
  std::vector<ExactSum> sums = sum_parts(model, state);
  sum_over_ranks(model.ranks, sums);
  append_sums(parts_, sums, row);
}

}  // namespace percuss
