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
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/end_pairs.hpp"
#include "src/step/springs/region_welds.hpp"

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

/// Place of a number among ascending ones.
std::size_t find_place(const std::vector<std::int64_t>& numbers, std::int64_t number) {
  return at(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
}

/// A weld with its nodes by number in the whole mesh, until the places of all are known.
struct DraftWeld {
  Weld weld;
  std::array<std::int64_t, 2> end{-1, -1};  // -1: it has regions
  std::array<WeldRegion, 2> region;
  bool has_regions() const { return end[0] < 0; }
};

/// "NAME", or "NAME_3" of several.
std::string name_weld(const WeldDeck& deck, std::size_t count, std::size_t index) {
  return count == 1 ? deck.name : fmt::format("{}_{}", deck.name, index + 1);
}

/// Drafts welds of the pairs of nodes of an entry.
std::vector<DraftWeld> draft_pairs(const WeldDeck& deck, const std::vector<NodePair>& pairs, const WeldLaw& law) {
  std::vector<DraftWeld> drafts;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    DraftWeld& draft = drafts.emplace_back();
    draft.weld.name = name_weld(deck, pairs.size(), i);
    set_normal(deck, pairs[i], law, draft.weld);
    draft.end = {pairs[i].first.number, pairs[i].second.number};
  }
  return drafts;
}

/// Drafts welds of the points of an entry with a radius. The normal is that of the face of the first end, towards the
/// second.
std::vector<DraftWeld> draft_regions(const WeldDeck& deck, const std::vector<std::array<WeldRegion, 2>>& regions) {
  std::vector<DraftWeld> drafts;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    DraftWeld& draft = drafts.emplace_back();
    draft.weld.name = name_weld(deck, regions.size(), i);
    draft.region = regions[i];
    const WeldRegion& first = regions[i][0];
    const bool is_away = dot(subtract(regions[i][1].nearest, first.nearest), first.normal) < 0;
    draft.weld.normal = deck.normal ? to_vector(*deck.normal) : (is_away ? -1.0 : 1.0) * to_vector(first.normal);
  }
  return drafts;
}

std::string describe_regions(const WeldDeck& deck, const std::vector<std::array<WeldRegion, 2>>& regions) {
  std::size_t fewest = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const auto& ends : regions) {
    for (const WeldRegion& region : ends) {
      fewest = std::min(fewest, region.nodes.size());
      most = std::max(most, region.nodes.size());
    }
  }
  return fmt::format("weld '{}': {} of them, {}, with {} to {} nodes at each end", deck.name, regions.size(),
                     deck.file.empty() ? fmt::format("of radius {:.4g}", *deck.radius) : "of " + deck.file, fewest,
                     most);
}

void refuse_too_many(const WeldLaw& law, std::size_t count) {
  if (count <= most_welds) return;
  throw InputError(
      fmt::format("{}: error: with weld '{}' there are {} welds (at most {}, because every rank computes all of "
                  "them): name smaller sets",
                  law.place, law.name, count, most_welds));
}

/// All welds, in the order of the deck. Collective.
std::vector<DraftWeld> draft_welds(const Deck& deck, const ChunkedMesh& chunked, WeldModel& model) {
  RegionWelds regions = find_region_welds(deck, chunked);
  model.warnings = std::move(regions.warnings);
  std::vector<PairOfEnds> entries;
  for (const WeldDeck& weld : deck.welds)
    if (!weld.is_between_faces()) entries.push_back({weld.name, weld.between, weld.place});
  const std::vector<std::vector<NodePair>> pairs = find_node_pairs(deck, chunked, entries, "weld");
  std::vector<DraftWeld> all;
  std::set<std::string> names;
  std::size_t next = 0;
  for (std::size_t i = 0; i < deck.welds.size(); ++i) {
    const WeldDeck& weld = deck.welds[i];
    const WeldLaw& law = model.laws.emplace_back(make_weld_law(deck, weld));
    model.notes.push_back(weld.is_between_faces() ? describe_regions(weld, regions.of_entry[i])
                                                  : describe_welds(weld, pairs[next]));
    std::vector<DraftWeld> drafts =
        weld.is_between_faces() ? draft_regions(weld, regions.of_entry[i]) : draft_pairs(weld, pairs[next++], law);
    for (DraftWeld& draft : drafts) {
      draft.weld.law = static_cast<int>(i);
      draft.weld.has_columns = drafts.size() <= most_welds_with_columns;
      check_weld_name(law, draft.weld.name, names);
      all.push_back(std::move(draft));
    }
    refuse_too_many(law, all.size());
  }
  return all;
}

