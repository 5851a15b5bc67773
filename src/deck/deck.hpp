#pragma once
// A deck after reading: plain data, checked value by value, in the units that the user chose.
//
// docs/deck.md documents every key with unit, default and range; read_deck.cpp is the one place that maps keys to
// these members.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "src/deck/beam_deck.hpp"
#include "src/deck/element_deck.hpp"
#include "src/deck/functions/curve.hpp"
#include "src/deck/functions/place_function.hpp"
#include "src/deck/functions/selector.hpp"
#include "src/deck/mesh_changes.hpp"
#include "src/deck/output_deck.hpp"
#include "src/deck/sensor_deck.hpp"
#include "src/deck/spring_deck.hpp"
#include "src/deck/start_deck.hpp"
#include "src/deck/yaml/key_places.hpp"
#include "src/warning.hpp"

namespace percuss {

// --- meshes that percuss generates; all in local coordinates, then array, rotate and `at` are applied in this order

/// Local origin: the lowest corner. Sides: x_min, x_max, y_min, y_max, z_min, z_max.
struct BoxShape {
  Vec3 size{};
  std::array<int, 3> cells{1, 1, 1};
};

/// A solid cylinder without degenerate hexahedra: a square core and rings around it. Local origin: the middle of the
/// start face, axis +z. `across` cells on a diameter: rings = max(1, across / 4), core = across - 2 rings (across >=
/// 3). Sides: start, end, side.
struct CylinderShape {
  double radius = 0;
  double length = 0;
  int across = 0;
  int along = 0;
};

/// A hollow cylinder, or a sector of one. Local origin: on the axis in the start face, axis +z. Sides: start, end,
/// inner, outer; of a sector also first (at +x) and last.
struct TubeShape {
  double inner_radius = 0;
  double outer_radius = 0;
  double length = 0;
  std::array<int, 3> cells{1, 8, 1};  // through the wall, around, along
  double arc = 360;                   // degrees of the turn, from +x counter-clockwise; 360: closed
};

/// A solid ball: a cube of core cells and rings on its six faces, split as CylinderShape. Local origin: its middle.
/// Sides: surface.
struct SphereShape {
  double radius = 0;
  int across = 0;
};

// Surfaces of four-node shells. Each also has its two faces as sides; the second one is where normals point to.

/// A flat rectangle in the plane of x and y, normals along +z. Local origin: the lowest corner. Sides: the edges x_min,
/// x_max, y_min, y_max; bottom, top.
struct ShellPlateShape {
  std::array<double, 2> size{};
  std::array<int, 2> cells{1, 1};
};

/// The surface of a cylinder, or of a cone, or a sector of one. Local origin: on the axis in the start, axis +z. Sides:
/// the edges start, end; inner, outer; of a sector also the edges first (at +x) and last.
struct ShellTubeShape {
  double radius = 0;
  std::optional<double> end_radius;  // a cone; default: radius
  double length = 0;
  std::array<int, 2> cells{8, 1};  // around, along
  double arc = 360;                // as TubeShape::arc
};

/// The surface of a ball: the six faces of a cube, without a pole. Local origin: its middle. Sides: inner, outer.
struct ShellSphereShape {
  double radius = 0;
  int cells = 1;  // along an edge of the cube
};

/// The four walls of a rectangular profile, its corners sharp, and plates that close its ends, joined to the walls:
/// one makes a tray, two a box. Local origin: the middle of the start, axis +z, walls along x and y. Sides: the edges
/// start, end (where closed all nodes there); inner, outer.
struct ShellBoxTubeShape {
  enum class Closed { none, start, end, both };
  std::array<double, 2> size{};  // of the section, along x and y
  double length = 0;
  std::array<int, 3> cells{1, 1, 1};  // along x, y and z
  Closed closed = Closed::none;

