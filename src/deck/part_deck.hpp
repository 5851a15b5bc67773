#pragma once
// Parts, and what is rigid.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/deck/beam_deck.hpp"
#include "src/deck/element_deck.hpp"
#include "src/deck/functions/place_function.hpp"
#include "src/deck/functions/selector.hpp"
#include "src/deck/mesh_changes.hpp"
#include "src/deck/shape_deck.hpp"

namespace percuss {

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
  std::optional<long> every;  // steps between two checks during the run; none: at the start only
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
  /// Elements that the cells of a generated solid become: hexahedra, or twelve, six or five tetrahedra, two wedges or
  /// six pyramids each.
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
  /// Whether it has tetrahedra without nodes in the middle of cells.
  bool has_bare_tetrahedra() const {
    return elements == Elements::six_tetrahedra || elements == Elements::five_tetrahedra;
  }
  bool has_thickness() const { return thickness || thickness_by_place || thickness_of_file; }
  bool varies_in_thickness() const { return thickness_by_place || thickness_of_file; }
};

}  // namespace percuss
