#include "src/step/springs/weld_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/joints/joint_rows.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// Points on the shortest edge of the faces, and how many rings of them a disc has.
constexpr double points_per_edge = 3;
constexpr int least_rings = 8, most_rings = 64;

/// Tolerance of a point outside a face, in the face's coordinates of -1 to 1.
constexpr double rim = 1e-9;

/// Faces whose distances differ by less than this share of the radius, such as those around an edge, are nearest
/// together.
constexpr double same_distance = 1e-9;

/// A face around an end of a weld, as all ranks know it.
struct NearFace {
  std::int64_t end = 0;  // twice the spot, and the end
  std::int64_t element = 0;
  std::int64_t face = 0;
  std::array<std::int64_t, 4> node{};
  std::array<Vec3, 4> x{};
};

Vec3 scale(double by, const Vec3& a) { return {by * a[0], by * a[1], by * a[2]}; }

Vec3 make_unit(const Vec3& a) { return scale(1 / std::sqrt(dot(a, a)), a); }

/// Twice the area, along the normal.
Vec3 find_area(const std::array<Vec3, 4>& x) { return cross(subtract(x[2], x[0]), subtract(x[3], x[1])); }

/// Nearest point of a face as contact sees it: a fan of four triangles around its middle.
Vec3 find_nearest(const std::array<Vec3, 4>& x, const Vec3& place) {
  FacePoints face;
  for (std::size_t i = 0; i < 4; ++i) face.corner[i] = to_vector(subtract(x[i], place));
  const FacePoint nearest = find_closest_point(face);
  Vec3 sum{};
  for (std::size_t i = 0; i < 4; ++i) sum = add(sum, scale(nearest.weight[i], x[i]));
  return sum;
}

/// Not farther than a face is from a place.
double find_box_distance(const std::array<Vec3, 4>& x, const Vec3& place) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax({x[0][k], x[1][k], x[2][k], x[3][k]});
    const double outside = std::max({low - place[k], place[k] - high, 0.0});
    square += outside * outside;
  }
  return std::sqrt(square);
}

std::array<Vec3, 4> find_corners(const Mesh& mesh, const ElementFace& face) {
  const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
  return {mesh.nodes[at(nodes[0])], mesh.nodes[at(nodes[1])], mesh.nodes[at(nodes[2])], mesh.nodes[at(nodes[3])]};
}

/// [ends] distance of the nearest of the faces of this rank.
double find_own_distance(const Mesh& mesh, const std::vector<ElementFace>& faces, const Vec3& place) {
  double least = none;
  for (const ElementFace& face : faces) {
    const std::array<Vec3, 4> x = find_corners(mesh, face);
    if (find_box_distance(x, place) < least) least = std::min(least, find_distance(find_nearest(x, place), place));
  }
  return least;
}

/// The faces around ends within reach, on all ranks, by end, element and face. Collective.
std::vector<NearFace> gather_faces(const ChunkedMesh& chunked, const std::vector<WeldSpot>& spots,
                                   const std::vector<std::vector<ElementFace>>& faces,
                                   const std::vector<double>& distance, double reach) {
  const Mesh& mesh = chunked.mesh;
  std::vector<NearFace> own;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const WeldSpot& spot = spots[i / 2];
    if (distance[i] > reach * spot.radius) continue;
    for (const ElementFace& face : faces[spot.faces[i % 2]]) {
      NearFace near{static_cast<std::int64_t>(i), find_element_number(chunked, face.element), face.face, {}, {}};
      near.x = find_corners(mesh, face);
      if (find_box_distance(near.x, spot.at) > distance[i] + 2 * spot.radius) continue;
      const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
      for (std::size_t k = 0; k < 4; ++k) near.node[k] = mesh.node_numbers[at(nodes[k])];
      own.push_back(near);
    }
  }
  std::vector<NearFace> all = gather_items(find_ranks(mesh), own);
  std::sort(all.begin(), all.end(), [](const NearFace& a, const NearFace& b) {
    return std::tie(a.end, a.element, a.face) < std::tie(b.end, b.element, b.face);
  });
  return all;
}