  bool has_start() const { return closed == Closed::start || closed == Closed::both; }
  bool has_end() const { return closed == Closed::end || closed == Closed::both; }
};

/// A straight line of beams. Sides: start, end, its two outer nodes.
struct LineShape {
  Vec3 from{}, to{};
  int cells = 1;
};

/// A file with a mesh. All its element blocks and sets, by name (or "block_7", "nodes_7", "sides_7", "elements_7").
struct FileMesh {
  std::string file;                 // as found: relative paths are relative to the deck
  std::vector<std::string> blocks;  // empty: all
  double scale = 1;
  bool is_exodus = true;  // key `exodus`: of this format, with nodes of its own; else of any, nodes shared (`mesh`)
};

using Shape = std::variant<BoxShape, CylinderShape, TubeShape, SphereShape, ShellPlateShape, ShellTubeShape,
                           ShellSphereShape, ShellBoxTubeShape, LineShape, FileMesh>;

/// Whether a generated shape is a surface of shells.
bool is_shell_shape(const Shape& shape);

/// The sides that percuss names on a generated shape; empty for a mesh from a file.
std::vector<std::string> side_names(const Shape& shape);

/// Copies of a shape on a grid. Odd courses (z index) are shifted by stagger * pitch along y (along x if count[1] ==
/// 1).
struct ArrayCopies {
  std::array<int, 3> count{1, 1, 1};
  Vec3 pitch{};
  double stagger = 0;
};

struct Rotation {
  Vec3 axis{0, 0, 1};  // unit vector
  double degrees = 0;
  Vec3 center{};  // in the coordinates after `array`
};

/// Elements whose step bound is below `step` are given mass until it is that: at the start and, on request, again
/// during the run.
struct MassScalingDeck {
  double step = 0;            // [time]
  double max_added = 0.05;    // share of a part's mass; more is refused at the start, and not added later
  std::optional<long> every;  // steps between two looks during the run; none: at the start only
  Place place;
};

/// A part that moves as one. What its elements give to mass, centre and inertia is lumped at the nodes.
struct RigidDeck {
  std::string body;                              // parts that name the same are one; empty: the part alone
  std::optional<double> mass;                    // instead of that of the elements
  std::optional<Vec3> center;                    // likewise [length]
  std::optional<std::array<double, 6>> inertia;  // likewise, about the centre: xx, yy, zz, xy, yz, zx of the tensor
  std::array<bool, 6> fixed{};                   // translations of the centre along, rotations about x, y, z
  Place place;
};

/// Nodes that move as one: a body of their own, or members of another.
struct RigidSetDeck {
  std::string name;
  Selector where;
  std::string body;                              // that the nodes join; empty: one of their own
  double mass = 0;                               // in addition to that of the nodes
  std::optional<Vec3> center;                    // of that; none: the mass centre of the nodes [length]
  std::optional<std::array<double, 6>> inertia;  // in addition, about that centre: xx, yy, zz, xy, yz, zx
  std::array<bool, 6> fixed{};                   // as RigidDeck::fixed
  bool counts_nodes = true;                      // whether the masses of the nodes are masses of the body
  Place place;
};

/// A ply of the shells of a part.
struct PlyDeck {
  std::string material;  // empty: that of the part
  double thickness = 0;
  double angle = 0;  // [degrees] of axis 1 of its material from the laminate's, about the normal
};

struct PartDeck {
  /// What the cells of a generated solid are: hexahedra, or twelve, six or five tetrahedra, two wedges or six pyramids
  /// each.
  enum class Elements { hexahedra, tetrahedra, six_tetrahedra, five_tetrahedra, wedges, pyramids };
  std::string name;
  Shape shape;
  Elements elements = Elements::hexahedra;
  std::optional<ArrayCopies> array;
  std::vector<Rotation> rotate;  // in order; `axis: x` in the deck turns local z onto x and comes first
  Vec3 at{};
  std::vector<PartImage> images;                // afterwards, of parts that `mirror` and `pattern` of the deck make
  std::optional<MassScalingDeck> mass_scaling;  // instead of TimeDeck::mass_scaling
  std::string material;
  std::optional<double> thickness;                  // of its shells, of those that nothing else gives one [length]
  std::optional<PlaceFunction> thickness_by_place;  // of each at the mean of its corners, instead
  bool thickness_of_file = false;                   // of those that the file gives one, instead
  std::optional<int> points;                        // across the thickness of its shells; default: by the material
  std::vector<PlyDeck> plies;                       // of its shells, bottom first; then points are of each ply
  double offset = 0;                       // of the middle of its shells from the mesh, along their normal [length]
  std::optional<BeamSectionDeck> section;  // of its beams; they need one
  std::optional<Vec3> toward;  // to which y of the section of its beams points as far as it can, a unit vector
  std::optional<double> contact_radius;  // with which its beams touch; none: find_contact_radius() of the section
  std::optional<RigidDeck> rigid;        // none: it deforms
  PartElementDeck own_elements;          // instead of Deck::elements
  Place place;

