#include "src/step/build/added_mass.hpp"

#include <fmt/format.h>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// What the nodes of an entry have together before, and how many they are.
struct NodeTotal {
  double mass = 0;
  std::int64_t count = 0;
};

NodeTotal sum_nodes(const ChunkedMesh& chunked, const Model& model, const std::vector<int>& nodes,
                    const std::vector<double>& mass) {
  ExactSum sums[1];
  NodeTotal total;
  for (const int n : nodes) {
    if (!owns_node(chunked, n)) continue;
    sums[0].add(mass[static_cast<std::size_t>(n)]);
    ++total.count;
  }
  sum_over_ranks(model.ranks, sums);
  all_reduce(model.ranks, Reduce::sum, total.count);
  total.mass = sums[0].round();
  return total;
}

}  // namespace

void add_deck_masses(const Deck& deck, const ChunkedMesh& chunked, std::vector<double>& mass, Model& model) {
  if (deck.added_masses.empty()) return;
  const std::vector<double> of_elements = mass;
  std::vector<double> extra(mass.size(), 0);
  for (const AddedMassDeck& added : deck.added_masses) {
    const std::vector<int> nodes = select_nodes(chunked.mesh, deck, added.where);
    const NodeTotal total = sum_nodes(chunked, model, nodes, of_elements);
    const bool evenly = added.spread == AddedMassDeck::Spread::evenly;
    for (const int node : nodes) {
      const auto n = static_cast<std::size_t>(node);
      extra[n] += evenly ? added.mass / static_cast<double>(total.count) : added.mass * (of_elements[n] / total.mass);
    }
    const std::string& name = added.where.name;
    model.mass_notes.push_back(fmt::format("added mass of {}: {:g} on {} nodes, {}, which have {:.4g} of their own",
                                           name.empty() ? "all nodes" : "'" + name + "'", added.mass, total.count,
                                           evenly ? "evenly" : "by their mass", total.mass));
  }
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = of_elements[n] + extra[n];
  model.extra_mass = to_view("percuss::extra_mass", extra);
}

}  // namespace percuss
