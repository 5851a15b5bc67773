#include "src/mesh/parts/place_groups.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "comm/agreement.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/parts/fall_distance.hpp"

namespace percuss {
namespace {

using Lowest = PlaceDeck::Lowest;

Vec3 scale(double factor, const Vec3& x) { return {factor * x[0], factor * x[1], factor * x[2]}; }
double find_size(const Vec3& x) { return std::sqrt(dot(x, x)); }

/// An element of a part with its nodes, counted over the copies of the part.
struct PartElement {
  const Topology* topology = nullptr;
  std::vector<std::int64_t> nodes;
  double thickness = 0, area = 0;                      // of a shell; of a beam
  std::array<int, most_faces> side{};                  // of a generated part: of each face; `inner` where it has none
  static constexpr int inner = ShapeSource::interior;  // side: of a part from a file 0 on its surface
};

/// visit(element number, PartElement), in their order.
template <class Visit>
void for_each_element(const ScenePart& part, const Visit& visit) {
  PartElement one;
  for (std::int64_t e = 0; e < part.elements; ++e) {
    one.nodes.clear();
    if (part.file) {
      const Elements& elements = part.file->mesh.elements;
      one.topology = &elements.topology_of(at(e));
      for (const int n : elements.corners(at(e))) one.nodes.push_back(n);
      const double own = elements.own_thickness.empty() ? 0 : elements.own_thickness[at(e)];
      const Section& section = part.blocks[at(elements.block_index(at(e)))].section;
      one.thickness = own > 0 ? own : section.thickness;
      one.area = section.area;
      for (std::size_t f = 0; f < most_faces; ++f)
        one.side[f] = (part.file->exterior[at(e)] >> f & 1) != 0 ? 0 : PartElement::inner;
    } else {
      const ShapeSource& source = *part.generated->source;
      const std::int64_t copy = e / source.element_count();
      const int local = static_cast<int>(e % source.element_count());
      one.topology = &find_topology(source.topology());
      for (const int n : source.corners(local)) one.nodes.push_back(n + copy * source.node_count());
      one.thickness = part.blocks[0].section.thickness;
      one.area = part.blocks[0].section.area;
      one.side = source.face_sides(local);
    }
    visit(e, std::as_const(one));
  }
}

ElementCorners gather_places(const ScenePart& part, const PartElement& element) {
  ElementCorners x{};
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = find_node_place(part, element.nodes[at(element.topology->kernel_corners[i])]);
  return x;
}

double find_volume(const PartElement& element, const ElementCorners& x) {
  if (element.topology->is_surface()) return element.thickness * find_shell_area_size(x);
  if (element.topology->is_line()) return element.area * find_distance(x[0], x[1]);
  return find_solid_volume(*element.topology, x);
}

/// Sums of nodal masses, as the run lumps them.
Vec3 find_mass_center(const Deck& deck, const SceneParts& scene, const std::vector<std::size_t>& parts) {
  double mass = 0;
  Vec3 moment{};
  for (const std::size_t p : parts) {
    const ScenePart& part = scene.parts[p];
    for_each_element(part, [&](std::int64_t, const PartElement& element) {
      const ElementCorners x = gather_places(part, element);
      const double density = deck.materials[at(part.blocks[0].material)].density;
      const double own = density * find_volume(element, x);
      mass += own;
      for (std::size_t i = 0; i < x.size(); ++i)
        moment = add(moment, scale(0.125 * own * element.topology->find_mass_share(i), x[i]));
    });
  }
  return scale(1 / mass, moment);
}

/// Corner of the box of all nodes; of an edge and of a face the middle.
Vec3 find_box_point(const SceneParts& scene, const std::vector<std::size_t>& parts, const Vec3& way) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3 low{far, far, far}, high{-far, -far, -far}, point{};
  for (const std::size_t p : parts) {
    for (std::int64_t n = 0; n < scene.parts[p].nodes; ++n) {
      const Vec3 x = find_node_place(scene.parts[p], n);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], x[k]);
        high[k] = std::max(high[k], x[k]);
      }
    }
  }
  for (std::size_t k = 0; k < 3; ++k) point[k] = way[k] > 0 ? high[k] : way[k] < 0 ? low[k] : 0.5 * (low[k] + high[k]);
  return point;
}

