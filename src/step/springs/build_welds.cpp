#include "src/step/springs/build_welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/end_pairs.hpp"

namespace percuss {
namespace {

/// Every rank moves all welds.
constexpr std::size_t most_welds = 100000;

/// Welds of an entry that have columns of their own in the history.
constexpr std::size_t most_welds_with_columns = 100;

WeldLaw make_weld_law(const Deck& deck, const WeldDeck& weld) {
  WeldLaw law;
  law.name = weld.name;
  law.place = deck.where(weld.place);
  law.strength = {weld.normal_strength.value_or(0), weld.shear_strength.value_or(0), weld.normal_exponent,
                  weld.shear_exponent};
  law.time = weld.time.value_or(WeldLaw::unbreakable);
  return law;
}

/// The normal of a weld: given, or the line between its nodes.
void set_normal(const WeldDeck& deck, const NodePair& pair, const WeldLaw& law, Weld& weld) {
  const Vec3 across = subtract(pair.second.place, pair.first.place);
  const Vec3& place = pair.first.place;
  const double size = std::sqrt(std::max(dot(place, place), dot(pair.second.place, pair.second.place)));
  weld.length = std::sqrt(dot(across, across));
  if (weld.length <= 1e-12 * size) weld.length = 0;
  weld.is_normal_its_line = !deck.normal && weld.length > 0;
  if (deck.normal) weld.normal = to_vector(*deck.normal);
  if (weld.is_normal_its_line) weld.normal = (1 / weld.length) * to_vector(across);
  const bool needs_one = deck.normal_strength || deck.shear_strength;
  if (deck.normal || weld.is_normal_its_line || !needs_one) return;
  throw InputError(
      fmt::format("{}: error: weld '{}' connects nodes at one place (the nodes coincide, so the weld has no "
                  "direction): give normal",
                  law.place, weld.name));
}

std::string describe_welds(const WeldDeck& deck, const std::vector<NodePair>& pairs) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  std::set<std::int64_t> ends;
  for (const NodePair& pair : pairs) {
    ends.insert(pair.second.number);
    const double length = find_distance(pair.first.place, pair.second.place);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  if (pairs.size() == 1) return fmt::format("weld '{}': {:.4g} long", deck.name, longest);
  const std::size_t shared = pairs.size() - ends.size();
  return fmt::format(
      "weld '{}': {} of them, {:.4g} to {:.4g} long{}", deck.name, pairs.size(), shortest, longest,
      shared == 0 ? "" : fmt::format(", {} end on a node of another (do the sets face each other?)", shared));
}

void check_weld_name(const WeldLaw& law, const std::string& name, std::set<std::string>& names) {
  if (names.insert(name).second) return;
  throw InputError(
      fmt::format("{}: error: entry '{}' makes a second weld '{}' (welds of an entry are named NAME_1, NAME_2 ...): "
                  "rename one of the entries",
                  law.place, law.name, name));
}

/// Adds the welds of an entry; their ends are numbers in the whole mesh until all are known.
void add_welds(const WeldDeck& deck, const std::vector<NodePair>& pairs, std::set<std::string>& names,
               std::vector<std::array<std::int64_t, 2>>& ends, WeldModel& model) {
  const auto index = static_cast<int>(model.laws.size()) - 1;
  const WeldLaw& law = model.laws.back();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Weld weld;
    weld.name = pairs.size() == 1 ? deck.name : fmt::format("{}_{}", deck.name, i + 1);
    weld.law = index;
    weld.has_columns = pairs.size() <= most_welds_with_columns;
    set_normal(deck, pairs[i], law, weld);
    check_weld_name(law, weld.name, names);
    model.welds.push_back(std::move(weld));
    ends.push_back({pairs[i].first.number, pairs[i].second.number});
  }
  if (model.welds.size() > most_welds)
    throw InputError(
        fmt::format("{}: error: with weld '{}' there are {} welds (at most {}, because every rank computes all of "
                    "them): name smaller sets",
                    law.place, deck.name, model.welds.size(), most_welds));
}

void number_welded_nodes(const std::vector<std::array<std::int64_t, 2>>& ends, WeldModel& model) {
  std::vector<std::int64_t> all;
  for (const auto& of_weld : ends) all.insert(all.end(), of_weld.begin(), of_weld.end());
  std::sort(all.begin(), all.end());
  model.shares_nodes = std::adjacent_find(all.begin(), all.end()) != all.end();
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (std::size_t w = 0; w < ends.size(); ++w)
    for (std::size_t i = 0; i < 2; ++i)
      model.welds[w].end[i] = static_cast<int>(std::lower_bound(all.begin(), all.end(), ends[w][i]) - all.begin());
  model.nodes = std::move(all);
}

/// [WeldModel::nodes] 1: of a node that has a rotation of its own. Collective.
std::vector<int> mark_turning_nodes(const Model& model) {
  std::vector<int> turns(model.welds.nodes.size(), 0);
  if (!model.has_rotations) return turns;
  const auto nodes = to_host(model.welds.owned_node), places = to_host(model.welds.owned_place);
  const auto inertia = to_host(model.inertia);
  for (std::size_t i = 0; i < nodes.extent(0); ++i)
    turns[static_cast<std::size_t>(places(i))] = inertia(static_cast<std::size_t>(nodes(i))) > 0 ? 1 : 0;
  all_reduce(model.ranks, Reduce::largest, turns);
  return turns;
}

/// A node, by number, and one that an element has with it.
struct Neighbour {
  std::int64_t node = 0, other = 0;
};

/// The nodes of the solids around some nodes, themselves included: by the number of each. Collective.
std::map<std::int64_t, std::set<std::int64_t>> find_neighbours(const ChunkedMesh& chunked, const Model& model,
                                                               const std::set<std::int64_t>& nodes) {
  const Mesh& mesh = chunked.mesh;
  std::vector<Neighbour> own;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.topology_of(e).is_surface() || mesh.topology_of(e).is_line()) continue;
    for (const int n : mesh.corners(e)) {
      const std::int64_t number = mesh.node_numbers[static_cast<std::size_t>(n)];
      if (nodes.count(number) == 0) continue;
      for (const int other : mesh.corners(e))
        own.push_back({number, mesh.node_numbers[static_cast<std::size_t>(other)]});
    }
  }
  std::map<std::int64_t, std::set<std::int64_t>> found;
  for (const Neighbour& pair : gather_items(model.ranks, own)) found[pair.node].insert(pair.other);
  return found;
}

