#pragma once
// All rows of a step as one system, and the nodes that they touch (the paper's section 4.3).
//
// A rank has the rows of the contact nodes that it owns, in the order of their keys (make_face_row_key()). The corners
// of a face may belong to other ranks: of these foreign nodes it has a copy for each row and corner that touches one,
// and their owners get the row's impulses on them as remote entries. Each owned node knows its entries, local and
// remote, in the order of ContactRow::key, so that every sum over a node has one order whatever the number of threads
// and ranks.

#include "kernels/contact/check/detailed_check.hpp"
#include "kernels/contact/check/edge_check.hpp"
#include "kernels/contact/geometry/spring_rows.hpp"
#include "kernels/contact/geometry/tie_geometry.hpp"
#include "kernels/contact/rows/contact_row.hpp"
#include "kernels/contact/rows/row_bodies.hpp"
#include "kernels/contact/rows/row_pack.hpp"
#include "kernels/contact/rows/row_sums.hpp"
#include "kernels/contact/rows/wall_pairs.hpp"

namespace percuss {

/// A touch of the detailed check as its row needs it.
struct RowTouch {
  std::int64_t key = 0;    // ContactRow::key
  std::int64_t face = -1;  // number of the face or of edge B
  RowKind kind = RowKind::face;
  int count = row_nodes;  // slots in use, 5 or 4
  double weight[row_nodes] = {1, 0, 0, 0, 0};
  Point3 normal{};
  double gap_start = 0, gap_end = 0;  // at n and predicted
  double size = 0;                    // h
  double friction = 0;
  int pair = 0;                                // ContactRow::pair
  bool is_caught = false;                      // ContactRow::is_caught
  bool has_thickness = false;                  // likewise
  double offset = 0;                           // distance that the two sides keep by thickness
  int record = -1;                             // history record that the row writes
  int old_record = -1;                         // history record that it continues, -1: none
  int node[row_nodes] = {-1, -1, -1, -1, -1};  // mesh node of this rank; -1 - k: of another, slot k of all such
  std::int64_t node_number[row_nodes] = {-1, -1, -1, -1, -1};  // of the nodes, where some are foreign
};

/// Whether two sides are, or would be, nearer than they should: the side from which they came must then be remembered,
/// push or no push. Of solids the depth must be more than round-off.
template <class AnyTouch>
KOKKOS_INLINE_FUNCTION bool is_overlapping(const AnyTouch& touch) {
  const double least = touch.offset > 0 ? 0 : -contact_limits::overlap * touch.size;
  return touch.gap_start < least || touch.gap_end < least;
}

/// Touch of the row of a node on a face, from the check.
KOKKOS_INLINE_FUNCTION RowTouch make_row_touch(const Touch& touch) {
  RowTouch row;
  for (int i = 0; i < 4; ++i) row.weight[i + 1] = -touch.weight[i];
  row.normal = touch.normal;
  row.gap_start = touch.gap_start;
  row.gap_end = touch.gap_end;
  row.size = touch.size;
  row.has_thickness = touch.offset > 0;
  row.offset = touch.offset;
  row.is_caught = !touch.opposed || is_overlapping(touch);
  return row;
}

/// Touch of the row of two edges, from the check.
KOKKOS_INLINE_FUNCTION RowTouch make_edge_row_touch(const EdgeTouch& touch) {
  RowTouch row;
  row.kind = RowKind::edges;
  row.count = 4;
  row.weight[0] = 1 - touch.s;
  row.weight[1] = touch.s;
  row.weight[2] = touch.t - 1;
  row.weight[3] = -touch.t;
  row.normal = touch.normal;
  row.gap_start = touch.gap_start;
  row.gap_end = touch.gap_end;
  row.size = touch.size;
  row.has_thickness = touch.offset > 0;
  row.offset = touch.offset;
  row.is_caught = is_overlapping(touch);
  row.old_record = touch.record;
  return row;
}

/// Keys of rows, the order of every sum: by number of the node and order of its touches; then edge pairs by number of
/// edge A and order of its touches; then ties by node; then walls by (node, wall). An edge is numbered by its lower
/// node and its place among that node's edges.
KOKKOS_INLINE_FUNCTION std::int64_t make_face_row_key(std::int64_t node, int touch) {
  return node * (contact_limits::max_touches + 1) + touch;
}
inline constexpr int wall_key_bits = 20;        // a million walls, on 4e12 nodes
inline constexpr int edge_place_bits = 7;       // 128 feature edges that have the same lower node
inline constexpr int edge_touch_key_bits = 16;  // 65536 touches of an edge, on 1e11 nodes
inline constexpr std::int64_t first_wall_key = std::int64_t{1} << 62, first_edge_key = std::int64_t{1} << 61,
                              first_tie_key = std::int64_t{3} << 60;
KOKKOS_INLINE_FUNCTION int find_key_wall(std::int64_t key) {
  return static_cast<int>((key - first_wall_key) & ((std::int64_t{1} << wall_key_bits) - 1));
}
KOKKOS_INLINE_FUNCTION std::int64_t make_wall_row_key(std::int64_t node, int wall) {
  return first_wall_key + (node << wall_key_bits) + wall;
}
KOKKOS_INLINE_FUNCTION std::int64_t make_edge_row_key(std::int64_t edge, int touch) {
  return first_edge_key + (edge << edge_touch_key_bits) + touch;
}

KOKKOS_INLINE_FUNCTION std::int64_t make_tie_row_key(std::int64_t node) { return first_tie_key + node; }
inline constexpr std::int64_t turning_key_mark = std::int64_t{1}
                                                 << 59;  // rotations of tied nodes come after all places
KOKKOS_INLINE_FUNCTION std::int64_t make_turning_row_key(std::int64_t node) {
  return make_tie_row_key(node) + turning_key_mark;
}
KOKKOS_INLINE_FUNCTION bool is_turning_row_key(std::int64_t key) {
  return key >= first_tie_key + turning_key_mark && key < first_wall_key;
}

/// Number of edge A of the row with this key.
KOKKOS_INLINE_FUNCTION std::int64_t find_key_edge(std::int64_t key) {
  return (key - first_edge_key) >> edge_touch_key_bits;
}

/// Number of the contact node of the row with this key; of two edges the lower node of edge A.
KOKKOS_INLINE_FUNCTION std::int64_t find_key_node(std::int64_t key) {
  if (key >= first_wall_key) return (key - first_wall_key) >> wall_key_bits;
  if (key >= first_tie_key) return (key - first_tie_key) & (turning_key_mark - 1);
  if (key >= first_edge_key) return find_key_edge(key) >> edge_place_bits;
  return key / (contact_limits::max_touches + 1);
}

/// Data of the nodes that rows touch, by place.
struct RowNodes {
  Rows3<double> x = Rows3<double>("contact::row_x", 0);
  Rows3<double> v = Rows3<double>("contact::row_v", 0);  // predicted without contact
  Rows3<double> v_before = Rows3<double>("contact::row_v_before", 0);
  Rows3<double> v_checked = Rows3<double>("contact::row_v_checked", 0);        // with which the check saw them
  Rows3<double> inverse_mass = Rows3<double>("contact::row_inverse_mass", 0);  // 0: held
  Array<double> spring = Array<double>("contact::row_spring", 0);              // RowInputs::spring, where it is set
  Array<double> growth = Array<double>("contact::row_growth", 0);              // of masses by damping; with springs
};

/// The node's own rotation in a row that ties it, which no other row touches. Spins times the lever.
struct TurningRow {
  Point3 compliance{};  // lever^2 / inertia by axis; 0: held
  Point3 before{};      // at n-1/2
  Point3 predicted{};   // at n+1/2 without the tie
};

/// Rotations of nodes; empty: none is tied.
struct SpinInputs {
  Rows3<double> spin{};                   // [mesh nodes] in: at n+1/2 predicted without contact; out: corrected
  Rows3<const double> before{};           // [mesh nodes] at n-1/2
  Rows3<const double> inverse_inertia{};  // [mesh nodes] 0: held
  Array<const double> inertia{};          // [mesh nodes] 0: the node has no rotation
  Rows3<double> moment{};                 // [mesh nodes] out: what ties give the owned nodes [force x length x time]
};

/// Whether contact pushed a node in the last step. The check then sees it going on as it went.
KOKKOS_INLINE_FUNCTION bool was_pushed(const Rows3<const double>& last_impulse, int node) {
  const Point3 impulse = load_row(last_impulse, node);
  return impulse.x != 0 || impulse.y != 0 || impulse.z != 0;
}

/// Inputs of the rows.
struct RowInputs {
  SurfaceMotion motion;
  Rows3<const double> v_before;            // [mesh nodes][3]
  Rows3<const double> inverse_mass;        // [mesh nodes][3], 0: held; of rigid bodies anything
  Array<const std::int64_t> node_numbers;  // [mesh nodes]
  double impulse_scale = 1;                // dt / last dt: the same force in this step, the first guess
  SpringRows springs = SpringRows::none;
  int num_pairs = 1;  // of surfaces and ties; walls are booked after them
  // Sides push each other from this depth on: those that touch but for the round-off of their places are at rest to the
  // last bit. The same in all rows: what one wants must not contradict the others beside it by however little.
  double depth_tolerance = 0;
  // [mesh nodes] stiffness of springs.hpp, empty without springs; 0: a node whose rows have none.
  Array<const double> spring{};
  Array<const double> growth{};        // [mesh nodes] by how much damping raises the masses; empty: nowhere
  Array<const TieGeometry> ties{};     // of this rank; their touches come last
  Rows3<const double> last_impulse{};  // [mesh nodes] of contact in the last step; empty: none
  bool looks_inside = true;            // whether walls are to stop nodes inside bodies too
  BodyInputs bodies{};                 // rigid ones
  SpinInputs spins{};
  // Parting over approach of rows between rigid bodies; negative: 0, and mark_rigid_rows() need not tell them.
  double restitution = -1;
};

/// Whether springs push any rows.
KOKKOS_INLINE_FUNCTION bool has_springs(const RowInputs& inputs) { return inputs.springs != SpringRows::none; }

/// Sources of rows, besides ties: touches by (node, face), then those of edges and ties, and pairs of walls.
struct RowSources {
  Array<const RowTouch> touches;
  int num_touches = 0;
  WallPairs walls;
};

/// Numbers of the faces and contact nodes of a surface in the whole mesh.
struct SurfaceNumbers {
  Array<const std::int64_t> faces, nodes;
};

struct RowSystem {
  int num_rows = 0;
  int num_edge_rows = 0;     // of edge pairs among them, after those of faces
  int num_nodes = 0;         // places of nodes that this rank owns
  int num_foreign = 0;       // places after these: nodes of other ranks that rows of this one touch
  int num_remote = 0;        // entries that rows of other ranks have on nodes of all these places
  int num_sent = 0;          // entries of this rank's rows that other ranks want, once for each of them
  bool has_springs = false;  // whether springs may push rows
  Array<ContactRow> rows = Array<ContactRow>("contact::rows", 0);
  Array<int> nodes = Array<int>("contact::touched_nodes", 0);  // [num_nodes] mesh nodes, as rows come to them
  Array<int> foreign =
      Array<int>("contact::foreign_nodes", 0);  // [k] foreign node of the slot with RowTouch::node -1 - k
  Array<std::int64_t> foreign_number = Array<std::int64_t>("contact::foreign_number", 0);  // [num_foreign] of the node
  RowNodes at;                                                 // [num_places() + 1], the last for slots not in use
  Array<int> offset = Array<int>("contact::entry_offset", 0);  // [num_places() + 1]
  // row * row_nodes + slot; from num_rows * row_nodes on the remote entries. By node, ascending in the row's key.
  Array<int> entry = Array<int>("contact::entries", 0);
  // Share of each entry in the sum of its node, in the order of `entry`.
  Rows4<double> shares = Rows4<double>("contact::shares", 0);
  Array<int> share_of_slot = Array<int>("contact::share_of_slot", 0);      // [rows * row_nodes] in shares, -1: no slot
  Array<int> share_of_remote = Array<int>("contact::share_of_remote", 0);  // [num_remote] likewise
  Array<int> remote_node = Array<int>("contact::remote_node", 0);          // own mesh nodes that rows of others touch
  Array<int> remote_place = Array<int>("contact::remote_place", 0);        // [num_remote]
  Array<std::int64_t> remote_key = Array<std::int64_t>("contact::remote_key", 0);  // [num_remote] of its row
  Rows3<double> remote = Rows3<double>("contact::remote", 0);                 // [num_remote] value of each remote entry
  Array<int> sent = Array<int>("contact::sent_entries", 0);                   // [num_sent] row * row_nodes + slot
  Rows3<double> correction = Rows3<double>("contact::correction", 0);         // dv of the iterate
  Rows3<double> abs_sum = Rows3<double>("contact::abs_sum", 0);               // S
  Array<int> wants = Array<int>("contact::wanting_rows", 0);                  // [rows] wants_something() at the start
  RowPacks packs;                                                             // what the iteration works on
  Array<TurningRow> turning = Array<TurningRow>("contact::turning_rows", 0);  // [ties] by ContactRow::record
  RowBodies bodies;                                                           // rigid ones
  // The history records of faces and walls that the last write_history() wrote; all others are empty (of a face: its
  // number is -1). -1: not known.
  int num_written = -1;
  Array<int> written = Array<int>("contact::written_records", 0);
  // Scratch of the set-up.
  Array<int> near_walls = Array<int>("contact::near_walls", 0);        // wall pairs in reach
  Array<int> place_of_node = Array<int>("contact::place_of_node", 0);  // [mesh nodes] -1 outside set-up
  // [rows * row_nodes + num_remote] of its node; num_places(): a slot not in use
  Array<int> place_of_entry = Array<int>("contact::place_of_entry", 0);
  Array<int> entry_value = Array<int>("contact::entry_value", 0);
  Array<int> count = Array<int>("contact::entry_count", 0);
  Array<int> first_entry = Array<int>("contact::first_entry", 0);  // [num_nodes] of each node