/// A disc with its axes: two in its plane, then its normal.
struct Disc {
  Vec3 center{};
  std::array<Vec3, 3> axes{};
};

/// Around the nearest point, across the mean normal of the faces that are nearest.
Disc find_disc(std::span<const NearFace> faces, const WeldSpot& spot, double distance) {
  Disc disc;
  Vec3 area{};
  bool is_found = false;
  for (const NearFace& face : faces) {
    const Vec3 nearest = find_nearest(face.x, spot.at);
    if (find_distance(nearest, spot.at) > distance + same_distance * spot.radius) continue;
    const Vec3 more = find_area(face.x);
    area = add(area, scale(is_found && dot(area, more) < 0 ? -1 : 1, more));
    if (!is_found) disc.center = nearest;
    is_found = true;
  }
  const Vec3& normal = disc.axes[2] = make_unit(area);
  const std::array<Vector3<double>, 2> sides = find_sides(to_vector(normal));
  for (std::size_t k = 0; k < 2; ++k) disc.axes[k] = {sides[k].x, sides[k].y, sides[k].z};
  return disc;
}

/// A face seen along the normal of a disc: across its two axes, then along its normal.
class ProjectedFace {
 public:
  ProjectedFace(const NearFace& face, const Disc& disc) : face_(&face) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 from = subtract(face.x[i], disc.center);
      for (std::size_t k = 0; k < 3; ++k) x_[i][k] = dot(from, disc.axes[k]);
    }
  }

  const NearFace& face() const { return *face_; }

  double find_shortest_edge() const {
    double shortest = none;
    for (std::size_t i = 0; i < 4; ++i)
      if (face_->node[i] != face_->node[(i + 1) % 4])
        shortest = std::min(shortest, find_distance(x_[i], x_[(i + 1) % 4]));
    return shortest;
  }

  /// Shape functions of its corners at a place of the disc; returns its height above it there, endless if it is
  /// beside the face.
  double project(double u, double v, std::array<double, 4>& shape) const {
    for (std::size_t k = 0; k < 2; ++k) {
      const double place = k == 0 ? u : v;
      const auto [low, high] = std::minmax({x_[0][k], x_[1][k], x_[2][k], x_[3][k]});
      const double slack = rim * (high - low);
      if (place < low - slack || place > high + slack) return none;
    }
    constexpr int most_steps = 30;
    double a = 0, b = 0;
    for (int step = 0; step < most_steps; ++step) {
      const std::array<double, 2> change = find_step(a, b, u, v);
      if (!std::isfinite(change[0] + change[1])) return none;
      a += change[0];
      b += change[1];
      if (std::abs(change[0]) + std::abs(change[1]) < 0.01 * rim) break;
    }
    if (!(std::abs(a) <= 1 + rim && std::abs(b) <= 1 + rim)) return none;
    shape = find_shape(a, b);
    return shape[0] * x_[0][2] + shape[1] * x_[1][2] + shape[2] * x_[2][2] + shape[3] * x_[3][2];
  }

 private:
  static std::array<double, 4> find_shape(double a, double b) {
    return {0.25 * (1 - a) * (1 - b), 0.25 * (1 + a) * (1 - b), 0.25 * (1 + a) * (1 + b), 0.25 * (1 - a) * (1 + b)};
  }

  /// Step of Newton's method for the coordinates within the face.
  std::array<double, 2> find_step(double a, double b, double u, double v) const {
    const std::array<double, 4> shape = find_shape(a, b);
    const double by_a[4] = {-0.25 * (1 - b), 0.25 * (1 - b), 0.25 * (1 + b), -0.25 * (1 + b)},
                 by_b[4] = {-0.25 * (1 - a), -0.25 * (1 + a), 0.25 * (1 + a), 0.25 * (1 - a)};
    double lack[2] = {u, v}, j[2][2] = {};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        lack[k] -= shape[i] * x_[i][k];
        j[k][0] += by_a[i] * x_[i][k];
        j[k][1] += by_b[i] * x_[i][k];
      }
    }
    const double determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    return {(lack[0] * j[1][1] - lack[1] * j[0][1]) / determinant,
            (lack[1] * j[0][0] - lack[0] * j[1][0]) / determinant};
  }

  const NearFace* face_;
  std::array<Vec3, 4> x_{};
};

