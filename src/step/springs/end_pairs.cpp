#include "src/step/springs/end_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "comm/gather_items.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/followed_points.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Nodes of ends. Those that are single nodes are found together, since each search looks at the whole mesh.
class EndFinder {
 public:
  EndFinder(const Deck& deck, const ChunkedMesh& chunked, const std::vector<NamedEnd>& ends, const std::string& kind)
      : deck_(deck), chunked_(chunked) {
    std::vector<HistoryPoint> points;
    for (const NamedEnd& of : ends) {
      if (!of.end.point) continue;
      points.push_back(*of.end.point);
      points.back().name = of.name;
    }
    found_ = find_points(deck, chunked, points, "end of " + kind);
  }

  /// The nodes of an end on all ranks, ascending. To be requested in the order of the deck. Collective.
  std::vector<Item> find(const SpringEndDeck& end) { return gather_nodes(chunked_, find_own(end)); }

 private:
  /// Nodes that this rank owns, in its share.
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

/// Collective, as are check_ends() and check_counterparts().
void check_distance(const ChunkedMesh& chunked, const std::string& place, const std::string& entry, const Item& item,
                    const Nearest& found) {
  if (found.score == std::numeric_limits<double>::infinity())
    throw InputError(
        fmt::format("{}: error: {} has no node at its second end whose distance from node {} is a number "
                    "(squares of coordinates this large overflow): move the parts together",
                    place, entry, find_node_id(chunked, item.number)));
}

void check_ends(const ChunkedMesh& chunked, const std::string& place, const std::string& entry, const NodePair& pair) {
  if (pair.first.number == pair.second.number)
    throw InputError(
        fmt::format("{}: error: both ends of {} are node {} (a {} connects two different nodes): let "
                    "its ends share no node",
                    place, entry, find_node_id(chunked, pair.first.number), entry.substr(0, entry.find(' '))));
}

Vec3 find_mean(const std::vector<Item>& items) {
  Vec3 mean{};
  for (const Item& item : items)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += item.place[k] / static_cast<double>(items.size());
  return mean;
}

void check_counterparts(const ChunkedMesh& chunked, const std::string& place, const std::string& entry,
                        std::size_t count, const std::vector<NodePair>& pairs) {
  if (pairs.size() != count)
    throw InputError(
        fmt::format("{}: error: {} has {} nodes on its first side and {} on its second (each needs one counterpart): "
                    "name sides of the same mesh",
                    place, entry, pairs.size(), count));
  std::set<std::int64_t> taken;
  for (const NodePair& pair : pairs) {
    if (taken.insert(pair.second.number).second) continue;
    throw InputError(
        fmt::format("{}: error: node {} would be the counterpart of two nodes of {} (the sides have different "
                    "meshes): name sides of the same mesh",
                    place, find_node_id(chunked, pair.second.number), entry));
  }
}

}  // namespace

std::vector<Item> gather_nodes(const ChunkedMesh& chunked, const std::vector<int>& own) {
  std::vector<Item> items;
  for (const int node : own) {
    const auto n = static_cast<std::size_t>(node);
    items.push_back({chunked.mesh.nodes[n], chunked.mesh.node_numbers[n]});
  }
  items = gather_items(find_ranks(chunked.mesh), items);
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.number < b.number; });
  return items;
}

std::vector<std::vector<Item>> find_end_nodes(const Deck& deck, const ChunkedMesh& chunked,
                                              const std::vector<NamedEnd>& ends, const std::string& kind) {
  EndFinder finder(deck, chunked, ends, kind);
  std::vector<std::vector<Item>> all;
  for (const NamedEnd& of : ends) all.push_back(finder.find(of.end));
  return all;
}

std::vector<NodePair> pair_nodes(const ChunkedMesh& chunked, const PairOfEnds& entry, const std::string& place,
                                 const std::string& kind, const std::array<std::vector<Item>, 2>& nodes) {
  const auto& [first, second] = nodes;
  const std::string title = fmt::format("{} '{}'", kind, entry.name);
  const NearestItems nearest(second);
  const Vec3 shift = entry.are_counterparts ? subtract(find_mean(second), find_mean(first)) : Vec3{};
  std::vector<NodePair> pairs;
  for (const Item& item : first) {
    const Nearest found = nearest.find({item.place[0] + shift[0], item.place[1] + shift[1], item.place[2] + shift[2]});
    check_distance(chunked, place, title, item, found);
    pairs.push_back({item, *std::lower_bound(second.begin(), second.end(), found.number,
                                             [](const Item& i, std::int64_t number) { return i.number < number; })});
  }
  if (entry.are_counterparts) check_counterparts(chunked, place, title, second.size(), pairs);
  return pairs;
}

std::vector<std::vector<NodePair>> find_node_pairs(const Deck& deck, const ChunkedMesh& chunked,
                                                   const std::vector<PairOfEnds>& entries, const std::string& kind) {
  std::vector<NamedEnd> ends;
  for (const PairOfEnds& entry : entries)
    for (const SpringEndDeck& end : entry.between) ends.push_back({entry.name, end});
  const std::vector<std::vector<Item>> nodes = find_end_nodes(deck, chunked, ends, kind);
  std::vector<std::vector<NodePair>> all;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = deck.where(entries[i].place);
    all.push_back(pair_nodes(chunked, entries[i], place, kind, {nodes[2 * i], nodes[2 * i + 1]}));
    for (const NodePair& pair : all.back())
      check_ends(chunked, place, fmt::format("{} '{}'", kind, entries[i].name), pair);
  }
  return all;
}

}  // namespace percuss