  /// Shells need it.
  bool is_membrane() const { return own_elements.integration == ElementDeck::Integration::membrane; }
  bool is_cut_into_tetrahedra() const { return elements == Elements::tetrahedra || has_bare_tetrahedra(); }
  /// Without nodes in the middle of cells.
  bool has_bare_tetrahedra() const {
    return elements == Elements::six_tetrahedra || elements == Elements::five_tetrahedra;
  }
  bool has_thickness() const { return thickness || thickness_by_place || thickness_of_file; }
  bool varies_in_thickness() const { return thickness_by_place || thickness_of_file; }
};

// --- materials

/// The constants of a law by the keys of its table (kernels/material), those that have defaults included.
struct LawDeck {
  std::string model;  // its name in the deck
  std::map<std::string, double> numbers;
  std::map<std::string, std::vector<std::array<double, 2>>> tables;
  std::map<std::string, Vec3> vectors;
  std::map<std::string, std::vector<double>> lists;
  std::map<std::string, std::string> texts;  // files too
  Place place;
};
struct JohnsonCookDamageDeck {
  double d1 = 0, d2 = 0, d3 = 0, d4 = 0, d5 = 0;
  double reference_rate = 1;  // [1/time]
};
/// Forces of the section of a beam at which it fails, each of them alone.
struct BeamFailureDeck {
  std::optional<double> axial;  // of a tension
  std::optional<double> shear_y, shear_z, torque, moment_y, moment_z;
};
/// When an element of a material fails: at the first of the criteria that are given.
/// Over what an element loses its force after the onset of damage; one of them.
struct DamageEvolutionDeck {
  std::optional<double> displacement, energy, plastic_strain;  // plastic; by area
  std::optional<double> exponent;                              // the force falls exponentially
  std::vector<std::array<double, 2>> table;  // rows [share of that, share of the force that is lost]; none: straight
};
/// How an element loses force before its damage is 1: from a plastic strain or from a damage on.
struct DamageCouplingDeck {
  std::vector<std::array<double, 2>> strain;  // rows [mean by von Mises stress, plastic strain]
  std::optional<double> damage;
  double damage_exponent = 1;                           // damage is its sum over the plastic strain to this power
  double exponent = 1;                                  // of the loss of force
  std::vector<std::array<double, 2>> exponent_of_size;  // rows [size of an element, exponent]; none: as above
};
/// Failure by shear.
struct ShearDamageDeck {
  std::vector<std::array<double, 2>> strain;  // rows [ratio of stresses, plastic strain]
  double pressure_factor = 0;
};
struct FailureDeck {
  std::optional<double> plastic_strain;    // equivalent
  std::optional<double> principal_stress;  // largest, tension positive
  std::optional<double> principal_strain;  // largest, logarithmic
  std::optional<double> thinning;          // of a layer of a shell, logarithmic
  std::optional<double> mean_thinning;     // of a shell over its thickness, logarithmic
  std::optional<double> pressure;          // below minus this
  std::optional<JohnsonCookDamageDeck> johnson_cook;
  std::vector<std::array<double, 2>>
      triaxiality;  // rows [mean by von Mises stress, plastic strain]; none: no criterion
  std::optional<ShearDamageDeck> shear;
  std::vector<std::array<double, 2>> rate;  // rows [plastic strain rate, factor of the strains of tables]; none: 1
  std::optional<DamageEvolutionDeck> evolution;
  std::optional<DamageCouplingDeck> coupling;
  std::optional<double> yield_time;           // at yield, in all
  std::optional<double> fibre_damage;         // of plies of shells: damage of the fibres
  std::optional<double> volume_below;         // of solids: V / V(0) falls below this
  std::optional<double> volume_above;         // of solids: V / V(0) rises above this
  std::optional<BeamFailureDeck> resultants;  // of beams
  std::optional<double> time;                 // of beams: at this time
  std::optional<double> step;                 // the step that the element allows falls below this
  bool inverted = false;                      // no positive volume: the element fails, and the run continues
  int fade_steps = 1;                         // steps in which its force falls to zero
  double layers = 1;                          // of shells: share of the thickness that has to fail
  std::vector<std::array<double, 2>> size;    // rows [size of an element, factor of the failure strains]; none: 1
};
/// Treatment of nodes whose elements are all eroded.
struct ErosionDeck {
  enum class FreeNodes { keep, remove };
  FreeNodes free_nodes = FreeNodes::keep;
};

/// A ply of a laminate.
struct LaminatePly {
  std::string material;
  LawDeck law;
  double density = 0;
  double share = 1;  // of the thickness
  double angle = 0;  // as PlyDeck::angle
};
struct MaterialDeck {
  std::string name;
  double density = 0;
  LawDeck law;
  std::optional<LawDeck> equation_of_state;
  Place place;
  std::optional<FailureDeck> failure;
  std::vector<LaminatePly> plies;  // of a laminate (src/deck/laws/laminates.hpp); density: their mean
};

// --- where a condition acts

/// The same speed at every node, along the line to it from a point or from an axis.
struct RadialVelocityDeck {
  double speed = 0;  // outward
  Vec3 center{};
  std::optional<Vec3> axis;  // a unit vector; none: from the point
};

struct InitialDeck {
  Selector where;
  Vec3 velocity{};
  Vec3 angular_velocity{};     // rad/s
  std::optional<Vec3> center;  // default: the mass centre of the selected nodes
  std::optional<RadialVelocityDeck> radial_velocity;
};

/// About an axis of space at rest, from where the nodes are.
struct TurnDeck {
  std::size_t axis = 0;    // x, y, z
  Vec3 through{};          // a point of the axis
  Curve angular_velocity;  // [rad / time]
};

/// Exactly one of the kinds a list entry. Directions are the axes x, y, z and, of nodes of shells, rotations about
/// them. Of a body: of its centre, and its turns about axes through it; directions that are not named stay free.
struct ConditionDeck {
  enum class Kind { fixed, symmetry, velocity, displacement, turn };
  Selector where;
  Kind kind = Kind::fixed;
  std::array<bool, 6> active{};  // which directions are held: x, y, z, then rotations about x, y, z
  std::array<Curve, 6> value;    // velocity, displacement or angular velocity [rad / time] in each active direction
  std::optional<TurnDeck> turn;  // both directions across its axis are active
  SwitchDeck when;
};

/// Acceleration of everything [length / time^2].
struct GravityDeck {
  std::array<Curve, 3> along;  // x, y, z

