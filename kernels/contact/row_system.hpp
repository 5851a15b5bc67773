#pragma once
// All rows of a step as one system, and the nodes that they touch.
//
// Rows are sorted: faces' rows by (node, face), then walls' rows by (wall, node). Each touched node knows its entries
// (row, slot) in that order, so that every sum over a node has one order whatever the number of threads.

#include "kernels/contact/contact_row.hpp"
#include "kernels/contact/detailed_check.hpp"
#include "kernels/contact/row_sums.hpp"

namespace percuss {

/// A rigid plane; bodies live where (x - point) . normal > 0.
struct ContactWall {
  Point3 point{}, normal{};
  double friction = 0;
};

/// Walls and the contact nodes that each may touch, const after set-up.
struct WallPairs {
  Array<const ContactWall> walls;  // [walls]
  Array<const int> wall;           // [pairs] ascending
  Array<const int> node;           // [pairs] contact node, ascending within a wall
  Array<const double> size;        // [pairs] shortest edge at the node at the start, the h of its row
};

/// What rows read besides the touches.
struct RowInputs {
  SurfaceMotion motion;
  Rows3<const double> inverse_mass;  // [mesh nodes][3], 0: held
  double impulse_scale = 1;          // dt / last dt: the same force in this step, the first guess
};

struct RowSystem {
  int num_rows = 0;
  int num_nodes = 0;
  Array<ContactRow> rows = Array<ContactRow>("contact::rows", 0);
  // Per row: 1 if it pushes, 2 if it did in the iterate before. Rows at rest are passed over without being read.
  Array<int> awake = Array<int>("contact::awake_rows", 0);
  Array<int> nodes = Array<int>("contact::touched_nodes", 0);              // [num_nodes] mesh nodes, in no order
  Array<int> offset = Array<int>("contact::entry_offset", 0);              // [num_nodes + 1]
  Array<int> entry = Array<int>("contact::entries", 0);                    // row * row_nodes + slot, ascending by node
  Rows3<double> correction = Rows3<double>("contact::correction", 0);      // dv of the iterate
  Rows3<double> extrapolated = Rows3<double>("contact::extrapolated", 0);  // dv of the extrapolated iterate
  Rows3<double> abs_sum = Rows3<double>("contact::abs_sum", 0);            // S
  // Scratch of the set-up.
  Array<int> place_of_node = Array<int>("contact::place_of_node", 0);  // [mesh nodes] -1 outside set-up
  Array<int> entry_key = Array<int>("contact::entry_key", 0), entry_value = Array<int>("contact::entry_value", 0);
  Array<int> count = Array<int>("contact::entry_count", 0);
  Array<int> total = Array<int>("contact::row_total", 1);
  SumScratch sums = SumScratch("contact::row_sums", 0);
};

inline constexpr int pushes_now = 1, pushed_before = 2;

/// Impulse of all rows on touched node a, in row order.
KOKKOS_INLINE_FUNCTION Point3 gather_impulse(const Array<const ContactRow>& rows, const Array<const int>& awake,
                                             const Array<const int>& offset, const Array<const int>& entry, int a) {
  Point3 sum{};
  for (int e = offset(a); e < offset(a + 1); ++e) {
    if ((awake(entry(e) / row_nodes) & pushes_now) == 0) continue;
    const ContactRow& row = rows(entry(e) / row_nodes);
    sum = sum + spread_impulse(row, entry(e) % row_nodes, row.force, row.couple);
  }
  return sum;
}

/// Velocity of the nodes of a row in node data of the mesh.
struct MeshVelocity {
  Rows3<const double> v;
  const ContactRow& row;
  KOKKOS_INLINE_FUNCTION Point3 operator()(int slot) const { return load_row(v, row.node[slot]); }
};

/// Velocity of the nodes of a row in data of the touched nodes.
struct TouchedVelocity {
  Rows3<const double> v;
  const ContactRow& row;
  KOKKOS_INLINE_FUNCTION Point3 operator()(int slot) const { return load_row(v, row.place[slot]); }
};

/// Makes the rows of this step from touches and walls, first guess from history; sums S and row sums D.
/// Returns through system.num_rows 0 if there is nothing in reach.
template <class Space>
void build_rows(const Space& space, const ContactSurface& surface, const CandidateList& candidates,
                const TouchTable& touches, const WallPairs& walls, const ContactHistory& history,
                const RowInputs& inputs, RowSystem& system);

}  // namespace percuss