/// Rotation of the shortest arc that takes one unit vector onto another: two half turns.
TurnMatrix turn_onto(const Vec3& from, const Vec3& to) {
  const auto half_turns = [](const Vec3& a, const Vec3& b) {
    const Vec3 sum = add(a, b), h = scale(1 / find_size(sum), sum);
    TurnMatrix m{};
    for (std::size_t i = 0; i < 3; ++i) {  // (2 h h^T - I) (2 a a^T - I)
      for (std::size_t j = 0; j < 3; ++j)
        m[i][j] = 4 * h[i] * dot(h, a) * a[j] - 2 * h[i] * h[j] - 2 * a[i] * a[j] + (i == j ? 1 : 0);
    }
    return m;
  };
  const auto multiply = [](const TurnMatrix& a, const TurnMatrix& b) {
    TurnMatrix m{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) m[i][j] += a[i][k] * b[k][j];
    return m;
  };
  if (find_distance(from, to) < 1e-15) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (dot(from, to) > -0.5) return half_turns(from, to);
  Vec3 axis{};  // by way of a vector between both, in their plane where they have one
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) least = std::abs(from[k]) < std::abs(from[least]) ? k : least;
  axis[least] = 1;
  Vec3 across = add(from, to);
  if (find_size(across) < 1e-8) across = axis;
  across = add(across, scale(-dot(across, from), from));
  across = scale(1 / find_size(across), across);
  return multiply(half_turns(across, to), half_turns(from, across));
}

/// Finds the motion of one entry, on rank 0.
class GroupPlacer {
 public:
  GroupPlacer(const Deck& deck, const SceneParts& scene, const PlaceDeck& place)
      : deck_(deck), scene_(scene), place_(place), parts_(list_parts(place.parts)) {
    const Vec3 g = deck.gravity.at(0);
    direction_ = place.direction ? *place.direction : scale(1 / find_size(g), g);
  }

  Motion find() const {
    Motion motion;
    if (place_.lowest) {
      motion.center = find_mass_center(deck_, scene_, parts_);
      motion.matrix = turn_onto(find_upright(*place_.lowest, motion.center), scale(-1, direction_));
    }
    if (place_.rest_on) motion.shift = scale(find_fall(motion), direction_);
    return motion;
  }

  std::string describe(const Motion& motion) const {
    std::string text =
        fmt::format("place: part{} '{}'", parts_.size() == 1 ? "" : "s", fmt::join(place_.parts, "', '"));
    text += place_.lowest ? describe_turn(motion) + "," : "";
    const Vec3& s = motion.shift;
    text += fmt::format(" moved by [{:.10g}, {:.10g}, {:.10g}]", s[0] + 0.0, s[1] + 0.0, s[2] + 0.0);  // never -0
    if (!place_.rest_on) return text;
    const auto& on = *place_.rest_on;
    return text + fmt::format(": gap {:.10g} to {} '{}'", find_gap(motion), on.part.empty() ? "wall" : "part",
                              on.part.empty() ? on.wall : on.part);
  }

 private:
  [[noreturn]] void refuse(Place place, const std::string& what) const {
    throw InputError(fmt::format("{}: error: place: {}", deck_.where(place), what));
  }

  std::vector<std::size_t> list_parts(const std::vector<std::string>& names) const {
    std::vector<std::size_t> parts;
    for (std::size_t p = 0; p < scene_.parts.size(); ++p)
      if (std::find(names.begin(), names.end(), scene_.parts[p].name) != names.end()) parts.push_back(p);
    return parts;
  }