  Vec3 at(double time) const { return {along[0](time), along[1](time), along[2](time)}; }
  /// Whether it is the same at all times.
  bool is_constant() const { return along[0].is_constant() && along[1].is_constant() && along[2].is_constant(); }
  bool any() const { return !is_constant() || at(0) != Vec3{}; }
};

/// A charge of TNT: a hemisphere on the ground, or a sphere in free air.
struct BlastDeck {
  enum class Burst { ground, air };
  double charge = 0;  // [mass]
  Vec3 center{};
  double time = 0;  // of the detonation
  bool has_negative_phase = false;
  Burst burst = Burst::ground;
};

/// Pressure on faces, positive acts against the outward normal, on the current area. With a direction (a unit vector):
/// a dead load along it, on the area at the start.
struct PressureDeck {
  Selector where;
  Curve value;
  std::optional<BlastDeck> blast;  // instead of the value
  std::optional<Vec3> direction;
  SwitchDeck when;
};

/// Forces and, of nodes of shells, moments, on each of the nodes; or on a point of a rigid body.
struct NodalLoadDeck {
  Selector where;
  std::array<bool, 6> active{};  // which are given: forces along x, y, z, then moments about x, y, z
  std::array<Curve, 6> value;
  SwitchDeck when;
  std::optional<Vec3> at{};  // of a body, at time 0; none: its centre
};

/// A force -c m v on nodes, of shells also -c I w.
struct DampingDeck {
  Selector where;
  Curve coefficient;  // c [1 / time]
};

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
  /// system with complementarity, or by springs on the penetration.
  enum class Enforcement { kinematic, lagrange, penalty };
  Enforcement enforcement = Enforcement::kinematic;
  double tolerance = 1e-3;            // kinematic: of what is left, as a share of the largest predicted penetration
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

struct TimeDeck {
  double end = 0;
  std::string until;  // a sensor that ends the run before; empty: none
  double step_scale = 0.9;
  /// What is stable: the least bound of an element, or the largest eigenvalue of the mesh, estimated now and then.
  enum class StepEstimate { element, global };
  StepEstimate step_estimate = StepEstimate::element;
  std::optional<MassScalingDeck> mass_scaling;  // of every part
  std::optional<double> max_step;               // upper bound of the step [s]
  std::optional<long> max_steps;                // stop as "completed" after so many
  double collapse_ratio = 1e-4;                 // a step below this share of the first one is an error
};

struct AuditDeck {
  double max_energy_error = 0.1;     // relative; a run that leaves it stops with exit code 3
  double max_momentum_error = 1e-6;  // the same, linear and angular
  // Energy that contact may give / largest energy, beyond which the run stops with exit code 3; none: it warns.
  std::optional<double> max_contact_gain;
};

struct Deck {
  // Not inline: every source would compile them, which takes longer than the rest of this header.
  Deck();
  Deck(const Deck&);
  Deck(Deck&&) noexcept;
  Deck& operator=(const Deck&);
  Deck& operator=(Deck&&) noexcept;
  ~Deck();

