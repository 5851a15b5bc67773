#include "src/mesh/parts/fall_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

Vec3 step_along(const Vec3& x, const Vec3& direction, double way) {
  return {x[0] + way * direction[0], x[1] + way * direction[1], x[2] + way * direction[2]};
}

Vec3 without(const Vec3& x, const Vec3& axis) { return step_along(x, axis, -dot(x, axis)); }

/// Where a point that moves along a line comes within a distance of the origin, or of an axis through it: the first
/// root of |x + s d| = r.
double find_entry(const Vec3& x, const Vec3& d, double radius) {
  const double a = dot(d, d), b = dot(x, d), c = dot(x, x) - radius * radius;
  const double square = b * b - a * c;
  if (!(a > 0) || square < 0) return never;
  const double root = std::sqrt(square);
  return b > 0 ? (-b - root) / a : c / (-b + root);  // without cancellation
}

/// Whether a point is within a finite wall, along its axes.
bool is_within(const WallDeck& wall, const Vec3& x) {
  const Vec3 from = subtract(x, wall.point);
  if (wall.cylinder) {
    const double along = dot(from, wall.cylinder->axis);
    return !wall.cylinder->length || (along >= 0 && along <= *wall.cylinder->length);
  }
  if (!wall.rectangle) return true;
  const double first = dot(from, wall.rectangle->along), second = dot(from, cross(wall.normal, wall.rectangle->along));
  return first >= 0 && first <= wall.rectangle->size[0] && second >= 0 && second <= wall.rectangle->size[1];
}

double find_way_to_wall(const WallDeck& wall, const Vec3& x, const Vec3& direction, double distance) {
  const Vec3 from = subtract(x, wall.point);
  if (wall.sphere) return find_entry(from, direction, wall.sphere->radius + distance);
  if (wall.cylinder) {
    const Vec3& axis = wall.cylinder->axis;
    return find_entry(without(from, axis), without(direction, axis), wall.cylinder->radius + distance);
  }
  const double approach = -dot(wall.normal, direction);
  return approach > 0 ? (dot(wall.normal, from) - distance) / approach : never;
}

/// Coordinates across the direction.
using Point2 = std::array<double, 2>;

Point2 minus(const Point2& a, const Point2& b) { return {a[0] - b[0], a[1] - b[1]}; }
double cross2(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// A triangle seen along the direction.
struct ProjectedTriangle {
  std::array<Point2, 3> across{};
  std::array<double, 3> along{};
  std::array<Vec3, 3> corners{};
  Point2 low{}, high{};
  double half_thickness = 0;
};

/// Axes across the direction.
std::array<Vec3, 2> find_axes(const Vec3& direction) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) least = std::abs(direction[k]) < std::abs(direction[least]) ? k : least;
  Vec3 axis{};
  axis[least] = 1;
  const Vec3 raw = cross(direction, axis);
  const double length = std::sqrt(dot(raw, raw));
  const Vec3 first{raw[0] / length, raw[1] / length, raw[2] / length};
  return {first, cross(direction, first)};
}

ProjectedTriangle project(const FallingTriangle& triangle, const Vec3& direction, const std::array<Vec3, 2>& axes) {
  ProjectedTriangle projected;
  projected.corners = triangle.corners;
  projected.half_thickness = triangle.half_thickness;
  projected.low = {never, never};
  projected.high = {-never, -never};
  for (std::size_t c = 0; c < 3; ++c) {
    projected.along[c] = dot(triangle.corners[c], direction);
    for (std::size_t k = 0; k < 2; ++k) {
      projected.across[c][k] = dot(triangle.corners[c], axes[k]);
      projected.low[k] = std::min(projected.low[k], projected.across[c][k]);
      projected.high[k] = std::max(projected.high[k], projected.across[c][k]);
    }
  }
  return projected;
}

/// Part of the distance that thicknesses take, across a common normal.
double find_thickness_along(const Vec3& normal, const Vec3& direction, double thickness) {
  if (thickness == 0) return 0;
  const double part = std::abs(dot(normal, direction)), length = std::sqrt(dot(normal, normal));
  return part > 0 ? thickness * length / part : 0;
}

/// Way between a corner of one triangle and the face of another.
double find_way_to_face(const Point2& point, const ProjectedTriangle& face, double& along) {
  const auto& [a, b, c] = face.across;
  const double area = cross2(minus(b, a), minus(c, a));
  if (area == 0) return never;  // seen from its edge
  const double u = cross2(minus(b, point), minus(c, point)) / area, v = cross2(minus(c, point), minus(a, point)) / area;
  const double w = cross2(minus(a, point), minus(b, point)) / area;
  constexpr double slack = -1e-12;  // a corner on an edge is on the face
  if (u < slack || v < slack || w < slack) return never;
  along = u * face.along[0] + v * face.along[1] + w * face.along[2];
  return 0;
}

/// Shortest fall of all corners of one triangle over the other. sign: 1 where the corners fall.
double find_way_of_corners(const ProjectedTriangle& corners, const ProjectedTriangle& face, double sign,
                           const Vec3& direction) {
  const Vec3 normal = cross(subtract(face.corners[1], face.corners[0]), subtract(face.corners[2], face.corners[0]));
  const double taken = find_thickness_along(normal, direction, corners.half_thickness + face.half_thickness);
  double least = never;
  for (std::size_t c = 0; c < 3; ++c) {
    double along = 0;
    if (find_way_to_face(corners.across[c], face, along) == 0)
      least = std::min(least, sign * (along - corners.along[c]) - taken);
  }
  return least;
}

