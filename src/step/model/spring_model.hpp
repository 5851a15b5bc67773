#pragma once
// Springs, dampers and welds between two nodes, nodes that move equally or with solids, and their state. Every rank has
// all of them, and the same bits.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "kernels/contact/geometry/connection_strength.hpp"
#include "kernels/core/tensor.hpp"
#include "kernels/core/views.hpp"
#include "src/deck/spring_deck.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Nodes that connections name, and those of them that a rank holds.
struct ConnectedNodes {
  std::vector<std::int64_t> nodes;     // by number in the whole mesh, ascending
  Array<int> owned_node, owned_place;  // of those that this rank owns: the node, and its place in `nodes`
  Array<int> local_node, local_place;  // of all that this rank holds
};

/// Nodes on which connections act by forces.
struct ForcedNodes : ConnectedNodes {
  int first_slot = 0;  // a slot for each node that it owns
};

/// Law of the springs of an entry of the deck.
struct SpringLaw {
  static constexpr double unbreakable = 0;

  std::vector<std::array<double, 2>> rows;  // elongation, force; at least two, or none: no force of elongation
  double largest_slope = 0;                 // of the rows: find_largest_slope()
  double damping = 0;
  SpringDeck::Acts acts = SpringDeck::Acts::both;
  double largest_force = unbreakable, largest_elongation = unbreakable;
};

/// Const after set-up.
struct Spring {
  std::string name;
  int law = 0;
  std::array<int, 2> end{};  // places in SpringModel::nodes
  double rest_length = 0;
  double start_length = 0;  // at time 0
  bool has_columns = true;  // of its own in the history
};

struct SpringModel : ForcedNodes {
  std::vector<SpringLaw> laws;
  std::vector<Spring> springs;
  std::vector<std::string> notes;  // what is to be reported of them

  bool any() const { return !springs.empty(); }
  bool has(std::int64_t spring) const { return spring >= 0 && spring < static_cast<std::int64_t>(springs.size()); }
};

/// "spring 'strap_3'"
inline std::string name_spring(const SpringModel& model, std::int64_t spring) {
  return "spring '" + model.springs[static_cast<std::size_t>(spring)].name + "'";
}

/// A spring in the loop. A force pulls both ends together where it is positive.
struct SpringState {
  double elongation = 0;   // at n: length less that at rest
  double elastic = 0;      // force of the elongation, at n
  double damping = 0;      // force of the damper, at n, from the rate at n-1/2 (at n = 0: at 0)
  Vector3<double> axis{};  // unit vector from the first end to the second, at n; zero where they are one place
  double length = 0;       // at n
  std::int64_t is_broken = 0;

  double force() const { return elastic + damping; }
};

/// Law of the welds of an entry of the deck.
struct WeldLaw {
  static constexpr double unbreakable = std::numeric_limits<double>::infinity();

  std::string name, place;      // of the entry in the deck
  ConnectionStrength strength;  // of forces; compression counts as tension does
  double time = unbreakable;    // at which it fails
};

/// For two nodes of a patch, as places among these: the mean of the product of their shape functions over a region.
struct ShapeProduct {
  int node = 0, other = 0;
  double mean = 0;
};

/// Nodes whose mean rigid motion an end of a weld takes.
struct WeldPatch {
  std::vector<int> nodes;  // places in WeldModel::nodes, ascending
  // Weights of a region of faces; otherwise masses are the weights:
  std::vector<double> weights;         // [nodes] mean of the shape function of each over the region; their sum is 1
  std::vector<ShapeProduct> products;  // of each node with each that it shares a face with, itself included
  bool is_region() const { return !weights.empty(); }
};

/// Two nodes that move as one until it fails, or two regions of faces; const after set-up.
struct Weld {
  std::string name;
  int law = 0;
  std::array<int, 2> end{-1, -1};    // places in WeldModel::nodes; -1: it has a region
  std::array<int, 2> patch{-1, -1};  // of WeldModel::patches, in place of the node alone; -1: none
  double length = 0;                 // at time 0
  Vector3<double> normal{};          // unit vector at time 0
  bool is_normal_its_line = false;   // whether the normal stays the line between the nodes
  bool has_columns = true;           // of its own in the history
  bool has_regions() const { return end[0] < 0; }
};

struct WeldModel : ConnectedNodes {
  std::vector<WeldLaw> laws;
  std::vector<Weld> welds;
  std::vector<WeldPatch> patches;
  std::vector<std::string> notes;  // what is to be reported of them
  std::vector<Warning> warnings;   // likewise, of what is suspicious
  bool shares_nodes = false;       // whether some node has several welds

  bool any() const { return !welds.empty(); }
};

/// A weld in the loop.
struct WeldState {
  Vector3<double> normal{};  // unit vector at n, from the first node to the second
  double pull = 0;           // force along it in the last step, positive in tension
  double shear = 0;          // amount of the force across it
  std::int64_t is_broken = 0;
};

/// Nodes that move equally in some directions, or of which equations hold, as the deck names them; const after set-up.
struct Constraint {
  std::string name, place;  // of the entry in the deck
  std::array<bool, 3> equal{};
  bool has_pairs = false;
  bool is_equation = false;
  std::optional<Curve> sum;  // of the terms of its equations [length]; none: 0
  std::vector<int> nodes;    // places in ConstraintModel::nodes: those of the first side of pairs, or all
};

/// A factor times an unknown of a linear constraint.
struct ConstraintTerm {
  int unknown = 0;
  double factor = 0;
};

/// A linear equation of displacements.
struct ConstraintRow {
  int constraint = 0;
  std::size_t direction = 0;          // of a constraint that makes nodes equal
  std::vector<ConstraintTerm> terms;  // unknown: three times the place in ConstraintModel::nodes, and the direction
};

/// Nodes that move equally in one direction: those of all constraints that share a node are one group.
struct EqualGroups {
  std::vector<int> first{0};  // [groups + 1] of `members`
  std::vector<int> members;   // places in ConstraintModel::nodes, ascending in each group
};

struct ConstraintModel : ConnectedNodes {
  std::vector<Constraint> constraints;
  std::array<EqualGroups, 3> groups;  // by direction; empty where there are rows
  std::vector<ConstraintRow> rows;    // of all constraints, where one of them is an equation; else empty
  std::vector<std::string> notes;     // what is to be reported of them

  bool any() const { return !constraints.empty(); }
};

/// A node that keeps its place within a solid: it moves as the corners of that do, by these weights, whose sum is 1.
struct EmbeddedNode {
  int node = 0;              // place in EmbeddedModel::nodes, as of the corners
  std::int64_t element = 0;  // the solid, by its number in the whole mesh
  int corner_count = 0;
  std::array<int, 8> corners{};
  std::array<double, 8> weights{};
};

/// Nodes of bars in solids; const after set-up.
struct EmbeddedModel : ConnectedNodes {
  std::vector<EmbeddedNode> embedded;  // each node once
  std::vector<std::string> notes;      // what is to be reported of them

  bool any() const { return !embedded.empty(); }
};

/// A constraint in the loop.
struct ConstraintState {
  // Forces of the last step: on the first side of pairs, or half the sum of amounts on all nodes; of equations x is the
  // force on displacements of factor 1.
  Vector3<double> force{};
};

}  // namespace percuss
