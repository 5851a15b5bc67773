#pragma once
// What the rules need to know of a mesh: sizes, velocities and held nodes by part, of all ranks together.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernels/core/views.hpp"
#include "kernels/element/element_chunks.hpp"
#include "src/checks/selection_measures.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Length over thickness from which on an element counts as a sliver: sheets of one layer and adhesive have 50.
inline constexpr double least_sharp = 100;

/// A part at time 0, of all ranks together.
struct PartMeasures {
  Vec3 low{}, high{};                    // box of its nodes [length]
  Vec3 velocity_low{}, velocity_high{};  // range of each component over its nodes [length / time]
  double speed = 0;                      // of its fastest node [length / time]
  double shortest_edge = 0;              // of its elements [length]
  double longest_edge = 0;               // of its elements [length]
  double mass = 0;                       // of its elements, by their density [mass]
  // Size of its smallest and largest element: edge of a cube or a square as large, or the length of a beam [length].
  double smallest_element = 0, largest_element = 0;
  // Across the thinnest direction of its thinnest element, and of that of its elements that are 100 times as long as
  // thin, of solids and shells [length].
  double thinnest = std::numeric_limits<double>::infinity(), thinnest_sliver = thinnest;
  double sharpest = 0;     // length over this of the sharpest of its elements
  std::int64_t nodes = 0;  // nodes
  // Sums over its nodes of x, y and z, then of their squares, as shares of the box of the scene in units of 2^-30:
  // whole numbers, whose sum has no order.
  std::array<std::int64_t, 6> moments{};
  std::int64_t solids = 0, shells = 0, beams = 0;  // elements
  std::int64_t triangles = 0;                      // shells of three corners
  std::int64_t small_solids = 0;                   // solids that are no hexahedra
  std::array<std::int64_t, 3> long_ways{};         // hexahedra 1.5 times as long along this direction as along another
  std::int64_t single_layer = 0;               // hexahedra with just two opposite faces on the surface, as of a sheet
  std::int64_t layered_wedges = 0;             // wedges with both triangles on the surface, or cut along such a cell
  double layer_thickness = 0;                  // largest distance of these faces [length]
  std::int64_t cut_solids = 0, cut_faces = 0;  // tetrahedra and pyramids, and their faces on the surface
  double cut_volume = 0, cut_area = 0;         // of these [length^3, length^2]
  double shell_thickness = 0;                  // of the thickest of its shells [length]

  std::int64_t elements() const { return solids + shells + beams; }
  double extent() const;  // longest edge of its box [length]
  friend bool operator==(const PartMeasures&, const PartMeasures&) = default;
};

/// The nodes of an entry of `initial`.
struct InitialMeasures {
  static constexpr int no_condition = std::numeric_limits<int>::max();

  std::int64_t selected = 0;  // nodes that it names
  std::int64_t governed = 0;  // of these, nodes that no later entry names
  std::int64_t moving = 0;    // of these, nodes that it gives a velocity that is not zero
  std::int64_t stopped = 0;   // of these, nodes that a condition keeps from moving so
  // The first entry of `conditions` that does, or behind them the first rigid part by its `fixed`.
  int condition = no_condition;
  friend bool operator==(const InitialMeasures&, const InitialMeasures&) = default;
};

/// Two parts that are joined.
struct JointMeasures {
  int part = 0, other = 0;  // part < other
  std::int64_t nodes = 0;   // that both have
  std::int64_t faces = 0;   // faces of `part` all of whose nodes both have
  friend bool operator==(const JointMeasures&, const JointMeasures&) = default;
};

struct SceneMeasures {
  std::vector<PartMeasures> parts;       // as Deck::parts
  std::vector<InitialMeasures> initial;  // as Deck::initial
  Vec3 low{}, high{};                    // box of all nodes [length]
  std::vector<int> assemblies;           // [parts] the lowest part that each is joined to, directly or not, or itself
  std::vector<JointMeasures> joints;     // as Mesh::joints; empty where the deck joins no parts
  SelectionMeasures selections{};        // of loads and conditions

  /// Whether two parts share nodes, directly or through others.
  bool are_joined(std::size_t part, std::size_t other) const { return assemblies[part] == assemblies[other]; }
  /// [parts] whether it and all that it is joined to are beams, which touch nothing.
  std::vector<bool> mark_beams() const;
  bool is_joined(std::size_t part) const {
    return std::count(assemblies.begin(), assemblies.end(), assemblies[part]) > 1;
  }
};

/// Measures a mesh; each rank its share. start_velocity: [nodes of the share] at time 0 [length / time]. The same on
/// all ranks. Collective over the mesh's ranks. Throws InputError as select_nodes(), MpiError.
SceneMeasures measure_scene(const Deck& deck, const ChunkedMesh& chunked, const Rows3<double>& start_velocity);

/// [parts] the range of each component of the velocity over the nodes of a part. velocity: [nodes of the share]. The
/// same on all ranks. Collective over the mesh's ranks. Throws MpiError.
void find_velocity_ranges(const Mesh& mesh, const Rows3<double>& velocity, std::vector<Vec3>& low,
                          std::vector<Vec3>& high);

/// [parts] the least step bound of each part's elements at time 0, without step_scale [time]; infinity: nothing bounds
/// it. results: of the elements at time 0. The same on all ranks. Collective over the mesh's ranks. Throws MpiError.
std::vector<double> find_part_steps(const ChunkedMesh& chunked, const ChunkResults& results);

}  // namespace percuss
