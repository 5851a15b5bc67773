#include "src/mesh/quality/check_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

HexCorners gather_corners(const PartMesh& mesh, std::size_t element) {
  HexCorners x;
  for (std::size_t i = 0; i < 8; ++i) x[i] = mesh.nodes[static_cast<std::size_t>(mesh.elements[element][i])];
  return x;
}

std::string describe_element(std::int64_t id, const HexCorners& corners) {
  Vec3 center{};
  for (const Vec3& x : corners) {
    for (std::size_t d = 0; d < 3; ++d) center[d] += 0.125 * x[d];
  }
  return fmt::format("element {} at ({:.6g}, {:.6g}, {:.6g})", id, center[0], center[1], center[2]);
}

std::string describe_element(const PartMesh& mesh, std::size_t element) {
  return describe_element(id_of(mesh.element_ids, element), gather_corners(mesh, element));
}

/// The same for elements with the same corners, whichever of a triangle's stands twice.
std::array<int, 8> sort_corners(std::array<int, 8> corners) {
  if (is_triangle(corners))
    for (std::size_t i = 3; i < 8; ++i) corners[i] = std::max({corners[0], corners[1], corners[2]});
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The first node that an element names more than once, -1: none. A shell's corners stand twice, the last of a triangle
/// once more.
int find_repeated_node(const std::array<int, 8>& element) {
  const std::size_t count = is_triangle(element) ? 3 : is_shell(element) ? 4 : 8;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (element[i] == element[j]) return element[i];
    }
  }
  return -1;
}

void check_repeated_nodes(const PartMesh& mesh, std::size_t element, Problems& problems) {
  const int repeated = find_repeated_node(mesh.elements[element]);
  if (repeated < 0) return;
  report(problems, [&] {
    return fmt::format("{} names node {} more than once ({}); mesh without degenerate elements",
                       describe_element(mesh, element), id_of(mesh.node_ids, static_cast<std::size_t>(repeated)),
                       is_shell(mesh.elements[element])
                           ? "a shell needs four different corners, or three of which one stands twice in a row"
                           : "a hexahedron needs eight different corners");
  });
}

/// Elements by their lowest node, so that equal ones meet without sorting them all.
Buckets bin_elements(const PartMesh& mesh) {
  return collect_buckets<int>(mesh.nodes.size(), [&](auto&& put) {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      const std::array<int, 8>& corners = mesh.elements[e];
      put(static_cast<std::size_t>(*std::min_element(corners.begin(), corners.end())), static_cast<int>(e));
    }
  });
}

void check_duplicates(const PartMesh& mesh, Problems& problems) {
  using Key = std::pair<std::array<int, 8>, int>;  // sorted corners, element
  const Buckets bins = bin_elements(mesh);
  std::vector<std::pair<int, int>> pairs;  // the later element first
  std::vector<Key> keys;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (bins.first[n + 1] - bins.first[n] < 2) continue;
    keys.clear();
    for (int i = bins.first[n]; i < bins.first[n + 1]; ++i) {
      const int e = bins.items[static_cast<std::size_t>(i)];
      keys.emplace_back(sort_corners(mesh.elements[static_cast<std::size_t>(e)]), e);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < keys.size(); ++i) {
      if (keys[i].first == keys[i - 1].first) pairs.emplace_back(keys[i].second, keys[i - 1].second);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [later, earlier] : pairs) {
    report(problems, [&, e = static_cast<std::size_t>(later), first = static_cast<std::size_t>(earlier)] {
      return fmt::format("{} repeats element {} (both have the same {} corners); delete one of them",
                         describe_element(mesh, e), id_of(mesh.element_ids, first),
                         is_triangle(mesh.elements[e]) ? "three"
                         : is_shell(mesh.elements[e])  ? "four"
                                                       : "eight");
    });
  }
}

enum class Shape8 { good, flat_corner, inverted_corner, zero_volume, inverted };

struct ShapeVerdict {
  Shape8 shape = Shape8::good;
  int corner = 0;
  double value = 0;  // the volume, or the corner's Jacobian over the product of its edges
};

