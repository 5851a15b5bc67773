#pragma once
// Forces of contact between sides that a deck names: the impulses of the rows of a step, added up by pair of sides.

#include <cstdint>

#include "kernels/contact/rows/row_system.hpp"
#include "kernels/contact/surface/node_areas.hpp"

namespace percuss {

/// Impulse and moment on one side from the other in a step.
struct ForceSums {
  ExactSum impulse[3], moment[3];  // on the first side [force x time], and its moment
  ExactSum normal, tangential;     // magnitudes of the rows' pushes and of their friction; ties have neither

  KOKKOS_INLINE_FUNCTION void merge(const ForceSums& other) {
    for (int k = 0; k < 3; ++k) {
      impulse[k].merge(other.impulse[k]);
      moment[k].merge(other.moment[k]);
    }
    normal.merge(other.normal);
    tangential.merge(other.tangential);
  }
};

/// The sides of each force: bit f of a word says that nodes of a chunk, or a wall, belong to that side of force f.
struct ForceSides {
  Array<const std::int64_t> first_node;  // [chunks + 1] of the whole mesh: Numbering::first_node
  Array<const std::uint32_t> one;        // [chunks] the side that the force acts on
  Array<const std::uint32_t> other;      // [chunks] the side that it comes from
  Array<const std::uint32_t> walls;      // [walls] likewise
  std::uint32_t from_all = 0;            // forces that come from all that is not of their first side
};

/// Sides to which a face or an edge belongs by the surface that it lies on: bit f.
struct SideBits {
  std::uint32_t one = 0, other = 0;
};

/// Sides of the pushed and of the pushing side of a row.
struct RowSurfaces {
  SideBits pushed, pushing;
};

/// Forces to which a row adds: bit f. Forward: its pushed point is of the first side.
struct RowSides {
  std::uint32_t forward = 0, backward = 0;
};

/// The sides as chunks have them, and as rows have them.
struct GivenSides {
  const ForceSides& chunks;
  Array<const RowSurfaces> rows;  // [rows]; empty: no force names a surface
};

/// marks: out, [rows]. node_numbers: [mesh nodes].
void mark_rows(const WorkSpace& space, const GivenSides& sides, const Array<const std::int64_t>& node_numbers,
               const RowSystem& system, Array<RowSides>& marks);

/// Force f of this rank's rows, after they are solved; moments about `about`, with the places at n.
ForceSums sum_contact_force(const WorkSpace& space, int f, const Point3& about, const RowSystem& system,
                            const Array<const RowSides>& marks, Array<ForceSums>& partial);

/// Push of a row along its normal on one of its nodes, and the forces that it counts for: bit f.
struct NormalPush {
  Point3 impulse{};  // [force x time]
  std::uint32_t forces = 0;
};

/// Pushes on the nodes of each force's first side since they were cleared. The nodes that a rank owns stand force after
/// force, chunk after chunk, in the order of their numbers.
struct PushBooks {
  int forces = 0;
  Array<const int>
      first;           // [chunks * forces] place of the chunk's first node; -1: not of that side, or not of this rank
  Rows4<double> sums;  // [places] impulse along the normals of the rows [force x time], and the time with a push

  /// Place of a node by its number; -1: it has none.
  KOKKOS_INLINE_FUNCTION int find_place(const ForceSides& sides, int chunk, std::int64_t number, int force) const {
    const int start = first(chunk * forces + force);
    return start < 0 ? -1 : start + static_cast<int>(number - sides.first_node(chunk));
  }
};

/// Rows of a step, who their pushes count for, and the pushes of remote entries.
struct MarkedRows {
  const RowSystem& system;
  Array<const RowSides> marks;     // [rows]
  Array<const NormalPush> remote;  // [RowSystem::num_remote]
};

/// Marks the rows that push for force 0, on both sides.
void mark_pushes(const WorkSpace& space, const RowSystem& system, Array<RowSides>& marks);

/// Pushes of the entries that other ranks want: [RowSystem::num_sent].
void list_sent_pushes(const WorkSpace& space, const RowSystem& system, const Array<const RowSides>& marks,
                      Array<NormalPush>& sent);

/// Adds a step to the books. time: its length. node_numbers: [mesh nodes].
void book_pushes(const WorkSpace& space, const MarkedRows& rows, const ForceSides& sides,
                 const Array<const std::int64_t>& node_numbers, double time, const PushBooks& books);

/// Contact nodes that this rank owns, with their areas at some positions.
struct AreaNodes {
  Array<const std::int64_t> numbers;  // [nodes] in the whole mesh, ascending
  NodeFaces around;
};

/// Area and largest pressure on a force's first side since its sums were cleared.
struct AreaSums {
  ExactSum area;     // of each node for the time in which it was pushed [area x time]
  double press = 0;  // largest impulse of a node over its area [stress x time]

  KOKKOS_INLINE_FUNCTION void merge(const AreaSums& other) {
    area.merge(other.area);
    press = other.press > press ? other.press : press;
  }
};

AreaSums sum_areas(const WorkSpace& space, int f, const AreaNodes& nodes, const ForceSides& sides,
                   const PushBooks& books, Array<AreaSums>& partial);

/// The pushes that count for force 0 on each owned node that rows touch; others stay. sums: in and out, [mesh nodes].
void sum_pushes(const WorkSpace& space, const MarkedRows& rows, const Rows3<double>& sums);

}  // namespace percuss