  int num_places() const { return num_nodes + num_foreign; }
};

/// The first three columns of the sum of rows first to last - 1 of four doubles, in this order. Rows are aligned to
/// four doubles.
PERCUSS_FORCE_INLINE Point3 sum_rows_of_four(const double* rows, int first, int last) {
#ifdef PERCUSS_HAS_SIMD
  detail::RowOfFour sum{};
  for (int i = first; i < last; ++i) sum += *reinterpret_cast<const detail::RowOfFour*>(rows + 4 * std::ptrdiff_t{i});
#else
  double sum[3] = {0, 0, 0};
  for (int i = first; i < last; ++i)
    for (int k = 0; k < 3; ++k) sum[k] += rows[4 * std::ptrdiff_t{i} + k];
#endif
  return {sum[0], sum[1], sum[2]};
}

/// Sums of what the entries of a node add to it, in the order of their rows' keys.
struct ShareSums {
  Array<const int> offset;
  Rows4<const double> shares;

  explicit ShareSums(const RowSystem& system) : offset(system.offset), shares(system.shares) {}

  KOKKOS_INLINE_FUNCTION Point3 operator()(int a) const {
    return sum_rows_of_four(shares.data(), offset(a), offset(a + 1));
  }
};

/// Velocity of the nodes of a row in data by place.
struct TouchedVelocity {
  Rows3<const double> v;
  const ContactRow& row;
  KOKKOS_INLINE_FUNCTION Point3 operator()(int slot) const { return load_row(v, row.place[slot]); }
};

/// The touches of a check made on the nodes of this rank alone, as rows need them, by (node, face).
/// face_numbers: [contact faces]; node_numbers: [contact nodes]; touches: out.
void collect_touches(const WorkSpace& space, const ContactSurface& surface, const CandidateList& candidates,
                     const TouchTable& table, const SurfaceNumbers& numbers, Array<RowTouch>& touches);

/// Counts the rows: RowSystem::num_rows.
void count_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources, RowSystem& system);

/// First part of the set-up, of rows that are counted: numbers the nodes of this rank that rows of any rank touch and
/// gathers their data. In: num_foreign and remote_node of the system. Foreign places are to be filled then.
void start_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources, RowSystem& system);

/// Makes the rows from touches and walls with their first guess from history, and the entries of all places;
/// RowSystem::wants but for rows that nothing can move. In: RowSystem::at of all places, num_remote, remote_place,
/// remote_key.
void make_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources,
               const ContactHistory& history, RowSystem& system);

/// Impulse of each entry: RowSystem::shares.
void share_impulses(const WorkSpace& space, const RowSystem& system);

/// Shares of the entries that other ranks want. values: out, [num_sent][3].
void get_sent_shares(const WorkSpace& space, const RowSystem& system, const Rows3<double>& values);

/// Puts what other ranks' rows add, RowSystem::remote, among the shares.
void place_remote_shares(const WorkSpace& space, const RowSystem& system);

/// S of all places: sums of absolute coefficients in the order of keys. In: shares, remote.
void sum_coefficients(const WorkSpace& space, RowSystem& system);

}  // namespace percuss
