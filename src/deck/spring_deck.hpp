#pragma once
// Springs, dampers, welds and constraints between nodes, nodes embedded in solids, and joints between rigid bodies, as
// a deck gives them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/deck/functions/curve.hpp"
#include "src/deck/output_deck.hpp"

namespace percuss {

/// Where springs end: at one node, or at each node of a set.
struct SpringEndDeck {
  std::optional<HistoryPoint> point;  // none: `where`
  Selector where;
};

/// One spring for each node of the first end, to the nearest node of the second.
struct SpringDeck {
  enum class Acts { both, tension, compression };
  std::string name;
  std::array<SpringEndDeck, 2> between;
  std::optional<double> stiffness;           // [force / length]
  std::vector<std::array<double, 2>> table;  // instead: elongation, force; straight on beyond the ends
  double damping = 0;                        // [force x time / length]
  Acts acts = Acts::both;                    // while it is longer, or shorter, than at rest
  std::optional<double> rest_length;         // none: the distance at time 0 [length]
  std::optional<double> largest_force;       // amount beyond which it breaks
  std::optional<double> largest_elongation;  // likewise, of elongation or shortening
  Place place;
};

/// Rigid connections of pairs of nodes that may fail: one for each node of the first end, with the nearest node of the
/// second. With a radius one for each point of `at`, between what lies within it of the faces of both ends.
struct WeldDeck {
  std::string name;
  std::array<SpringEndDeck, 2> between;
  std::vector<Vec3> at;  // of welds with a radius, or a row or a file of them
  std::optional<double> radius;
  std::optional<Vec3> from, to;           // ends of a row
  std::optional<double> pitch;            // largest distance in the row [length]
  std::string file;                       // of places, with diameters or without
  std::optional<Vec3> normal;             // at time 0, a unit vector; none: from the first node to the second
  std::optional<double> normal_strength;  // force along the normal at which it fails alone
  std::optional<double> shear_strength;   // likewise across
  double normal_exponent = 2, shear_exponent = 2;
  std::optional<double> time;  // at which it fails
  Place place;

  bool is_between_faces() const { return radius.has_value() || !file.empty(); }
};

/// A term of a linear equation: a factor times a displacement.
struct EquationTermDeck {
  SpringEndDeck of;
  std::size_t direction = 0;  // x, y, z
  double factor = 0;
};

/// Nodes that move equally in some directions, all of a set or each of one side with its counterpart on the other; or
/// displacements of which a linear equation holds.
struct ConstraintDeck {
  std::string name;
  std::array<bool, 3> equal{};  // x, y, z
  std::optional<Selector> nodes;
  std::optional<std::array<SpringEndDeck, 2>> between;  // instead
  std::vector<EquationTermDeck> equation;               // instead of all three
  std::optional<Curve> sum;                             // of the terms, over time [length]; none: 0
  Place place;
};

/// Nodes that keep their places within solids, as those of bars in concrete.
struct EmbeddedDeck {
  std::string name;
  Selector nodes;
  std::vector<std::string> hosts;  // parts whose solids hold them; none: all
  double tolerance = 0.05;         // how far outside they may lie, as a share of the size of the solid
  Place place;
};

/// Joint of two rigid bodies, or of one and the ground.
struct JointDeck {
  enum class Kind { spherical, revolute, cylindrical, translational, planar, universal, fixed, screw };
  std::string name;
  Kind kind = Kind::spherical;
  std::vector<std::string> bodies;  // one: it is joined to the ground
  Vec3 at{};                        // the common point at time 0
  std::optional<Vec3> axis;         // a unit vector at time 0; of all kinds but spherical and fixed
  std::optional<Vec3> second_axis;  // likewise, on the second body, across the axis; of universal joints
  std::optional<double> lead;       // of screws: way along the axis of a turn of the first body about it [length]
  Place place;
};

/// Law about one axis of a turn spring. Angles in radians.
struct TurnLawDeck {
  std::optional<double> stiffness;                    // [moment / angle]
  std::vector<std::array<double, 2>> table;           // instead: angle, moment; straight on beyond the ends
  double damping = 0;                                 // [moment x time / angle]
  std::vector<std::array<double, 2>> damping_table;   // instead: rate, moment; likewise
  std::optional<double> friction;                     // moment at which it slips
  std::vector<std::array<double, 2>> friction_table;  // instead: angle, moment
  std::optional<double> least, most;                  // angles of stops
  std::optional<double> hold_stiffness;               // of friction that sticks, and of stops [moment / angle]
};

/// Resistance against the rotation of a second rigid body relative to a first one, by three angles.
struct TurnSpringDeck {
  std::string name;
  std::vector<std::string> bodies;
  std::array<Vec3, 2> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}};  // x and y on the first body at time 0, perpendicular units
  std::optional<std::array<Vec3, 2>> second_axes;          // on the second one; none: the same
  std::optional<TurnLawDeck> x, y, z;
  Place place;
};

/// A kind of joint by its word, and what it keeps.
struct JointTraits {
  enum class Point { all, across, along };  // which ways of the point: all, those across the axis, that along it
  const char* word;
  JointDeck::Kind kind;
  Point point;
  bool keeps_axis;     // the direction of the axis is one on both bodies
  bool keeps_turn;     // no turn about it; of a universal joint: the axes of both bodies stay perpendicular
  const char* motion;  // that it leaves
  bool has_axis() const { return kind != JointDeck::Kind::spherical && kind != JointDeck::Kind::fixed; }
  bool has_second_axis() const { return kind == JointDeck::Kind::universal; }
  bool has_lead() const { return kind == JointDeck::Kind::screw; }
};

/// Traits of joints, in the order of JointDeck::Kind.
inline constexpr std::array joint_traits{
    JointTraits{"spherical", JointDeck::Kind::spherical, JointTraits::Point::all, false, false,
                "turns about every axis"},
    JointTraits{"revolute", JointDeck::Kind::revolute, JointTraits::Point::all, true, false, "turns about one axis"},
    JointTraits{"cylindrical", JointDeck::Kind::cylindrical, JointTraits::Point::across, true, false,
                "slides along an axis and turns about it"},
    JointTraits{"translational", JointDeck::Kind::translational, JointTraits::Point::across, true, true,
                "slides along an axis"},
    JointTraits{"planar", JointDeck::Kind::planar, JointTraits::Point::along, true, false,
                "slides across an axis and turns about it"},
    JointTraits{"universal", JointDeck::Kind::universal, JointTraits::Point::all, false, true,
                "turns about an axis of each body"},
    JointTraits{"fixed", JointDeck::Kind::fixed, JointTraits::Point::all, true, true, "does not move"},
    JointTraits{"screw", JointDeck::Kind::screw, JointTraits::Point::across, true, false,
                "slides along an axis as it turns about it"}};

inline const JointTraits& find_traits(JointDeck::Kind kind) { return joint_traits[static_cast<std::size_t>(kind)]; }

}  // namespace percuss
