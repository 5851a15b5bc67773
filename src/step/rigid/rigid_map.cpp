#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/rigid/build_rigid.hpp"

namespace percuss {
namespace {

/// Adds up, at each node, one row for every chunk that has it: row(chunk). In a fixed order, but all are small whole
/// numbers.
template <class Row>
std::vector<std::array<double, 3>> sum_over_chunks(const ChunkedMesh& chunked, const Model& model, const Row& row) {
  const Rows3<double> slots("percuss::rigid_marks", at(model.slot_count));
  const auto host = Kokkos::create_mirror_view(slots);
  const auto first_slot = to_host(model.chunks.first_slot);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const std::array<double, 3> values = row(chunked.chunks[c]);
    for (int s = first_slot(c); s < first_slot(c + 1); ++s)
      for (std::size_t k = 0; k < 3; ++k) host(at(s), k) = values[k];
  }
  copy_values(slots, host);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), slots);
  swap.end();
  const Rows3<double> rows("percuss::rigid_mark_sums", at(model.node_count));
  assemble_slots(ExecSpace(), model.nodes_to_slots, slots, rows);
  const auto sums = to_host(rows);
  std::vector<std::array<double, 3>> out(at(model.node_count));
  for (std::size_t n = 0; n < out.size(); ++n) out[n] = {sums(n, 0), sums(n, 1), sums(n, 2)};
  return out;
}

/// node: lowest number of one with two bodies on this rank; place: of a body of the deck.
void refuse_two_bodies(const std::string& place, const ChunkedMesh& chunked, const Model& model, std::int64_t node) {
  all_reduce(model.ranks, Reduce::least, node);
  if (node == std::numeric_limits<std::int64_t>::max()) return;
  const int owner = chunked.numbering.find_node_owner(node), local = find_local_node(chunked, node);
  const std::string id = owner == model.ranks.rank() ? std::to_string(chunked.mesh.node_ids[at(local)]) : std::string();
  throw InputError(fmt::format(
      "{}: error: node {} belongs to two rigid bodies (they could not move independently): give their parts the same "
      "rigid.body, or their sets the same body",
      place, broadcast_text(model.ranks, id, owner)));
}

/// Nodes that the sets of the deck add to the bodies of parts.
void add_sets(const Deck& deck, const ChunkedMesh& chunked, const Model& model, RigidMap& map) {
  const RigidNames names = name_rigid_bodies(deck);
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s) {
    std::int64_t torn = std::numeric_limits<std::int64_t>::max();
    for (const int n : select_nodes(chunked.mesh, deck, deck.rigid_sets[s].where)) {
      int& body = map.body[at(n)];
      if (body >= 0 && body != names.body_of_set[s]) torn = std::min(torn, chunked.mesh.node_numbers[at(n)]);
      body = names.body_of_set[s];
      map.is_in_set[at(n)] = 1;
      if (!deck.rigid_sets[s].counts_nodes) map.counts[at(n)] = 0;
    }
    refuse_two_bodies(deck.where(deck.rigid_sets[s].place), chunked, model, torn);
  }
}

}  // namespace

RigidMap find_rigid_nodes(const Deck& deck, const ChunkedMesh& chunked, const Model& model) {
  RigidMap map;
  if (!has_rigid_bodies(deck)) return map;
  const RigidNames names = name_rigid_bodies(deck);
  const auto of_bodies = sum_over_chunks(chunked, model, [&](const Chunk& chunk) {
    const double body = names.body_of_part[at(chunk.part)] + 1;
    return std::array<double, 3>{body > 0 ? 1.0 : 0.0, body, body * body};
  });
  const auto of_others = sum_over_chunks(chunked, model, [&](const Chunk& chunk) {
    return std::array<double, 3>{names.body_of_part[at(chunk.part)] < 0 ? 1.0 : 0.0, 0, 0};
  });
  std::int64_t torn = std::numeric_limits<std::int64_t>::max();
  for (std::size_t n = 0; n < of_bodies.size(); ++n) {
    const auto& [count, sum, squares] = of_bodies[n];
    map.body.push_back(count > 0 ? static_cast<int>(std::lround(sum / count)) - 1 : -1);
    if (count * squares != sum * sum) torn = std::min(torn, chunked.mesh.node_numbers[n]);
  }
  refuse_two_bodies(deck.where(find_body_place(deck, names, 0)), chunked, model, torn);
  map.is_in_set.assign(map.body.size(), 0);
  map.counts.assign(map.body.size(), 1);
  add_sets(deck, chunked, model, map);
  for (std::size_t n = 0; n < map.body.size(); ++n)
    map.is_shared.push_back(map.body[n] >= 0 && of_others[n][0] > 0 ? 1 : 0);
  return map;
}

}  // namespace percuss