/// Fall between two edges that cross in the projection.
double find_way_of_edges(const ProjectedTriangle& falling, std::size_t e, const ProjectedTriangle& still, std::size_t f,
                         const Vec3& direction) {
  const std::size_t e2 = (e + 1) % 3, f2 = (f + 1) % 3;
  const Point2 p = minus(falling.across[e2], falling.across[e]), q = minus(still.across[f2], still.across[f]);
  const double turn = cross2(p, q);
  if (turn == 0) return never;  // their ends are over the faces
  const Point2 between = minus(still.across[f], falling.across[e]);
  const double s = cross2(between, q) / turn, t = cross2(between, p) / turn;
  if (s < 0 || s > 1 || t < 0 || t > 1) return never;
  const double from = falling.along[e] + s * (falling.along[e2] - falling.along[e]);
  const double to = still.along[f] + t * (still.along[f2] - still.along[f]);
  const Vec3 normal =
      cross(subtract(falling.corners[e2], falling.corners[e]), subtract(still.corners[f2], still.corners[f]));
  return to - from - find_thickness_along(normal, direction, falling.half_thickness + still.half_thickness);
}

double find_way_between(const ProjectedTriangle& falling, const ProjectedTriangle& still, const Vec3& direction) {
  for (std::size_t k = 0; k < 2; ++k)
    if (falling.low[k] > still.high[k] || still.low[k] > falling.high[k]) return never;
  double least =
      std::min(find_way_of_corners(falling, still, 1, direction), find_way_of_corners(still, falling, -1, direction));
  for (std::size_t e = 0; e < 3; ++e)
    for (std::size_t f = 0; f < 3; ++f) least = std::min(least, find_way_of_edges(falling, e, still, f, direction));
  return least;
}

/// Triangles of the body that stands, by the cells that they are seen in.
class ProjectedBody {
 public:
  explicit ProjectedBody(std::vector<ProjectedTriangle> triangles) : triangles_(std::move(triangles)) {
    double width = 0;
    for (const ProjectedTriangle& t : triangles_) width += find_width(t);
    if (width > 0) width_ = width / double(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (is_large(triangles_[i]))
        large_.push_back(i);
      else
        visit(triangles_[i], [&](const Cell& cell) { cells_[cell].push_back(i); });
    }
  }

  double find_way(const ProjectedTriangle& falling, const Vec3& direction) const {
    double least = never;
    const auto meet = [&](const ProjectedTriangle& still) {
      least = std::min(least, find_way_between(falling, still, direction));
    };
    if (is_large(falling)) {
      std::for_each(triangles_.begin(), triangles_.end(), meet);
      return least;
    }
    for (const std::size_t i : large_) meet(triangles_[i]);
    visit(falling, [&](const Cell& cell) {
      const auto found = cells_.find(cell);
      if (found == cells_.end()) return;
      for (const std::size_t i : found->second) meet(triangles_[i]);
    });
    return least;
  }

 private:
  using Cell = std::array<long, 2>;

  static double find_width(const ProjectedTriangle& t) { return std::max(t.high[0] - t.low[0], t.high[1] - t.low[1]); }

  /// Whether a triangle is large beside the others of the body: it would lie in too many cells.
  bool is_large(const ProjectedTriangle& t) const {
    constexpr double most_cells = 32;
    return find_width(t) > most_cells * width_;
  }

  template <class Visit>
  void visit(const ProjectedTriangle& t, const Visit& visit_cell) const {
    const auto cell = [&](double x) { return std::lround(std::floor(x / width_)); };
    for (long i = cell(t.low[0]); i <= cell(t.high[0]); ++i)
      for (long j = cell(t.low[1]); j <= cell(t.high[1]); ++j) visit_cell(Cell{i, j});
  }

  std::vector<ProjectedTriangle> triangles_;
  double width_ = 1;
  std::vector<std::size_t> large_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

std::optional<double> find_fall_to_wall(const WallDeck& wall, const std::vector<FallingNode>& nodes,
                                        const Vec3& direction, double clearance) {
  double least = never;
  for (const FallingNode& node : nodes) {
    const double distance = clearance + (wall.includes_thickness ? node.half_thickness : 0);
    const double way = find_way_to_wall(wall, node.place, direction, distance);
    if (way < least && is_within(wall, step_along(node.place, direction, way))) least = way;
  }
  return least < never ? std::optional(least) : std::nullopt;
}

std::optional<double> find_fall_to_body(const std::vector<FallingTriangle>& falling,
                                        const std::vector<FallingTriangle>& still, const Vec3& direction) {
  if (still.empty()) return std::nullopt;
  const std::array<Vec3, 2> axes = find_axes(direction);
  std::vector<ProjectedTriangle> projected;
  projected.reserve(still.size());
  for (const FallingTriangle& triangle : still) projected.push_back(project(triangle, direction, axes));
  const ProjectedBody body(std::move(projected));
  double least = never;
  for (const FallingTriangle& triangle : falling)
    least = std::min(least, body.find_way(project(triangle, direction, axes), direction));
  return least < never ? std::optional(least) : std::nullopt;
}

}  // namespace percuss
