#include "src/step/springs/build_welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

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
      fmt::format("{}: error: weld '{}' connects nodes at one place (its forces along and across its "
                  "normal cannot be told apart): give normal",
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
}

}  // namespace percuss