/// [WeldModel::nodes] 1: of a node that has a rotation of its own. Collective.
std::vector<int> mark_turning_nodes(const Model& model) {
  std::vector<int> turns(model.welds.nodes.size(), 0);
  if (!model.has_rotations) return turns;
  const auto nodes = to_host(model.welds.owned_node), places = to_host(model.welds.owned_place);
  const auto inertia = to_host(model.inertia);
  for (std::size_t i = 0; i < nodes.extent(0); ++i) turns[at(places(i))] = inertia(at(nodes(i))) > 0 ? 1 : 0;
  all_reduce(model.ranks, Reduce::largest, turns);
  return turns;
}

/// A node, by number, and one that an element has with it.
struct Neighbour {
  std::int64_t node = 0, other = 0;
};

/// Nodes by the number of another.
using Neighbourhoods = std::map<std::int64_t, std::set<std::int64_t>>;

/// The nodes of the solids around some nodes, themselves included: by the number of each. Collective.
Neighbourhoods find_neighbours(const ChunkedMesh& chunked, const Model& model, const std::set<std::int64_t>& nodes) {
  const Mesh& mesh = chunked.mesh;
  std::vector<Neighbour> own;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.topology_of(e).is_surface() || mesh.topology_of(e).is_line()) continue;
    for (const int n : mesh.corners(e)) {
      const std::int64_t number = mesh.node_numbers[at(n)];
      if (nodes.count(number) == 0) continue;
      for (const int other : mesh.corners(e)) own.push_back({number, mesh.node_numbers[at(other)]});
    }
  }
  Neighbourhoods found;
  for (const Neighbour& pair : gather_items(model.ranks, own)) found[pair.node].insert(pair.other);
  return found;
}