/// Adds up shape functions over points of a disc.
class RegionSums {
 public:
  void add(const NearFace& face, const std::array<double, 4>& shape) {
    ++points_;
    for (std::size_t i = 0; i < 4; ++i) {
      weights_[face.node[i]] += shape[i];
      for (std::size_t j = 0; j < 4; ++j) products_[{face.node[i], face.node[j]}] += shape[i] * shape[j];
    }
  }

  int points() const { return points_; }

  void take(WeldRegion& region) const {
    std::map<std::int64_t, int> place;
    for (const auto& [node, sum] : weights_) {
      place[node] = static_cast<int>(region.nodes.size());
      region.nodes.push_back(node);
      region.weights.push_back(sum / points_);
    }
    for (const auto& [nodes, sum] : products_)
      region.products.push_back({place.at(nodes.first), place.at(nodes.second), sum / points_});
  }

 private:
  int points_ = 0;
  std::map<std::int64_t, double> weights_;
  std::map<std::pair<std::int64_t, std::int64_t>, double> products_;
};

/// Adds the face at a place of the disc that is nearest to its plane, if there is one within its radius.
void add_point(const std::vector<ProjectedFace>& faces, double radius, const std::array<double, 2>& place,
               RegionSums& sums) {
  const ProjectedFace* nearest = nullptr;
  std::array<double, 4> shape{}, found{};
  for (const ProjectedFace& face : faces) {
    const double height = std::abs(face.project(place[0], place[1], found));
    if (!(height < radius)) continue;
    radius = height;
    nearest = &face;
    shape = found;
  }
  if (nearest != nullptr) sums.add(nearest->face(), shape);
}

/// Ring m of M has 6 (2 m + 1) points, all with the same area, at the root of the mean square of its radii.
WeldRegion find_region(std::span<const NearFace> faces, const WeldSpot& spot, double distance) {
  WeldRegion region;
  region.distance = distance;
  const Disc disc = find_disc(faces, spot, distance);
  region.nearest = disc.center;
  region.normal = disc.axes[2];
  std::vector<ProjectedFace> projected;
  double edge = none;
  for (const NearFace& face : faces) {
    projected.emplace_back(face, disc);
    edge = std::min(edge, projected.back().find_shortest_edge());
  }
  const double wanted = std::ceil(points_per_edge * spot.radius / edge);
  const int rings = static_cast<int>(std::clamp(wanted, double{least_rings}, double{most_rings}));
  RegionSums sums;
  int count = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double radius = spot.radius * std::sqrt(ring * ring + ring + 0.5) / rings;
    const int on_ring = 6 * (2 * ring + 1);
    count += on_ring;
    for (int i = 0; i < on_ring; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / on_ring;
      add_point(projected, spot.radius, {radius * std::cos(angle), radius * std::sin(angle)}, sums);
    }
  }
  region.covered = static_cast<double>(sums.points()) / count;
  if (sums.points() > 0) sums.take(region);
  return region;
}

}  // namespace

std::vector<std::array<WeldRegion, 2>> find_weld_regions(const ChunkedMesh& chunked, const std::vector<WeldSpot>& spots,
                                                         const std::vector<std::vector<ElementFace>>& faces,
                                                         double reach) {
  std::vector<double> distance;
  for (const WeldSpot& spot : spots)
    for (const std::size_t end : spot.faces) distance.push_back(find_own_distance(chunked.mesh, faces[end], spot.at));
  all_reduce(find_ranks(chunked.mesh), Reduce::least, distance);
  const std::vector<NearFace> near = gather_faces(chunked, spots, faces, distance, reach);
  std::vector<std::array<WeldRegion, 2>> regions(spots.size());
  std::size_t first = 0;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    std::size_t last = first;
    while (last < near.size() && at(near[last].end) == i) ++last;
    WeldRegion& region = regions[i / 2][i % 2];
    region.distance = distance[i];
    if (last > first) region = find_region({near.data() + first, last - first}, spots[i / 2], distance[i]);
    first = last;
  }
  return regions;
}

}  // namespace percuss
