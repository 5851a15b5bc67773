#include "src/step/springs/build_springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/followed_points.hpp"
#include "src/step/model/nearest_items.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {
namespace {

/// Every rank moves all springs: more belong into a mesh.
constexpr std::size_t most_springs = 100000;

/// Springs of an entry that have columns of their own in the history: more would make rows that nobody reads.
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

/// Nodes of ends. Those that are single nodes are found together, since each search looks at the whole mesh.
class EndFinder {
 public:
  EndFinder(const Deck& deck, const ChunkedMesh& chunked) : deck_(deck), chunked_(chunked) {
    std::vector<HistoryPoint> points;
    for (const SpringDeck& spring : deck.springs) {
      for (const SpringEndDeck& end : spring.between) {
        if (!end.point) continue;
        points.push_back(*end.point);
        points.back().name = spring.name;
      }
    }
    found_ = find_points(deck, chunked, points, "end of spring");
  }

  /// The nodes of an end on all ranks, ascending. To be asked for in the order of the deck. Collective.
  std::vector<Item> find(const SpringEndDeck& end) {
    std::vector<Item> items;
    for (const int node : find_own(end)) {
      const auto n = static_cast<std::size_t>(node);
      items.push_back({chunked_.mesh.nodes[n], chunked_.mesh.node_numbers[n]});
    }
    items = gather_items(find_ranks(chunked_.mesh), items);
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.number < b.number; });
    return items;
  }

 private:
  /// Those that this rank owns, in its share.
  std::vector<int> find_own(const SpringEndDeck& end) {
    std::vector<int> own;
    if (end.point) {
      const int index = found_[next_++].index;
      if (index >= 0) own.push_back(index);
      return own;
    }
    for (const int n : select_nodes(chunked_.mesh, deck_, end.where))
      if (owns_node(chunked_, n)) own.push_back(n);
    return own;
  }

  const Deck& deck_;
  const ChunkedMesh& chunked_;
  std::vector<FollowedPoint> found_;
  std::size_t next_ = 0;
};

/// A spring by the nodes of its ends.
struct Pair {
  Item first, second;
};

void check_nearest(const Deck& deck, const SpringDeck& spring, const Item& item, const Nearest& found) {
  if (found.score == std::numeric_limits<double>::infinity())
    throw InputError(
        fmt::format("{}: error: spring '{}' has no node at its second end whose distance from node {} of the mesh is a "
                    "number (squares of coordinates this large overflow): move the parts together",
                    deck.where(spring.place), spring.name, item.number));
  if (found.number == item.number)
    throw InputError(
        fmt::format("{}: error: both ends of spring '{}' are node {} of the mesh (a spring connects two different "
                    "nodes): let its ends share no node",
                    deck.where(spring.place), spring.name, found.number));
}

std::vector<Pair> find_pairs(const Deck& deck, EndFinder& ends, const SpringDeck& spring) {
  const std::vector<Item> first = ends.find(spring.between[0]), second = ends.find(spring.between[1]);
  const NearestItems nearest(second);
  std::vector<Pair> pairs;
  for (const Item& item : first) {
    const Nearest found = nearest.find(item.place);
    check_nearest(deck, spring, item, found);
    pairs.push_back({item, *std::lower_bound(second.begin(), second.end(), found.number,
                                             [](const Item& i, std::int64_t number) { return i.number < number; })});
  }
  return pairs;
}

std::string describe(const SpringDeck& spring, const std::vector<Pair>& pairs) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const Pair& pair : pairs) {
    const double length = find_distance(pair.first.place, pair.second.place);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  if (pairs.size() == 1) return fmt::format("spring '{}': {:.4g} long", spring.name, longest);
  return fmt::format("spring '{}': {} of them, {:.4g} to {:.4g} long", spring.name, pairs.size(), shortest, longest);
}

/// Adds the springs of an entry; their ends are numbers in the whole mesh until all are known.
void add_springs(const SpringDeck& deck, const std::vector<Pair>& pairs, SpringModel& model,
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
  EndFinder finder(deck, chunked);
  std::vector<std::array<std::int64_t, 2>> ends;
  std::set<std::string> names;
  for (const SpringDeck& spring : deck.springs) {
    add_springs(spring, find_pairs(deck, finder, spring), model, ends);
    check_count(deck, spring, model);
    check_names(deck, spring, model, names);
  }
  number_ends(ends, model);
  return model;
}

void build_springs(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model) {
  if (deck.springs.empty()) return;
  SpringModel springs = find_springs(deck, chunked);
  // After the orders of everything else: the orders of slots of one node differ.
  std::int64_t order = 0;
  for (const std::int64_t other : slots.orders) order = std::max(order, other + 1);
  all_reduce(model.ranks, Reduce::largest, order);
  springs.first_slot = static_cast<int>(slots.nodes.size());
  std::vector<int> owned, places;
  for (std::size_t i = 0; i < springs.nodes.size(); ++i) {
    const int node = find_local_node(chunked, springs.nodes[i]);
    if (node < 0 || !owns_node(chunked, node)) continue;
    owned.push_back(node);
    places.push_back(static_cast<int>(i));
    slots.nodes.push_back(node);
    slots.orders.push_back(order);
  }
  springs.owned_node = to_view("percuss::spring_nodes", owned);
  springs.owned_place = to_view("percuss::spring_places", places);
  model.springs = std::move(springs);
}

}  // namespace percuss