/// Whether some node has several welds, also as one of their patches.
bool share_nodes(const WeldModel& model) {
  std::vector<int> all;
  for (const Weld& weld : model.welds) {
    std::set<int> own;
    if (!weld.has_regions()) own.insert(weld.end.begin(), weld.end.end());
    for (const int patch : weld.patch)
      if (patch >= 0) own.insert(model.patches[at(patch)].nodes.begin(), model.patches[at(patch)].nodes.end());
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

/// Bodies move their nodes by themselves.
void refuse_rigid_nodes(const Model& model, const std::vector<DraftWeld>& drafts) {
  const WeldModel& welds = model.welds;
  const std::vector<int> marks = mark_rigid_nodes(model, welds);
  const auto is_rigid = [&](std::int64_t node) { return marks[find_place(welds.nodes, node)] != 0; };
  for (const DraftWeld& draft : drafts) {
    const bool has_rigid =
        draft.has_regions()
            ? std::any_of(draft.region.begin(), draft.region.end(),
                          [&](const auto& end) { return std::any_of(end.nodes.begin(), end.nodes.end(), is_rigid); })
            : std::any_of(draft.end.begin(), draft.end.end(), is_rigid);
    if (!has_rigid) continue;
    throw InputError(
        fmt::format("{}: error: weld '{}' connects a node of a rigid body (welds connect nodes that deform): join its "
                    "nodes with rigid_sets",
                    welds.laws[at(draft.weld.law)].place, draft.weld.name));
  }
}

/// Ends without rotations that lie apart take that of the elements around them: so the weld carries shear and moments.
/// The nodes of these, by that at which a weld ends. Collective.
Neighbourhoods find_neighbourhoods(const ChunkedMesh& chunked, const Model& model,
                                   const std::vector<DraftWeld>& drafts) {
  const std::vector<int> turns = mark_turning_nodes(model);
  const auto turns_there = [&](std::int64_t node) { return turns[find_place(model.welds.nodes, node)] != 0; };
  std::set<std::int64_t> centres;  // the same on all ranks
  for (const DraftWeld& draft : drafts)
    if (draft.weld.length > 0 && !turns_there(draft.end[0]) && !turns_there(draft.end[1]))
      centres.insert(draft.end.begin(), draft.end.end());
  return centres.empty() ? Neighbourhoods() : find_neighbours(chunked, model, centres);
}

/// The nodes of all welds by number, and which of them this rank has. Collective.
void set_nodes(const ChunkedMesh& chunked, const std::vector<DraftWeld>& drafts, const Neighbourhoods& around,
               WeldModel& model) {
  std::set<std::int64_t> all;
  for (const DraftWeld& draft : drafts) {
    if (!draft.has_regions()) all.insert(draft.end.begin(), draft.end.end());
    for (const WeldRegion& region : draft.region) all.insert(region.nodes.begin(), region.nodes.end());
  }
  for (const auto& [node, others] : around) all.insert(others.begin(), others.end());
  model.nodes.assign(all.begin(), all.end());
  find_connected_nodes(chunked, model);
}

int add_patch(const WeldRegion& region, WeldModel& model) {
  WeldPatch& patch = model.patches.emplace_back();
  for (const std::int64_t node : region.nodes) patch.nodes.push_back(static_cast<int>(find_place(model.nodes, node)));
  patch.weights = region.weights;
  patch.products = region.products;
  return static_cast<int>(model.patches.size()) - 1;
}

std::map<std::int64_t, int> add_patches(const Neighbourhoods& around, WeldModel& model) {
  std::map<std::int64_t, int> patch_of_node;
  for (const auto& [node, others] : around) {
    WeldRegion region;
    region.nodes.assign(others.begin(), others.end());
    patch_of_node[node] = add_patch(region, model);
  }
  return patch_of_node;
}

/// Replaces numbers by places.
void finish_welds(std::vector<DraftWeld>& drafts, const Neighbourhoods& around, WeldModel& model) {
  const std::map<std::int64_t, int> patch_of_node = add_patches(around, model);
  for (DraftWeld& draft : drafts) {
    const bool has_regions = draft.has_regions();
    const bool has_patches = !has_regions && draft.weld.length > 0 &&
                             patch_of_node.count(draft.end[0]) + patch_of_node.count(draft.end[1]) == 2;
    for (std::size_t e = 0; e < 2; ++e) {
      if (!has_regions) draft.weld.end[e] = static_cast<int>(find_place(model.nodes, draft.end[e]));
      if (has_regions) draft.weld.patch[e] = add_patch(draft.region[e], model);
      if (has_patches) draft.weld.patch[e] = patch_of_node.at(draft.end[e]);
    }
    model.welds.push_back(std::move(draft.weld));
  }
  model.shares_nodes = share_nodes(model);
}

}  // namespace

void build_welds(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  if (deck.welds.empty()) return;
  WeldModel& welds = model.welds;
  std::vector<DraftWeld> drafts = draft_welds(deck, chunked, welds);
  set_nodes(chunked, drafts, {}, welds);
  refuse_rigid_nodes(model, drafts);
  const Neighbourhoods around = find_neighbourhoods(chunked, model, drafts);
  if (!around.empty()) set_nodes(chunked, drafts, around, welds);
  finish_welds(drafts, around, welds);
}

}  // namespace percuss