  static std::string describe_turn(const Motion& motion) {
    const TurnMatrix& m = motion.matrix;
    const Vec3 twice{m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
    const double sine = 0.5 * find_size(twice), cosine = 0.5 * (m[0][0] + m[1][1] + m[2][2] - 1);
    const double degrees = std::atan2(sine, cosine) * 180 / std::numbers::pi;
    if (sine == 0) return fmt::format(" turned by {:.10g} degrees", degrees);
    const Vec3 axis = scale(0.5 / sine, twice), &c = motion.center;
    return fmt::format(" turned by {:.10g} degrees about [{:.6g}, {:.6g}, {:.6g}] through [{:.10g}, {:.10g}, {:.10g}]",
                       degrees, axis[0], axis[1], axis[2], c[0], c[1], c[2]);
  }

  /// Unit vector of the parts that shall point up.
  Vec3 find_upright(const Lowest& lowest, const Vec3& center) const {
    Vec3 up{};
    if (lowest.of_box) {
      const Vec3 arm = subtract(center, find_box_point(scene_, parts_, *lowest.of_box));
      up = lowest.kind == Lowest::Kind::face ? scale(-1, *lowest.of_box) : arm;
      for (std::size_t k = 0; k < 3; ++k)
        if (lowest.kind == Lowest::Kind::edge && (*lowest.of_box)[k] == 0) up[k] = 0;
    } else {
      up = find_upright_of_set(lowest, center);
    }
    const double size = find_size(up);
    if (size > 0) return scale(1 / size, up);
    refuse(lowest.place,
           "the mass centre lies on what shall be lowest (no direction follows): name another corner, edge or face");
  }

  Vec3 find_upright_of_set(const Lowest& lowest, const Vec3& center) const {
    if (lowest.kind == Lowest::Kind::face) return scale(-1, sum_face_areas(lowest));
    const std::vector<Vec3> places = list_places(lowest);
    Vec3 mean{};
    for (const Vec3& x : places) mean = add(mean, scale(1.0 / double(places.size()), x));
    const Vec3 arm = subtract(center, mean);
    if (lowest.kind == Lowest::Kind::corner) return arm;
    // Along the edge: between the two nodes that are farthest from the mean, and from each other.
    const auto farthest_from = [&](const Vec3& from) {
      return *std::max_element(places.begin(), places.end(), [&](const Vec3& a, const Vec3& b) {
        return find_distance(a, from) < find_distance(b, from);
      });
    };
    const Vec3 first = farthest_from(mean), along = subtract(farthest_from(first), first);
    const double square = dot(along, along);
    if (!(square > 0))
      refuse(lowest.place, fmt::format("set '{}' has one place (an edge has two ends): use corner", lowest.set));
    return add(arm, scale(-dot(arm, along) / square, along));
  }

  /// The part of a set, and the name without it.
  std::pair<std::size_t, std::string> find_owner(const Lowest& lowest) const {
    const auto slash = lowest.set.find('/');
    std::vector<std::string> known;
    for (const std::size_t p : parts_) {
      const ScenePart& part = scene_.parts[p];
      for (const std::string& name : part.node_sets) {
        known.push_back(part.name + "/" + name);
        if (known.back() == lowest.set || (slash == std::string::npos && name == lowest.set)) return {p, name};
      }
    }
    refuse(lowest.place,
           fmt::format("set '{}' is none of the parts that are placed{}", lowest.set, name_hint(lowest.set, known)));
  }

  std::vector<Vec3> list_places(const Lowest& lowest) const {
    const auto [p, name] = find_owner(lowest);
    const ScenePart& part = scene_.parts[p];
    std::vector<Vec3> places;
    if (part.file) {
      for (const int n : part.file->mesh.node_sets.at(name)) places.push_back(find_node_place(part, n));
      return places;
    }
    const auto side = std::find(part.side_sets.begin(), part.side_sets.end(), name) - part.side_sets.begin();
    const ShapeSource& source = *part.generated->source;
    for (std::int64_t n = 0; n < part.nodes; ++n)
      if ((source.node_sides(static_cast<int>(n % source.node_count())) >> side & 1U) != 0)
        places.push_back(find_node_place(part, n));
    return places;
  }

  /// Outward area of a side.
  Vec3 sum_face_areas(const Lowest& lowest) const {
    const auto [p, name] = find_owner(lowest);
    const ScenePart& part = scene_.parts[p];
    const auto side = std::find(part.side_sets.begin(), part.side_sets.end(), name) - part.side_sets.begin();
    if (side == std::ssize(part.side_sets))
      refuse(lowest.place, fmt::format("set '{}' has no faces (it is a set of nodes): name a side set", lowest.set));
    Vec3 sum{};
    for_each_element(part, [&](std::int64_t e, const PartElement& element) {
      for (int f = 0; f < element.topology->face_count; ++f) {
        if (!is_of_side(part, e, f, element, name, static_cast<int>(side))) continue;
        std::array<Vec3, 4> x;
        for (std::size_t c = 0; c < 4; ++c)
          x[c] = find_node_place(part, element.nodes[at(element.topology->face_table[at(f)].four[c])]);
        sum = add(sum, cross(subtract(x[2], x[0]), subtract(x[3], x[1])));
      }
    });
    return sum;
  }

  static bool is_of_side(const ScenePart& part, std::int64_t e, int f, const PartElement& element,
                         const std::string& name, int side) {
    if (!part.file) return element.side[at(f)] == side;
    const std::vector<ElementFace>& faces = part.file->mesh.side_sets.at(name);
    const ElementFace wanted{static_cast<int>(e), f};
    return std::find(faces.begin(), faces.end(), wanted) != faces.end();
  }

  /// [nodes of all these parts] half the largest thickness of the shells there.
  std::vector<FallingNode> list_nodes(const Motion& motion) const {
    std::vector<FallingNode> nodes;
    for (const std::size_t p : parts_) {
      const ScenePart& part = scene_.parts[p];
      const std::size_t first = nodes.size();
      for (std::int64_t n = 0; n < part.nodes; ++n) nodes.push_back({motion(find_node_place(part, n)), 0});
      for_each_element(part, [&](std::int64_t, const PartElement& element) {
        if (!element.topology->is_surface()) return;
        for (const std::int64_t n : element.nodes) {
          double& half = nodes[first + at(n)].half_thickness;
          half = std::max(half, 0.5 * element.thickness);
        }
      });
    }
    return nodes;
  }

  std::vector<FallingTriangle> list_triangles(const std::vector<std::size_t>& parts, const Motion& motion) const {
    std::vector<FallingTriangle> triangles;
    for (const std::size_t p : parts) {
      const ScenePart& part = scene_.parts[p];
      for_each_element(part, [&](std::int64_t, const PartElement& element) {
        const bool is_shell = element.topology->is_surface();
        for (int f = 0; f < (is_shell ? 1 : element.topology->face_count); ++f) {
          if (!is_shell && element.side[at(f)] == PartElement::inner) continue;
          std::array<Vec3, 4> x;
          for (std::size_t c = 0; c < 4; ++c)
            x[c] = motion(find_node_place(part, element.nodes[at(element.topology->face_table[at(f)].four[c])]));
          const double half = is_shell ? 0.5 * element.thickness : 0;
          triangles.push_back({{x[0], x[1], x[2]}, half});
          triangles.push_back({{x[0], x[2], x[3]}, half});
        }
      });
    }
    return triangles;
  }

  const WallDeck& find_wall() const {
    return *std::find_if(deck_.walls.begin(), deck_.walls.end(),
                         [&](const WallDeck& wall) { return wall.name == place_.rest_on->wall; });
  }

  /// How far the parts still fall after the motion, until they have their clearance.
  double find_fall(const Motion& motion) const {
    const PlaceDeck::Support& on = *place_.rest_on;
    std::optional<double> way;
    if (on.part.empty()) {
      way = find_fall_to_wall(find_wall(), list_nodes(motion), direction_, on.clearance);
    } else {
      way = find_fall_to_body(list_triangles(parts_, motion), list_triangles(list_parts({on.part}), Motion{}),
                              direction_);
      if (way) *way -= on.clearance;
    }
    if (way) return *way;
    refuse(on.place,
           fmt::format("the parts do not meet {} '{}' along [{:g}, {:g}, {:g}] (they pass beside it): correct "
                       "direction, or move them",
                       on.part.empty() ? "wall" : "part", on.part.empty() ? on.wall : on.part, direction_[0],
                       direction_[1], direction_[2]));
  }

  /// Measured in the new place, not taken from the deck: distance of the lowest node from a wall without end, and
  /// else what is left along the direction.
  double find_gap(const Motion& motion) const {
    const double left = find_fall(motion) + place_.rest_on->clearance;
    if (!place_.rest_on->part.empty()) return left;
    const WallDeck& wall = find_wall();
    if (wall.rectangle || (wall.cylinder && wall.cylinder->length)) return left;
    double least = std::numeric_limits<double>::infinity();
    for (const FallingNode& node : list_nodes(motion)) {
      const Vec3 from = subtract(node.place, wall.point);
      double gap = dot(wall.normal, from);
      if (wall.sphere) gap = find_size(from) - wall.sphere->radius;
      if (wall.cylinder)
        gap = find_size(add(from, scale(-dot(from, wall.cylinder->axis), wall.cylinder->axis))) - wall.cylinder->radius;
      least = std::min(least, gap - (wall.includes_thickness ? node.half_thickness : 0));
    }
    return least;
  }

  const Deck& deck_;
  const SceneParts& scene_;
  const PlaceDeck& place_;
  std::vector<std::size_t> parts_;
  Vec3 direction_{};
};

void move_parts(const PlaceDeck& place, const Motion& motion, SceneParts& scene) {
  for (ScenePart& part : scene.parts) {
    if (std::find(place.parts.begin(), place.parts.end(), part.name) == place.parts.end()) continue;
    if (part.generated) part.generated->place.move(motion);
    if (!part.file) continue;
    for (Vec3& x : part.file->mesh.nodes) x = motion(x);
  }
}

}  // namespace

void place_groups(const Deck& deck, const Communicator& ranks, SceneParts& scene) {
  if (deck.placements.empty()) return;
  std::vector<Motion> motions;
  fail_together(ranks, [&] {
    const bool is_whole = std::all_of(scene.parts.begin(), scene.parts.end(),
                                      [](const ScenePart& part) { return part.error.empty(); });  // else refused later
    if (ranks.rank() != 0 || !is_whole) return;
    for (const PlaceDeck& place : deck.placements) {
      const GroupPlacer placer(deck, scene, place);
      motions.push_back(placer.find());
      scene.notes.push_back(placer.describe(motions.back()));
      move_parts(place, motions.back(), scene);
    }
  });
  const std::size_t done = ranks.rank() == 0 ? motions.size() : 0;
  broadcast_values(ranks, motions, 0);
  for (std::size_t i = done; i < motions.size(); ++i) move_parts(deck.placements[i], motions[i], scene);
}

}  // namespace percuss