  std::string file;  // as given on the command line
  std::string text;  // of the file, without what --set changes
  std::string title;
  std::string units;
  TimeDeck time;
  std::vector<PartDeck> parts;        // in the order of the deck
  std::vector<MirrorDeck> mirrors;    // whose images are among the parts
  std::vector<PatternDeck> patterns;  // likewise
  std::vector<PlaceDeck> placements;  // in the order of the deck
  std::vector<JoinDeck> joins;
  std::vector<MaterialDeck> materials;
  std::vector<ImperfectionDeck> imperfections;
  std::vector<AddedMassDeck> added_masses;
  std::vector<RigidSetDeck> rigid_sets;
  std::vector<SpringDeck> springs;
  std::vector<WeldDeck> welds;
  std::vector<ConstraintDeck> constraints;
  std::vector<EmbeddedDeck> embedded;
  std::vector<JointDeck> joints;
  std::vector<TurnSpringDeck> turn_springs;
  ElementDeck elements;
  ErosionDeck erosion;
  std::vector<InitialDeck> initial;
  StartDeck start;
  std::vector<SensorDeck> sensors;
  GravityDeck gravity;
  std::vector<PressureDeck> pressures;
  std::vector<NodalLoadDeck> nodal_loads;
  std::vector<ConditionDeck> conditions;
  std::vector<DampingDeck> dampings;  // of several that name a node the last one holds
  std::vector<WallDeck> walls;
  ContactDeck contact;
  OutputDeck output;
  AuditDeck audit;
  std::vector<std::string> motion_values;  // "time.step_scale = 0.9": all that the motion depends on (deck_values.hpp)
  std::vector<std::string> settings;       // the --set arguments
  std::vector<std::string> overrides;      // left sides of the --set arguments
  KeyPlaces places;                        // of its keys
  std::vector<UsedSelector> selectors;     // all of the deck
  std::vector<Warning> warnings;           // of the deck alone; what is silenced is still among them
  std::set<std::string> silenced;          // rules whose warnings nobody wants to see (src/output/warning_log.hpp)
  std::string resolved;                    // all its values, with the --set arguments, as JSON (yaml/deck_json.hpp)

  /// "deck.yaml:LINE:COLUMN" or "--set KEY" for messages found after reading (meshing, selection).
  std::string where(Place place) const;

  /// Of a part: its own, and of the whole scene what it does not say.
  ElementDeck find_elements(std::size_t part) const { return find_settings(elements, parts[part].own_elements); }
  /// Of a part: its own, or that of the whole scene; null: its masses stay.
  const MassScalingDeck* find_mass_scaling(std::size_t part) const;
  /// Whether any part is given mass during the run.
  bool scales_mass_in_run() const;
};

}  // namespace percuss
