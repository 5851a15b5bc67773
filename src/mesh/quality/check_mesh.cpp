#include "src/mesh/quality/check_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernels/core/counting_sort.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Share of the product of edge lengths below which a volume or a Jacobian is round-off. Coordinates carry 1e-16 of the
/// distance to the origin, which may be 1e4 element sizes away.
constexpr double zero_share = 1e-10;

/// Adds the text that `compose` returns, if it will be shown.
template <class Compose>
void report(Problems& problems, const Compose& compose) {
  if (problems.shows_next()) {
    problems.add(compose());
  } else {
    problems.add_unshown();
  }
}

std::string describe_element(std::int64_t id, const ElementCorners& corners) {
  const Vec3 center = find_center(corners);
  return fmt::format("element {} at ({:.6g}, {:.6g}, {:.6g})", id, center[0], center[1], center[2]);
}

std::string describe_element(const PartMesh& mesh, std::size_t element) {
  return describe_element(id_of(mesh.element_ids, element), gather_corners(mesh.elements, element, mesh.nodes));
}

/// Equal for elements of one topology with the same corners.
using CornerKey = std::pair<TopologyKind, std::array<int, most_corners>>;

CornerKey make_key(const Elements& elements, std::size_t element) {
  CornerKey key{elements.block_of(element).topology, {}};
  const std::span<const int> corners = elements.corners(element);
  key.second.fill(-1);
  std::copy(corners.begin(), corners.end(), key.second.begin());
  std::sort(key.second.begin(), key.second.end());
  return key;
}

/// The first node that an element names more than once, -1: none.
int find_repeated_node(std::span<const int> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (corners[i] == corners[j]) return corners[i];
    }
  }
  return -1;
}

void check_repeated_nodes(const PartMesh& mesh, std::size_t element, Problems& problems) {
  const int repeated = find_repeated_node(mesh.elements.corners(element));
  if (repeated < 0) return;
  report(problems, [&] {
    const Topology& topology = mesh.elements.topology_of(element);
    return fmt::format("{} names node {} more than once ({}): mesh without degenerate elements",
                       describe_element(mesh, element), id_of(mesh.node_ids, static_cast<std::size_t>(repeated)),
                       topology.is_surface()
                           ? "a shell needs four different corners, or three of which one stands twice in a row"
                           : fmt::format("a {} needs {} different {}", topology.noun, topology.how_many,
                                         topology.is_line() ? "nodes" : "corners"));
  });
}

/// Elements by their lowest node, so that equal ones meet without sorting them all.
Buckets bin_elements(const PartMesh& mesh) {
  return collect_buckets<int>(mesh.nodes.size(), [&](auto&& put) {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      const std::span<const int> corners = mesh.elements.corners(e);
      put(static_cast<std::size_t>(*std::min_element(corners.begin(), corners.end())), static_cast<int>(e));
    }
  });
}

void check_duplicates(const PartMesh& mesh, Problems& problems) {
  using Key = std::pair<CornerKey, int>;  // and the element
  const Buckets bins = bin_elements(mesh);
  std::vector<std::pair<int, int>> pairs;  // the later element first
  std::vector<Key> keys;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (bins.first[n + 1] - bins.first[n] < 2) continue;
    keys.clear();
    for (int i = bins.first[n]; i < bins.first[n + 1]; ++i) {
      const int e = bins.items[static_cast<std::size_t>(i)];
      keys.emplace_back(make_key(mesh.elements, static_cast<std::size_t>(e)), e);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < keys.size(); ++i) {
      if (keys[i].first == keys[i - 1].first) pairs.emplace_back(keys[i].second, keys[i - 1].second);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [later, earlier] : pairs) {
    report(problems, [&, e = static_cast<std::size_t>(later), first = static_cast<std::size_t>(earlier)] {
      return fmt::format("{} repeats element {} (both have the same {} corners): delete one of them",
                         describe_element(mesh, e), id_of(mesh.element_ids, first),
                         mesh.elements.topology_of(e).how_many);
    });
  }
}

enum class SolidShape { good, flat_corner, inverted_corner, zero_volume, inverted };

struct ShapeVerdict {
  SolidShape shape = SolidShape::good;
  int corner = 0;
  double value = 0;  // the volume, or the corner's Jacobian over the product of its edges
};

ShapeVerdict judge_shape(const Topology& topology, const ElementCorners& x) {
  double edges = 0;
  ShapeVerdict worst{SolidShape::good, 0, 1};
  for (int i = 0; i < topology.corner_count; ++i) {
    const CornerJacobian jacobian = find_corner_jacobian(topology, x, i);
    edges = std::max(edges, jacobian.edge_product);
    const double scaled = jacobian.edge_product > 0 ? jacobian.value / jacobian.edge_product : 0;
    if (scaled < worst.value) worst = {SolidShape::good, i, scaled};
  }
  const double volume = find_solid_volume(topology, x);
  if (volume < -zero_share * edges) return {SolidShape::inverted, 0, volume};
  // Written so that a volume that overflowed to NaN is refused as well.
  if (!(volume > zero_share * edges)) return {SolidShape::zero_volume, 0, volume};
  if (worst.value < -zero_share) worst.shape = SolidShape::inverted_corner;
  if (std::abs(worst.value) <= zero_share) worst.shape = SolidShape::flat_corner;
  return worst;
}

