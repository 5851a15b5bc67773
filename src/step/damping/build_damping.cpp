#include "src/step/damping/build_damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

constexpr int undamped = -1;

/// [nodes] the last entry that names each.
std::vector<int> find_entries(const Deck& deck, const ChunkedMesh& chunked) {
  std::vector<int> entry(chunked.mesh.nodes.size(), undamped);
  for (std::size_t i = 0; i < deck.dampings.size(); ++i)
    for (const int n : select_nodes(chunked.mesh, deck, deck.dampings[i].where)) entry[at(n)] = static_cast<int>(i);
  return entry;
}

/// The smallest and the largest entry of the nodes of each body, on all ranks.
struct BodyEntries {
  std::vector<int> lowest, highest;
};

BodyEntries find_body_entries(const ChunkedMesh& chunked, const RigidMap& rigid, const std::vector<int>& entry,
                              const Model& model) {
  const std::size_t bodies = model.rigid.bodies.size();
  BodyEntries found{std::vector<int>(bodies, std::numeric_limits<int>::max()), std::vector<int>(bodies, undamped)};
  for (std::size_t n = 0; n < entry.size(); ++n) {
    const auto node = static_cast<int>(n);
    if (!rigid.holds(node) || !owns_node(chunked, node)) continue;
    int &lowest = found.lowest[at(rigid.body[n])], &highest = found.highest[at(rigid.body[n])];
    lowest = std::min(lowest, entry[n]);
    highest = std::max(highest, entry[n]);
  }
  all_reduce(model.ranks, Reduce::least, found.lowest);
  all_reduce(model.ranks, Reduce::largest, found.highest);
  return found;
}

}  // namespace

void build_damping(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid, Model& model) {
  if (deck.dampings.empty()) return;
  const std::vector<int> entry = find_entries(deck, chunked);
  const BodyEntries of_bodies = find_body_entries(chunked, rigid, entry, model);
  for (std::size_t b = 0; b < model.rigid.bodies.size(); ++b) {
    if (of_bodies.lowest[b] == of_bodies.highest[b]) continue;
    throw InputError(
        fmt::format("{}: error: this damping names only some nodes of rigid body '{}', or another entry damps the "
                    "others (a body is damped as a whole): name all its parts in one entry",
                    deck.where(deck.dampings[at(of_bodies.highest[b])].where.place), model.rigid.bodies[b].name));
  }
  model.damped_nodes.entry = to_view("percuss::damping_entry", entry);
  model.damped_bodies = of_bodies.highest;
  for (const DampingDeck& damping : deck.dampings) model.dampings.push_back(damping.coefficient);
}

}  // namespace percuss
