#include "src/step/model/followed_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "comm/merge_reduction.hpp"
#include "src/deck/asked_for.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/nearest_items.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Nodes or elements of this rank among which points of the deck are searched: of one part, or of all.
class SearchedItems {
 public:
  SearchedItems(const ChunkedMesh& chunked, const Deck& deck, const HistoryPoint& point, const std::string& kind)
      : chunked_(chunked), is_element_(point.is_element), searched_(find_searched(chunked.mesh, deck, point, kind)) {}

  Nearest find(const HistoryPoint& point) {
    if (point.near) {
      if (!places_) places_.emplace(list_items());
      return places_->find(*point.near);
    }
    if (!are_ids_known_) collect_ids();
    const auto found = numbers_of_ids_.find(*point.id);
    return found == numbers_of_ids_.end() ? Nearest{} : Nearest{0, found->second};
  }

 private:
  /// [elements or nodes of this rank] whether the point may be it; every one if it names no part.
  static std::vector<bool> find_searched(const Mesh& mesh, const Deck& deck, const HistoryPoint& point,
                                         const std::string& kind) {
    std::vector<bool> elements(mesh.elements.size(), point.part.empty());
    if (!point.part.empty()) {
      const auto part =
          std::find_if(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& p) { return p.name == point.part; });
      if (part == mesh.parts.end()) {
        throw InputError(fmt::format("{}: error: no part is called '{}' ({} '{}')", deck.where(point.place), point.part,
                                     kind, point.name));
      }
      for (std::size_t e = 0; e < elements.size(); ++e) elements[e] = mesh.part_of(e) == part - mesh.parts.begin();
    }
    if (point.is_element) return elements;
    std::vector<bool> nodes(mesh.nodes.size(), false);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (!elements[e]) continue;
      for (const int n : mesh.corners(e)) nodes[static_cast<std::size_t>(n)] = true;
    }
    return nodes;
  }

  std::int64_t find_number(std::size_t i) const {
    return is_element_ ? find_element_number(chunked_, static_cast<int>(i)) : chunked_.mesh.node_numbers[i];
  }

  std::vector<Item> list_items() const {
    const Mesh& mesh = chunked_.mesh;
    std::vector<Item> items;
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      if (!searched_[i]) continue;
      items.push_back(
          {is_element_ ? find_center(gather_corners(mesh.elements, i, mesh.nodes)) : mesh.nodes[i], find_number(i)});
    }
    return items;
  }

  /// Of several with one id the lowest number counts.
  void collect_ids() {
    const auto& ids = is_element_ ? chunked_.mesh.element_ids : chunked_.mesh.node_ids;
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      if (!searched_[i]) continue;
      const auto [entry, is_new] = numbers_of_ids_.try_emplace(ids[i], find_number(i));
      if (!is_new) entry->second = std::min(entry->second, find_number(i));
    }
    are_ids_known_ = true;
  }

  const ChunkedMesh& chunked_;
  bool is_element_, are_ids_known_ = false;
  std::vector<bool> searched_;
  std::optional<NearestItems> places_;
  std::unordered_map<std::int64_t, std::int64_t> numbers_of_ids_;
};

/// What a point is found for.
struct Search {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const std::string& kind;
};

/// Why nothing was found for a point.
[[noreturn]] void refuse(const Search& search, const HistoryPoint& point) {
  const char* const item = point.is_element ? "element" : "node";
  const std::string what = point.near ? fmt::format("no {} is near [{:g}, {:g}, {:g}]", item, (*point.near)[0],
                                                    (*point.near)[1], (*point.near)[2])
                                      : fmt::format("no {} has the id {}", item, point.id.value_or(0));
  throw InputError(fmt::format("{}: error: {} ({} '{}'{})", search.deck.where(point.place), what, search.kind,
                               point.name, point.near ? "; squares of distances overflow" : ""));
}

FollowedPoint follow(const Search& search, const HistoryPoint& point, const Nearest& nearest) {
  const ChunkedMesh& chunked = search.chunked;
  if (nearest.score == std::numeric_limits<double>::infinity()) refuse(search, point);
  FollowedPoint found{point.name, point.is_element, nearest.number, -1};
  if (point.is_element) {
    found.index = find_local_element(chunked, nearest.number);
  } else if (chunked.numbering.find_node_owner(nearest.number) == find_ranks(chunked.mesh).rank()) {
    found.index = find_local_node(chunked, nearest.number);
  }
  return found;
}

}  // namespace

std::vector<FollowedPoint> find_points(const Deck& deck, const ChunkedMesh& chunked,
                                       const std::vector<HistoryPoint>& points, const std::string& kind) {
  std::map<std::pair<bool, std::string>, SearchedItems> searched;  // by kind and part
  std::vector<Nearest> nearest;
  for (const HistoryPoint& point : points) {
    const std::pair key(point.is_element, point.part);
    auto items = searched.find(key);
    if (items == searched.end()) items = searched.try_emplace(key, chunked, deck, point, kind).first;
    nearest.push_back(items->second.find(point));
  }
  if (points.empty()) return {};
  MergeReduction<Nearest>()(find_ranks(chunked.mesh), std::span(nearest));
  std::vector<FollowedPoint> followed;
  for (std::size_t i = 0; i < points.size(); ++i)
    followed.push_back(follow({deck, chunked, kind}, points[i], nearest[i]));
  return followed;
}

std::vector<FollowedPoint> find_history_points(const Deck& deck, const ChunkedMesh& chunked) {
  std::vector<HistoryPoint> points;
  for (const HistoryPoint& point : deck.output.points)
    if (!names_parts(point)) points.push_back(point);
  return find_points(deck, chunked, points, "history point");
}

}  // namespace percuss
