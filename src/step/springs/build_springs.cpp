#include "src/step/springs/build_springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/end_pairs.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {
namespace {

/// Every rank moves all springs: more belong into a mesh.
constexpr std::size_t most_springs = 100000;

/// Springs of an entry that have columns of their own in the history: more would make rows too long to read.
constexpr std::size_t most_with_columns = 100;

SpringLaw make_law(const SpringDeck& deck) {
  SpringLaw law;
  law.rows = deck.table;
  if (deck.stiffness) law.rows = {{{0, 0}, {1, *deck.stiffness}}};
  law.largest_slope = find_largest_slope(law);
  law.damping = deck.damping;
  law.acts = deck.acts;
  law.largest_force = deck.largest_force.value_or(SpringLaw::unbreakable);
  law.largest_elongation = deck.largest_elongation.value_or(SpringLaw::unbreakable);
  return law;
}

std::string describe(const SpringDeck& spring, const std::vector<NodePair>& pairs) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const NodePair& pair : pairs) {
    const double length = find_distance(pair.first.place, pair.second.place);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  if (pairs.size() == 1) return fmt::format("spring '{}': {:.4g} long", spring.name, longest);
  return fmt::format("spring '{}': {} of them, {:.4g} to {:.4g} long", spring.name, pairs.size(), shortest, longest);
}

/// Adds the springs of an entry; their ends are numbers in the whole mesh until all are known.
void add_springs(const SpringDeck& deck, const std::vector<NodePair>& pairs, SpringModel& model,
                 std::vector<std::array<std::int64_t, 2>>& ends) {
  const auto law = static_cast<int>(model.laws.size());
  model.laws.push_back(make_law(deck));
  model.notes.push_back(describe(deck, pairs));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Spring spring;
    spring.name = pairs.size() == 1 ? deck.name : fmt::format("{}_{}", deck.name, i + 1);
    spring.law = law;
    spring.has_columns = pairs.size() <= most_with_columns;
    spring.start_length = find_distance(pairs[i].first.place, pairs[i].second.place);
    spring.rest_length = deck.rest_length.value_or(spring.start_length);
    model.springs.push_back(std::move(spring));
    ends.push_back({pairs[i].first.number, pairs[i].second.number});
  }
}

void number_ends(const std::vector<std::array<std::int64_t, 2>>& ends, SpringModel& model) {
  for (const auto& of_spring : ends) model.nodes.insert(model.nodes.end(), of_spring.begin(), of_spring.end());
  std::sort(model.nodes.begin(), model.nodes.end());
  model.nodes.erase(std::unique(model.nodes.begin(), model.nodes.end()), model.nodes.end());
  for (std::size_t s = 0; s < ends.size(); ++s)
    for (std::size_t i = 0; i < 2; ++i)
      model.springs[s].end[i] =
          static_cast<int>(std::lower_bound(model.nodes.begin(), model.nodes.end(), ends[s][i]) - model.nodes.begin());
}

/// Names of springs head columns of the history. names: of the springs before those of this entry.
void check_names(const Deck& deck, const SpringDeck& spring, const SpringModel& model, std::set<std::string>& names) {
  for (std::size_t s = names.size(); s < model.springs.size(); ++s) {
    const std::string& name = model.springs[s].name;
    if (names.insert(name).second) continue;
    throw InputError(
        fmt::format("{}: error: entry '{}' makes a second spring '{}' (springs of an entry are named NAME_1, NAME_2 "
                    "...): rename one of the entries",
                    deck.where(spring.place), spring.name, name));
  }
}

void check_count(const Deck& deck, const SpringDeck& spring, const SpringModel& model) {
  if (model.springs.size() <= most_springs) return;
  throw InputError(
      fmt::format("{}: error: with spring '{}' there are {} springs (at most {}, because every rank computes all of "
                  "them): name smaller sets",
                  deck.where(spring.place), spring.name, model.springs.size(), most_springs));
}

}  // namespace

SpringModel find_springs(const Deck& deck, const ChunkedMesh& chunked) {
  SpringModel model;
  if (deck.springs.empty()) return model;
  std::vector<PairOfEnds> entries;
  for (const SpringDeck& spring : deck.springs) entries.push_back({spring.name, spring.between, spring.place});
  const std::vector<std::vector<NodePair>> pairs = find_node_pairs(deck, chunked, entries, "spring");
  std::vector<std::array<std::int64_t, 2>> ends;
  std::set<std::string> names;
  for (std::size_t i = 0; i < deck.springs.size(); ++i) {
    const SpringDeck& spring = deck.springs[i];
    add_springs(spring, pairs[i], model, ends);
    check_count(deck, spring, model);
    check_names(deck, spring, model, names);
  }
  number_ends(ends, model);
  return model;
}

void build_springs(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model) {
  if (deck.springs.empty()) return;
  SpringModel springs = find_springs(deck, chunked);
  add_force_slots(chunked, model.ranks, springs, slots);
  model.springs = std::move(springs);
}

}  // namespace percuss