ShapeVerdict judge_shape(const HexCorners& x) {
  double edges = 0;
  ShapeVerdict worst{Shape8::good, 0, 1};
  for (int i = 0; i < 8; ++i) {
    const CornerJacobian jacobian = find_corner_jacobian(x, i);
    edges = std::max(edges, jacobian.edge_product);
    const double scaled = jacobian.edge_product > 0 ? jacobian.value / jacobian.edge_product : 0;
    if (scaled < worst.value) worst = {Shape8::good, i, scaled};
  }
  const double volume = find_hex_volume(x);
  if (volume < -zero_share * edges) return {Shape8::inverted, 0, volume};
  // Written so that a volume that overflowed to NaN is refused as well.
  if (!(volume > zero_share * edges)) return {Shape8::zero_volume, 0, volume};
  if (worst.value < -zero_share) worst.shape = Shape8::inverted_corner;
  if (std::abs(worst.value) <= zero_share) worst.shape = Shape8::flat_corner;
  return worst;
}

std::string describe_verdict(const std::string& element, const std::array<std::int64_t, 8>& node_ids,
                             const ShapeVerdict& verdict) {
  switch (verdict.shape) {
    case Shape8::inverted:
      return fmt::format("{} is inverted (its volume is {:.6g}); check the order of its corners", element,
                         verdict.value);
    case Shape8::zero_volume:
      return fmt::format("{} has no volume (it is {:.6g}); check the places of its corners", element, verdict.value);
    default:
      break;
  }
  return fmt::format(
      "{} is inverted at its corner {}, node {} (the scaled Jacobian there is {:.3g}, it must not be negative)",
      element, verdict.corner + 1, node_ids[static_cast<std::size_t>(verdict.corner)], verdict.value);
}

/// What is wrong with the shape of a shell; empty if nothing.
std::string judge_shell(const std::string& element, const HexCorners& x, const std::array<std::int64_t, 8>& node_ids) {
  const Vec3 normal = find_shell_area(x);
  const double area = std::sqrt(dot(normal, normal));
  const double edges =
      std::max(dot(subtract(x[2], x[0]), subtract(x[2], x[0])), dot(subtract(x[3], x[1]), subtract(x[3], x[1])));
  if (!(area > zero_share * edges)) {
    return fmt::format("{} has no area (it is {:.6g}); check the places of its corners", element, area);
  }
  for (std::size_t i = 0; i < 4 && !is_triangle(node_ids); ++i) {
    const Vec3 corner = cross(subtract(x[(i + 1) % 4], x[i]), subtract(x[(i + 3) % 4], x[i]));
    if (dot(corner, normal) > zero_share * edges * area) continue;
    return fmt::format("{} is not convex at its corner {}, node {} (the angle there must be below 180 degrees)",
                       element, i + 1, node_ids[i]);
  }
  return "";
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

void GeometryFindings::check_element(std::int64_t id, const HexCorners& corners,
                                     const std::array<std::int64_t, 8>& node_ids) {
  if (is_shell(node_ids)) {
    const std::string problem = judge_shell(describe_element(id, corners), corners, node_ids);
    if (!problem.empty()) report(elements, [&] { return problem; });
    return;
  }
  const ShapeVerdict verdict = judge_shape(corners);
  if (verdict.shape == Shape8::good) return;
  if (verdict.shape != Shape8::flat_corner) {
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
                      fmt::format("{} element(s) have a corner without volume, the first is {} (it is at the brink of "
                                  "inversion): repair the mesh there",
                                  flat_corners, first_flat),
                      "", 0, 1});
}

GeometryFindings check_geometry(const PartMesh& mesh) {
  GeometryFindings findings;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) findings.check_node(id_of(mesh.node_ids, n), mesh.nodes[n]);
  for (std::size_t e = 0; findings.nodes.empty() && e < mesh.elements.size(); ++e) {
    std::array<std::int64_t, 8> node_ids{};
    for (std::size_t c = 0; c < 8; ++c) {
      node_ids[c] = id_of(mesh.node_ids, static_cast<std::size_t>(mesh.elements[e][c]));
    }
    findings.check_element(id_of(mesh.element_ids, e), gather_corners(mesh, e), node_ids);
  }
  return findings;
}

}  // namespace percuss
