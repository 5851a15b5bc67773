#pragma once
// Contact, ties and walls.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/deck/functions/curve.hpp"
#include "src/deck/functions/selector.hpp"
#include "src/deck/sensor_deck.hpp"

namespace percuss {

/// A wall that ends: from its point so far along a direction in its plane, and along normal x that direction.
struct RectangleDeck {
  Vec3 along{};  // made perpendicular to the normal, of length 1
  std::array<double, 2> size{};
};

/// A wall that bodies are outside of.
struct CylinderWallDeck {
  Vec3 axis{};  // unit vector, from WallDeck::point on
  double radius = 0;
  std::optional<double> length;  // none: without end, both ways
};

struct SphereWallDeck {
  double radius = 0;
};

struct WallDeck {
  std::string name;  // for output.history.forces; may be empty
  Vec3 point{};
  Vec3 normal{};                           // of a plane: unit vector towards the side where bodies live
  std::optional<RectangleDeck> rectangle;  // none: the wall does not end
  std::optional<CylinderWallDeck> cylinder;
  std::optional<SphereWallDeck> sphere;
  Vec3 direction{};            // of the motion of a cylinder or a sphere: a unit vector; zero of a plane
  std::optional<Curve> speed;  // prescribed motion along the normal or the direction
  std::optional<double> mass;  // of a wall that bodies push along its normal
  double start_speed = 0;      // of that at time 0
  double friction = 0;
  std::vector<Selector> nodes;      // empty: every contact node of the scene
  bool includes_thickness = false;  // nodes of shells keep half their thickness
  Place place;
  SwitchDeck when;

  bool moves() const { return speed || mass; }
  bool is_round() const { return cylinder || sphere; }
};

struct SurfacePairDeck {
  Selector a, b;  // parts or sides; a == b: self-contact of that surface
  std::optional<double> friction;
  SwitchDeck when;
};

/// Friction of a pair of surfaces, or of one with everything.
struct PairFrictionDeck {
  Selector a;
  std::optional<Selector> b;
  double friction = 0;
};

/// Glue between tied surfaces: traction and separation.
struct CohesiveDeck {
  enum class Mix { benzeggagh_kenane, power_law };
  enum class Onset { quadratic, maximum };
  enum class Softening { linear, exponential };
  double normal_stiffness = 0;            // traction / separation
  std::optional<double> shear_stiffness;  // none: the same
  double normal_strength = 0, shear_strength = 0;
  double normal_energy = 0, shear_energy = 0;  // until failure, by area
  double plateau = 0;                          // share of the energy at constant traction
  Mix mix = Mix::benzeggagh_kenane;
  double exponent = 1;
  Onset onset = Onset::quadratic;  // of damage, by both tractions over their strengths
  Softening softening = Softening::linear;
};

struct TieDeck {
  /// When nodes of a are tied: as the tie begins, or also as they come into contact with b.
  enum class Sticks { at_start, on_contact };
  Selector a, b;                   // nodes of a are tied to faces of b
  std::optional<double> distance;  // within which nodes are tied [length]; default: a share of the face
  bool rotations = false;          // whether nodes of shells and beams turn as their faces do
  // Tension and shear stress at which a node lets go, each alone; none: it does not.
  std::optional<double> normal_strength, shear_strength;
  double normal_exponent = 2, shear_exponent = 2;
  bool may_be_empty = false;  // a tie that ties nothing is no error
  Sticks sticks = Sticks::at_start;
  std::optional<CohesiveDeck> cohesive;  // it is not rigid: forces of glue in place of impulses
  SwitchDeck when{};
  Place place;

  bool has_strength() const { return normal_strength || shear_strength; }
  bool can_fail() const { return has_strength() || cohesive; }
  bool is_late() const { return when.any() || sticks == Sticks::on_contact; }
};

struct ContactDeck {
  enum class Surfaces { none, all, pairs };
  enum class Overlap { accept, push_out, refuse };
  Surfaces surfaces = Surfaces::none;
  std::vector<SurfacePairDeck> pairs;  // only with Surfaces::pairs
  std::vector<TieDeck> ties;
  double friction = 0;
  std::vector<PairFrictionDeck> frictions;  // the first that fits is instead of `friction`
  Overlap overlap = Overlap::accept;        // what happens to overlap found at the start
  /// How impulses are found: by the iterated penalty force to a share of the predicted penetration, all rows as one
  /// system with complementarity, by springs on the penetration, or as kinematic with springs at sheets.
  enum class Enforcement { kinematic, lagrange, penalty, automatic };
  Enforcement enforcement = Enforcement::automatic;
  double tolerance = 1e-3;            // of what the iteration leaves, a share of the largest predicted penetration
  double penalty_scale = 0.5;         // penalty: of the stiffness
  std::optional<double> restitution;  // of rigid bodies on rigid ones and on walls; none: find_restitution()
  bool reuse_search = true;  // keep candidate pairs while a guaranteed bound allows it, leave out what is at rest
  /// How candidate pairs are found. The pairs are the same.
  enum class Search { blocks, points_in_box };
  Search search = Search::blocks;
  bool edges = true;   // contact between edges, besides that of nodes and faces
  bool beams = false;  // beams touch, too; those of a part of beams alone that a pair names do in any case
  /// When contact nodes and faces are divided again over the ranks. No result depends on it.
  enum class Rebalance { automatic, always, never };
  Rebalance rebalance = Rebalance::automatic;

  /// Whether rows that no spring pushes are iterated.
  bool is_iterated() const { return enforcement == Enforcement::kinematic || enforcement == Enforcement::automatic; }
  /// Parting over approach of rigid bodies.
  double find_restitution() const { return restitution.value_or(enforcement == Enforcement::penalty ? 1 : 0); }
  bool ties_rotations() const {
    return std::any_of(ties.begin(), ties.end(), [](const TieDeck& tie) { return tie.rotations; });
  }
  bool has_glue() const {
    return std::any_of(ties.begin(), ties.end(), [](const TieDeck& tie) { return tie.cohesive.has_value(); });
  }
  bool has_failing_ties() const {
    return std::any_of(ties.begin(), ties.end(), [](const TieDeck& tie) { return tie.can_fail(); });
  }
};

}  // namespace percuss
