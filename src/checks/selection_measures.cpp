#include "src/checks/selection_measures.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "comm/all_reduce.hpp"
#include "src/checks/loose_skins.hpp"
#include "src/deck/beam_deck.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// [nodes] which directions conditions hold or move.
std::vector<std::array<bool, 3>> find_held(const Deck& deck, const Mesh& mesh) {
  std::vector<std::array<bool, 3>> held(mesh.nodes.size(), std::array<bool, 3>{});
  for (const ConditionDeck& condition : deck.conditions) {
    if (condition.when.any()) continue;  // they hold for a time only
    for (const int node : select_nodes(mesh, deck, condition.where)) {
      for (std::size_t k = 0; k < 3; ++k) held[at(node)][k] = held[at(node)][k] || condition.active[k];
    }
  }
  return held;
}

/// [nodes] whether it has rotations: those of shells that are no membranes, and of beams that bend.
std::vector<bool> find_turning(const Deck& deck, const Mesh& mesh) {
  std::vector<bool> turning(mesh.nodes.size(), false);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Topology& topology = mesh.topology_of(e);
    const auto& section = deck.parts[at(mesh.part_of(e))].section;
    if (mesh.block_of(e).section.is_membrane) continue;
    if (!topology.is_surface() && !(topology.is_line() && section && bends(*section))) continue;
    for (const int node : mesh.corners(e)) turning[at(node)] = true;
  }
  return turning;
}

/// Whether a force acts in a held direction alone.
bool is_held(const NodalLoadDeck& load, const std::array<bool, 3>& held) {
  bool acts = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (load.active[k] && !held[k]) return false;
    acts = acts || load.active[k];
  }
  return acts;
}

void measure_loads(const Deck& deck, const Mesh& mesh, const std::vector<bool>& owned,
                   std::vector<LoadMeasures>& loads) {
  if (loads.empty()) return;
  const auto held = find_held(deck, mesh);
  const std::vector<bool> turning = find_turning(deck, mesh);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    for (const int node : select_nodes(mesh, deck, deck.nodal_loads[i].where)) {
      loads[i].turns = loads[i].turns || turning[at(node)];  // its owner need not hold the shells around it
      if (!owned[at(node)]) continue;
      ++loads[i].selected;
      if (is_held(deck.nodal_loads[i], held[at(node)])) ++loads[i].held;
    }
  }
}

void measure_conditions(const Deck& deck, const Mesh& mesh, std::vector<ConditionMeasures>& conditions) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    conditions[c] = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (const int node : select_nodes(mesh, deck, deck.conditions[c].where)) {
      for (std::size_t k = 0; k < 3; ++k) {
        conditions[c].low[k] = std::min(conditions[c].low[k], mesh.nodes[at(node)][k]);
        conditions[c].high[k] = std::max(conditions[c].high[k], mesh.nodes[at(node)][k]);
      }
    }
  }
}

/// Nodes of each part that `fixed` conditions without switches hold in all three directions.
std::vector<std::int64_t> count_held(const Deck& deck, const Mesh& mesh, const std::vector<bool>& owned) {
  std::vector<std::int64_t> counts(mesh.parts.size(), 0);
  std::vector<std::uint8_t> held;
  for (const ConditionDeck& condition : deck.conditions) {
    if (condition.kind != ConditionDeck::Kind::fixed || condition.when.any()) continue;
    held.resize(mesh.nodes.size(), 0);
    for (const int node : select_nodes(mesh, deck, condition.where)) {
      for (int k = 0; k < 3; ++k)
        if (condition.active[at(k)]) held[at(node)] |= static_cast<std::uint8_t>(1 << k);
    }
  }
  if (held.empty()) return counts;
  for (std::size_t p = 0; p < counts.size(); ++p) {
    for (const int node : mesh.node_sets.at(mesh.parts[p].name)) counts[p] += owned[at(node)] && held[at(node)] == 7;
  }
  return counts;
}

/// Within 1e-9 of the size of the box both of its faces are met, as by selectors.
void count_between(const Deck& deck, const Mesh& mesh, const std::vector<bool>& owned,
                   std::vector<ConditionMeasures>& conditions) {
  constexpr double round_off = 1e-9;
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    ConditionMeasures& of = conditions[c];
    if (deck.conditions[c].kind != ConditionDeck::Kind::symmetry) continue;
    for (const int node : select_nodes(mesh, deck, deck.conditions[c].where)) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = mesh.nodes[at(node)][k], margin = round_off * (of.high[k] - of.low[k]);
        of.between[k] += owned[at(node)] && x > of.low[k] + margin && x < of.high[k] - margin;
      }
    }
  }
}

/// Counts that come after the boxes of all ranks are known.
void reduce_counts(const Communicator& ranks, SelectionMeasures& selections) {
  std::vector<std::int64_t> counts = selections.held;
  for (const ConditionMeasures& condition : selections.conditions)
    counts.insert(counts.end(), condition.between.begin(), condition.between.end());
  all_reduce(ranks, Reduce::sum, counts);
  auto count = counts.begin();
  for (std::int64_t& held : selections.held) held = *count++;
  for (ConditionMeasures& condition : selections.conditions)
    for (std::int64_t& between : condition.between) between = *count++;
}

/// The counts of all ranks, and the box around those of all.
void reduce(const Communicator& ranks, SelectionMeasures& selections) {
  std::vector<std::int64_t> counts;
  for (const LoadMeasures& load : selections.loads)
    counts.insert(counts.end(), {load.selected, load.held, load.turns ? 1 : 0});
  all_reduce(ranks, Reduce::sum, counts);
  for (std::size_t i = 0; i < selections.loads.size(); ++i)
    selections.loads[i] = {counts[3 * i], counts[3 * i + 1], counts[3 * i + 2] > 0};
  std::vector<double> bounds;
  for (const ConditionMeasures& condition : selections.conditions) {
    for (std::size_t k = 0; k < 3; ++k) bounds.insert(bounds.end(), {-condition.low[k], condition.high[k]});
  }
  all_reduce(ranks, Reduce::largest, bounds);
  for (std::size_t c = 0; c < selections.conditions.size(); ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      selections.conditions[c].low[k] = -bounds[6 * c + 2 * k];
      selections.conditions[c].high[k] = bounds[6 * c + 2 * k + 1];
    }
  }
}

}  // namespace

SelectionMeasures measure_selections(const Deck& deck, const ChunkedMesh& chunked, const std::vector<bool>& owned) {
  const Mesh& mesh = chunked.mesh;
  SelectionMeasures selections{std::vector<LoadMeasures>(deck.nodal_loads.size()),
                               std::vector<ConditionMeasures>(deck.conditions.size()), count_held(deck, mesh, owned),
                               count_loose_nodes(deck, chunked, owned)};
  const bool is_shared = mesh.ranks && mesh.ranks->size() > 1;
  measure_loads(deck, mesh, owned, selections.loads);
  measure_conditions(deck, mesh, selections.conditions);
  if (is_shared) reduce(*mesh.ranks, selections);
  count_between(deck, mesh, owned, selections.conditions);
  if (is_shared) reduce_counts(*mesh.ranks, selections);
  return selections;
}

}  // namespace percuss
