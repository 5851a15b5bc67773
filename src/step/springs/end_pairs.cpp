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
  EndFinder(const Deck& deck, const ChunkedMesh& chunked, const std::vector<PairOfEnds>& entries,
            const std::string& kind)
      : deck_(deck), chunked_(chunked) {
    std::vector<HistoryPoint> points;
    for (const PairOfEnds& entry : entries) {
      for (const SpringEndDeck& end : entry.between) {
        if (!end.point) continue;
        points.push_back(*end.point);
        points.back().name = entry.name;
      }
    }
    found_ = find_points(deck, chunked, points, "end of " + kind);
  }

  /// The nodes of an end on all ranks, ascending. To be asked for in the order of the deck. Collective.
  std::vector<Item> find(const SpringEndDeck& end) { return gather_nodes(chunked_, find_own(end)); }

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

/// Collective, as is check_counterparts().
void check_nearest(const ChunkedMesh& chunked, const std::string& place, const std::string& entry, const Item& item,
                   const Nearest& found) {
  if (found.score == std::numeric_limits<double>::infinity())
    throw InputError(
        fmt::format("{}: error: {} has no node at its second end whose distance from node {} is a number "
                    "(squares of coordinates this large overflow): move the parts together",
                    place, entry, find_node_id(chunked, item.number)));
  if (found.number == item.number)
    throw InputError(
        fmt::format("{}: error: both ends of {} are node {} (a {} connects two different nodes): let "
                    "its ends share no node",
                    place, entry, find_node_id(chunked, found.number), entry.substr(0, entry.find(' '))));
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

std::vector<std::vector<NodePair>> find_node_pairs(const Deck& deck, const ChunkedMesh& chunked,
                                                   const std::vector<PairOfEnds>& entries, const std::string& kind) {
  EndFinder ends(deck, chunked, entries, kind);
  std::vector<std::vector<NodePair>> all;
  for (const PairOfEnds& entry : entries) {
    const std::vector<Item> first = ends.find(entry.between[0]), second = ends.find(entry.between[1]);
    const NearestItems nearest(second);
    const Vec3 shift = entry.are_counterparts ? subtract(find_mean(second), find_mean(first)) : Vec3{};
    std::vector<NodePair>& pairs = all.emplace_back();
    for (const Item& item : first) {
      const Nearest found =
          nearest.find({item.place[0] + shift[0], item.place[1] + shift[1], item.place[2] + shift[2]});
      check_nearest(chunked, deck.where(entry.place), fmt::format("{} '{}'", kind, entry.name), item, found);
      pairs.push_back({item, *std::lower_bound(second.begin(), second.end(), found.number,
                                               [](const Item& i, std::int64_t number) { return i.number < number; })});
    }
    if (entry.are_counterparts)
      check_counterparts(chunked, deck.where(entry.place), fmt::format("{} '{}'", kind, entry.name), second.size(),
                         pairs);
  }
  return all;
}

}  // namespace percuss