std::string describe_verdict(const std::string& element, std::span<const std::int64_t> node_ids,
                             const ShapeVerdict& verdict) {
  switch (verdict.shape) {
    case SolidShape::inverted:
      return fmt::format("{} is inverted (its volume is {:.6g}): check the order of its corners", element,
                         verdict.value);
    case SolidShape::zero_volume:
      return fmt::format("{} has no volume (it is {:.6g}): check the places of its corners", element, verdict.value);
    default:
      break;
  }
  return fmt::format(
      "{} is inverted at its corner {}, node {} (the scaled Jacobian there is {:.3g}, it must not be negative)",
      element, verdict.corner + 1, node_ids[static_cast<std::size_t>(verdict.corner)], verdict.value);
}

/// Fault of the shape of a shell; empty if there is none.
std::string judge_shell(const std::string& element, const ElementCorners& x, std::span<const std::int64_t> node_ids) {
  const Vec3 normal = find_shell_area(x);
  const double area = std::sqrt(dot(normal, normal));
  const double edges =
      std::max(dot(subtract(x[2], x[0]), subtract(x[2], x[0])), dot(subtract(x[3], x[1]), subtract(x[3], x[1])));
  if (!(area > zero_share * edges)) {
    return fmt::format("{} has no area (it is {:.6g}): check the places of its corners", element, area);
  }
  for (std::size_t i = 0; node_ids.size() == 4 && i < 4; ++i) {  // a triangle is convex
    const Vec3 corner = cross(subtract(x[(i + 1) % 4], x[i]), subtract(x[(i + 3) % 4], x[i]));
    if (dot(corner, normal) > zero_share * edges * area) continue;
    return fmt::format("{} is not convex at its corner {}, node {} (the angle there must be below 180 degrees)",
                       element, i + 1, node_ids[i]);
  }
  return "";
}

/// Fault of a beam; empty if there is none.
std::string judge_beam(const std::string& element, const ElementCorners& x) {
  constexpr double round_off = 1e-13;  // share of the distance to the origin
  const double length = find_distance(x[0], x[1]);
  if (length > round_off * std::sqrt(dot(x[0], x[0]))) return "";
  return fmt::format("{} has no length (it is {:.6g}): check the places of its nodes", element, length);
}

}  // namespace

void Problems::append(const Problems& later) {
  for (const std::string& text : later.texts_) {
    if (shows_next()) texts_.push_back(text);
  }
  count_ += later.count_;
}

Problems Problems::restore(std::vector<std::string> texts, std::size_t count) {
  Problems problems;
  problems.texts_ = std::move(texts);
  problems.count_ = count;
  return problems;
}

std::string Problems::join(const std::string& prefix) const {
  std::string joined;
  for (const std::string& text : texts_) joined += fmt::format("{}{}{}", joined.empty() ? "" : "\n", prefix, text);
  if (count_ > texts_.size()) joined += fmt::format("\n{}and {} more like these", prefix, count_ - texts_.size());
  return joined;
}

void check_connectivity(const PartMesh& mesh, Problems& problems) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) check_repeated_nodes(mesh, e, problems);
  check_duplicates(mesh, problems);
}

void GeometryFindings::check_node(std::int64_t id, const Vec3& x) {
  if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2])) return;
  report(nodes, [&] {
    return fmt::format("node {} lies at ({}, {}, {}) (coordinates must be finite)", id, x[0], x[1], x[2]);
  });
}

void GeometryFindings::check_element(const Topology& topology, std::int64_t id, const ElementCorners& corners,
                                     std::span<const std::int64_t> node_ids) {
  if (!topology.is_solid()) {
    const std::string element = describe_element(id, corners);
    const std::string problem =
        topology.is_surface() ? judge_shell(element, corners, node_ids) : judge_beam(element, corners);
    if (!problem.empty()) report(elements, [&] { return problem; });
    return;
  }
  const ShapeVerdict verdict = judge_shape(topology, corners);
  if (verdict.shape == SolidShape::good) return;
  if (verdict.shape != SolidShape::flat_corner) {
    report(elements, [&] { return describe_verdict(describe_element(id, corners), node_ids, verdict); });
  } else if (flat_corners++ == 0) {
    first_flat = describe_element(id, corners);
  }
}

void GeometryFindings::append(const GeometryFindings& later) {
  nodes.append(later.nodes);
  elements.append(later.elements);
  if (flat_corners == 0) first_flat = later.first_flat;
  flat_corners += later.flat_corners;
}

void GeometryFindings::warn(std::vector<Warning>& warnings) const {
  if (flat_corners == 0) return;
  warnings.push_back({"flat_corner",
                      fmt::format("{} element(s) have a corner without volume, the first is {} (it is on the verge of "
                                  "inversion): repair the mesh there",
                                  flat_corners, first_flat),
                      "", 0, 1});
}

GeometryFindings check_geometry(const PartMesh& mesh) {
  GeometryFindings findings;
  std::vector<std::int64_t> node_ids;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) findings.check_node(id_of(mesh.node_ids, n), mesh.nodes[n]);
  for (std::size_t e = 0; findings.nodes.empty() && e < mesh.elements.size(); ++e) {
    node_ids.clear();
    for (const int n : mesh.elements.corners(e)) node_ids.push_back(id_of(mesh.node_ids, static_cast<std::size_t>(n)));
    findings.check_element(mesh.elements.topology_of(e), id_of(mesh.element_ids, e),
                           gather_corners(mesh.elements, e, mesh.nodes), node_ids);
  }
  return findings;
}

}  // namespace percuss
