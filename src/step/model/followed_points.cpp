#include "src/step/model/followed_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>

#include "comm/merge_reduction.hpp"
#include "src/deck/asked_for.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/material_place.hpp"
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

  /// Collects ids; of several with one id the lowest number counts.
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

/// Nodes of an element, of a shell the first four, as corners of a hexahedron or quadrilateral that coincide.
std::array<int, kernel_corner_count> list_shape_nodes(const Mesh& mesh, std::size_t element) {
  using Corners = std::array<std::size_t, kernel_corner_count>;
  constexpr Corners hex{0, 1, 2, 3, 4, 5, 6, 7}, wedge{0, 1, 2, 2, 3, 4, 5, 5}, pyramid{0, 1, 2, 3, 4, 4, 4, 4},
      tet{0, 1, 2, 2, 3, 3, 3, 3}, quad{0, 1, 2, 3, 0, 0, 0, 0}, triangle{0, 1, 2, 2, 0, 0, 0, 0};
  const Topology& topology = mesh.topology_of(element);
  const Corners& corners = topology.is_surface()        ? (topology.corner_count == 4 ? quad : triangle)
                           : topology.corner_count == 8 ? hex
                           : topology.corner_count == 6 ? wedge
                           : topology.corner_count == 5 ? pyramid
                                                        : tet;
  std::array<int, kernel_corner_count> nodes{};
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = mesh.corners(element)[corners[i]];
  return nodes;
}

/// Whether a place may be inside an element, or nearest to it on the middle surface of a shell; its distance from it,
/// 0 where it is inside. Beams have no inside.
struct Holder {
  bool is_held = false;
  double distance = 0;
  MaterialPlace place;
};
Holder find_held(const Mesh& mesh, std::size_t element, const Vec3& place) {
  constexpr double round_off = 1e-6;  // share of the diagonal of the element
  const Topology& topology = mesh.topology_of(element);
  if (topology.is_line()) return {};
  ElementCorners x;
  const auto nodes = list_shape_nodes(mesh, element);
  for (std::size_t i = 0; i < nodes.size(); ++i) x[i] = mesh.nodes[static_cast<std::size_t>(nodes[i])];
  Vec3 low = x[0], high = x[0];
  for (const Vec3& corner : x) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], corner[d]);
      high[d] = std::max(high[d], corner[d]);
    }
  }
  const double near = round_off * find_distance(low, high);
  const double margin = near + (topology.is_surface() ? 0.5 * mesh.thickness_of(element) : 0);
  for (std::size_t d = 0; d < 3; ++d)
    if (place[d] < low[d] - margin || place[d] > high[d] + margin) return {};
  const MaterialPlace found = find_material_place(x, topology.is_surface(), place);
  return {found.distance <= margin, found.distance <= near ? 0 : found.distance, found};
}

/// The element of this rank that holds a material point.
Nearest find_holder(const ChunkedMesh& chunked, const HistoryPoint& point) {
  const Mesh& mesh = chunked.mesh;
  Nearest nearest;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const std::string& part = mesh.parts[static_cast<std::size_t>(mesh.part_of(e))].name;
    if (!point.part.empty() && part != point.part) continue;
    const Holder held = find_held(mesh, e, *point.near);
    if (held.is_held) nearest.merge({held.distance, find_element_number(chunked, static_cast<int>(e))});
  }
  return nearest;
}

/// The corners of the element that holds it, with their weights.
std::vector<std::pair<int, double>> list_shares(const Mesh& mesh, std::size_t element, const HistoryPoint& point) {
  const MaterialPlace place = find_held(mesh, element, *point.near).place;
  std::vector<std::pair<int, double>> shares;
  const auto nodes = list_shape_nodes(mesh, element);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (place.weights[i] != 0) shares.emplace_back(nodes[i], place.weights[i]);
  return shares;
}

/// Inputs of the search for a point.
struct Search {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const std::string& kind;
};

/// Why nothing was found for a point.
[[noreturn]] void refuse(const Search& search, const HistoryPoint& point) {
  const char* const item = point.is_element ? "element" : "node";
  if (point.is_inside)
    throw InputError(
        fmt::format("{}: error: no element {}holds the place [{:g}, {:g}, {:g}] at time 0 ({} '{}'): "
                    "correct it, or follow a node",
                    search.deck.where(point.place), point.part.empty() ? "" : "of part '" + point.part + "' ",
                    (*point.near)[0], (*point.near)[1], (*point.near)[2], search.kind, point.name));
  const std::string what = point.near ? fmt::format("no {} is near [{:g}, {:g}, {:g}]", item, (*point.near)[0],
                                                    (*point.near)[1], (*point.near)[2])
                                      : fmt::format("no {} has the id {}", item, point.id.value_or(0));
  throw InputError(fmt::format("{}: error: {} ({} '{}'{})", search.deck.where(point.place), what, search.kind,
                               point.name, point.near ? "; squares of distances overflow" : ""));
}

FollowedPoint follow(const Search& search, const HistoryPoint& point, const Nearest& nearest) {
  const ChunkedMesh& chunked = search.chunked;
  if (nearest.score == std::numeric_limits<double>::infinity()) refuse(search, point);
  FollowedPoint found{point.name, point.is_element, nearest.number, -1, point.layer ? *point.layer - 1 : -1};
  found.is_inside = point.is_inside;
  if (point.is_inside) {
    found.index = find_local_element(chunked, nearest.number);
    if (found.index >= 0) found.shares = list_shares(chunked.mesh, static_cast<std::size_t>(found.index), point);
  } else if (point.is_element) {
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
    if (point.is_inside) {
      nearest.push_back(find_holder(chunked, point));
      continue;
    }
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