/// Whether no node of a weld, or of its patches, has another. Numbers are places now.
bool share_nodes(const WeldModel& model) {
  std::vector<int> all;
  for (const Weld& weld : model.welds) {
    std::set<int> own(weld.end.begin(), weld.end.end());
    for (const int patch : weld.patch)
      if (patch >= 0)
        own.insert(model.patches[static_cast<std::size_t>(patch)].begin(),
                   model.patches[static_cast<std::size_t>(patch)].end());
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

/// Ends without rotations that lie apart take that of the elements around them: so the weld carries shear and moments.
/// Collective.
void add_patches(const ChunkedMesh& chunked, Model& model) {
  WeldModel& welds = model.welds;
  const std::vector<int> turns = mark_turning_nodes(model);
  const auto is_patched = [&](const Weld& weld) {
    return weld.length > 0 &&
           turns[static_cast<std::size_t>(weld.end[0])] + turns[static_cast<std::size_t>(weld.end[1])] == 0;
  };
  std::vector<std::array<std::int64_t, 2>> ends;
  std::set<std::int64_t> centres, all(welds.nodes.begin(), welds.nodes.end());
  for (const Weld& weld : welds.welds) {
    ends.push_back(
        {welds.nodes[static_cast<std::size_t>(weld.end[0])], welds.nodes[static_cast<std::size_t>(weld.end[1])]});
    if (is_patched(weld)) centres.insert(ends.back().begin(), ends.back().end());
  }
  if (centres.empty()) return;
  const auto around = find_neighbours(chunked, model, centres);
  for (const auto& [node, others] : around) all.insert(others.begin(), others.end());
  const std::vector<std::int64_t> numbers(all.begin(), all.end());
  const auto find_place = [&](std::int64_t number) {
    return static_cast<int>(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
  };
  std::map<std::int64_t, int> patch_of_node;
  for (const auto& [node, others] : around) {
    patch_of_node[node] = static_cast<int>(welds.patches.size());
    welds.patches.emplace_back();
    for (const std::int64_t other : others) welds.patches.back().push_back(find_place(other));
  }
  for (std::size_t w = 0; w < ends.size(); ++w) {
    const bool has_patches =
        is_patched(welds.welds[w]) && patch_of_node.count(ends[w][0]) + patch_of_node.count(ends[w][1]) == 2;
    for (std::size_t i = 0; i < 2 && has_patches; ++i) welds.welds[w].patch[i] = patch_of_node.at(ends[w][i]);
  }
  for (std::size_t w = 0; w < ends.size(); ++w)
    for (std::size_t i = 0; i < 2; ++i) welds.welds[w].end[i] = find_place(ends[w][i]);
  welds.nodes = numbers;
  welds.shares_nodes = share_nodes(welds);
  find_connected_nodes(chunked, welds);
}

/// Bodies move their nodes by themselves.
void refuse_rigid_nodes(const Model& model) {
  const WeldModel& welds = model.welds;
  const std::vector<int> is_rigid = mark_rigid_nodes(model, welds);
  for (const Weld& weld : welds.welds) {
    const bool has_rigid =
        is_rigid[static_cast<std::size_t>(weld.end[0])] + is_rigid[static_cast<std::size_t>(weld.end[1])] > 0;
    if (!has_rigid) continue;
    throw InputError(
        fmt::format("{}: error: weld '{}' connects a node of a rigid body (welds connect nodes that deform): join its "
                    "nodes with rigid_sets",
                    welds.laws[static_cast<std::size_t>(weld.law)].place, weld.name));
  }
}

}  // namespace

void build_welds(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  if (deck.welds.empty()) return;
  std::vector<PairOfEnds> entries;
  for (const WeldDeck& weld : deck.welds) entries.push_back({weld.name, weld.between, weld.place});
  const std::vector<std::vector<NodePair>> pairs = find_node_pairs(deck, chunked, entries, "weld");
  std::vector<std::array<std::int64_t, 2>> ends;
  std::set<std::string> names;
  for (std::size_t i = 0; i < deck.welds.size(); ++i) {
    model.welds.laws.push_back(make_weld_law(deck, deck.welds[i]));
    model.welds.notes.push_back(describe_welds(deck.welds[i], pairs[i]));
    add_welds(deck.welds[i], pairs[i], names, ends, model.welds);
  }
  number_welded_nodes(ends, model.welds);
  find_connected_nodes(chunked, model.welds);
  refuse_rigid_nodes(model);
  add_patches(chunked, model);
}

}  // namespace percuss
