#pragma once
// The element part of a step on a device: a team of threads a chunk, a thread an element.
//
// Records and corners of `Stored` elements lie side by side, one element a lane: neighbouring threads read neighbouring
// words. The team works through its chunk in rounds. After a round a thread a slot adds up the corner forces of the
// round, in the order of elements and of their corners. The sums have the bits of those that the launcher of packs
// makes (chunk_launcher.hpp). Runs on hosts too, where a test compares both.
//
// Not served: chunks that rest are not skipped. Elements neither fail nor resist folding, and nothing reads their
// step.

#include <bit>
#include <cstdint>

#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/hex8/modes.hpp"
#include "kernels/element/internal_force.hpp"

namespace percuss {

/// Elements whose numbers lie side by side on a device: a warp.
inline constexpr int device_lanes = 32;

/// Elements that a team takes at a time, and teams that share a multiprocessor: as many as leave a thread registers for
/// an element.
inline constexpr int round_elements = 128, teams_at_once = 2;

/// What a slot adds up after a round of its chunk.
struct SlotSum {
  static constexpr int continues = 0x8000;
  std::uint16_t slot;  // of the chunk; with `continues` if an earlier round has begun its sum
  std::uint16_t end;   // of its corners in the chunk's list, which begin where those of the sum before it end
};

/// The corners that add to the slots of each chunk: round by round, slot by slot, in the order of elements and of their
/// corners; const after set-up. Each slot has one.
struct SlotCorners {
  Array<int> first_round;  // [chunks + 1] of round_elements elements
  Array<int> first_sum;    // [rounds + 1]
  Array<SlotSum> sums;     // by round
  Array<std::uint16_t>
      corners;  // [8 elements] by chunk: 8 element + corner, the element counted from the chunk's first
};

template <int Stored, class Material, HexKind Kind>
class AdvanceByThreads {
 public:
  using Policy = Kokkos::TeamPolicy<ExecSpace, Kokkos::LaunchBounds<round_elements, teams_at_once>>;
  using Member = typename Policy::member_type;

  ElementChunks chunks;
  SlotCorners slot_corners;
  HexBlock<Material, Kind> block;
  ElementMotion motion;
  ChunkFields fields;

  KOKKOS_FUNCTION void operator()(const Member& member) const {
    const int c = block.chunks(member.league_rank());
    const Span elements{chunks.first_element(c), chunks.first_element(c + 1)};
    auto* const forces =
        static_cast<double*>(member.team_scratch(0).get_shmem_aligned(std::size_t{scratch_bytes}, sizeof(double)));
    const Span rounds{slot_corners.first_round(c), slot_corners.first_round(c + 1)};
    Sums sums;
    for (int r = 0; r < rounds.count(); ++r) {
      const int begin = r * round_elements, rest = elements.count() - begin;
      for (int i = member.team_rank(); i < rest && i < round_elements; i += member.team_size())
        advance_element(c, begin + i, forces + i, sums);
      member.team_barrier();
      const int end = slot_corners.first_sum(rounds.begin + r + 1), first = slot_corners.first_sum(rounds.begin);
      for (int i = slot_corners.first_sum(rounds.begin + r) + member.team_rank(); i < end; i += member.team_size())
        add_corners(c, slot_corners.sums(i), i > first ? slot_corners.sums(i - 1).end : 0, begin, forces);
      member.team_barrier();
    }
    leave(member, c, elements, sums);
  }

  static Policy make_policy(const ExecSpace& space, int count) {
    constexpr bool is_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, ExecSpace::memory_space>::accessible;
    Policy policy(space, count, is_host ? 1 : round_elements);
    policy.set_scratch_size(0, Kokkos::PerTeam(static_cast<int>(scratch_bytes + sizeof(double))));
    return policy;
  }

 private:
  static constexpr std::size_t scratch_bytes = 24 * round_elements * sizeof(double);  // forces [3][8][round_elements]
  using State = HexState<Real, Material, Kind>;
  static constexpr int record_size = hex_record_size<Material, Kind>;
  static_assert(sizeof(State) == record_size * sizeof(Real), "the members lie like the scalars of a record");

  struct Span {
    int begin, end;
    KOKKOS_FUNCTION int count() const { return end - begin; }
  };

  /// Sums over the elements of a thread.
  struct Sums {
    double step = 1e300;
    int controlling = -1, failed = -1;  // counted from the chunk's first element
    double work[3] = {0, 0, 0};

    KOKKOS_FUNCTION void take(const HexResult<Real>& result, int element) {
      if (result.stable_step < step) {
        step = result.stable_step;
        controlling = element;
      }
      if (failed < 0 && !(result.size > 0 && result.stable_step > 0)) failed = element;  // also for NaN
      work[0] += static_cast<double>(result.work.internal);
      work[1] += static_cast<double>(result.work.hourglass);
      work[2] += static_cast<double>(result.work.viscous);
    }
  };

  struct Record {
    Real numbers[record_size];
  };

  KOKKOS_FUNCTION Real* find_record(int c, int element) const {
    const auto pack = static_cast<std::size_t>(element / Stored) * record_size * Stored;
    return &fields.state(chunks.first_state(c) + pack + static_cast<std::size_t>(element % Stored));
  }

  /// forces: out, those of corner i in direction k at (8 k + i) round_elements.
  KOKKOS_FUNCTION void advance_element(int c, int element, double* forces, Sums& sums) const {
    Real* const place = find_record(c, element);
    Record record;
    for (int i = 0; i < record_size; ++i) record.numbers[i] = place[static_cast<std::size_t>(i * Stored)];
    auto state = std::bit_cast<State>(record);
    Real x[3][8], v[3][8];
    gather(c, element, motion.x, x);
    gather(c, element, motion.v, v);
    SolidParameters<Material> parameters = block.parameters(chunks.parameters(c));
    parameters.time = motion.time;
    Real f[3][8];
    const HexResult<Real> result = advance_hex8(parameters, find_field_modes(x), find_field_modes(v),
                                                static_cast<Real>(motion.dt), state, {f[0], f[1], f[2]});
    record = std::bit_cast<Record>(state);
    for (int i = 0; i < record_size; ++i) place[static_cast<std::size_t>(i * Stored)] = record.numbers[i];
    for (int k = 0; k < 3; ++k) {
      double corner[8];
      for (int i = 0; i < 8; ++i) corner[i] = static_cast<double>(f[k][i]);
      if constexpr (is_single_precision) to_corners(corner);
      for (int i = 0; i < 8; ++i) forces[(8 * k + i) * round_elements] = corner[i];
    }
    sums.take(result, element);
  }

  /// Rows of an element's nodes; in single precision relative to a node of the chunk, as fill_row() has it.
  KOKKOS_FUNCTION void gather(int c, int element, const Rows3<const double>& rows, Real (&u)[3][8]) const {
    const int first = chunks.first_slot(c), middle = first + (chunks.first_slot(c + 1) - first) / 2;
    const double* const origin = &rows(chunks.slots_to_nodes(middle), 0);
    const auto pack = static_cast<std::size_t>(chunks.first_pack(c) + element / Stored);
    const std::uint16_t* const corners =
        &chunks.corner_slots(pack * 8 * Stored + static_cast<std::size_t>(element % Stored));
    for (int i = 0; i < 8; ++i) {
      const double* const row = &rows(chunks.slots_to_nodes(first + corners[i * Stored]), 0);
      for (int k = 0; k < 3; ++k) u[k][i] = static_cast<Real>(is_single_precision ? row[k] - origin[k] : row[k]);
    }
  }

  static KOKKOS_FUNCTION VectorModes<Real> find_field_modes(Real (&u)[3][8]) {
    VectorModes<Real> modes;
    for (int k = 0; k < 3; ++k) to_modes(u[k]);
    for (int m = 1; m < 8; ++m) modes[m] = {u[0][m], u[1][m], u[2][m]};
    return modes;
  }

  /// Subtracts the forces of corners [begin, sum.end) from their slot. first: element of the round's first force.
  KOKKOS_FUNCTION void add_corners(int c, const SlotSum& sum, int begin, int first, const double* forces) const {
    const std::uint16_t* const corners = &slot_corners.corners(8 * static_cast<std::size_t>(chunks.first_element(c)));
    double* const to = &fields.slot_force(chunks.first_slot(c) + sum.slot % SlotSum::continues, 0);
    double total[3] = {0, 0, 0};
    if (sum.slot >= SlotSum::continues)
      for (int k = 0; k < 3; ++k) total[k] = to[k];
    for (int at = begin; at < sum.end; ++at) {
      const int corner = corners[at] % 8, element = corners[at] / 8 - first;
      for (int k = 0; k < 3; ++k) total[k] -= forces[(8 * k + corner) * round_elements + element];
    }
    for (int k = 0; k < 3; ++k) to[k] = total[k];
  }

  /// The sums of all threads; each order is fixed. Equal steps are those of the lowest element.
  KOKKOS_FUNCTION void leave(const Member& member, int c, const Span& elements, Sums sums) const {
    const double own = sums.step;
    double least = own;
    member.team_reduce(Kokkos::Min<double>(least));
    int controlling = sums.controlling >= 0 && own == least ? sums.controlling : elements.count();
    member.team_reduce(Kokkos::Min<int>(controlling));
    int failed = sums.failed >= 0 ? sums.failed : elements.count();
    member.team_reduce(Kokkos::Min<int>(failed));
    for (double& work : sums.work) member.team_reduce(Kokkos::Sum<double>(work));
    if (member.team_rank() != 0) return;
    const ChunkResults& results = fields.results;
    results.stable_step(c) = least;
    results.controlling_element(c) = elements.begin + (controlling < elements.count() ? controlling : 0);
    results.failed_element(c) = failed < elements.count() ? elements.begin + failed : -1;
    results.is_settled(c) = 0;
    for (int k = 0; k < 3; ++k) results.work(c, k) += sums.work[k];
  }
};

/// As advance_block(), for chunks stored for threads: records and corners of `Stored` elements side by side, first_pack
/// counting these. fields.slot_force: out; each slot.
template <int Stored, class Material, HexKind Kind>
void advance_by_threads(const ExecSpace& space, const ElementChunks& chunks, const SlotCorners& slot_corners,
                        const HexBlock<Material, Kind>& block, const ElementMotion& motion, const ChunkFields& fields) {
  const int count = static_cast<int>(block.chunks.extent(0));
  if (count == 0) return;
  using Kernel = AdvanceByThreads<Stored, Material, Kind>;
  Kokkos::parallel_for("percuss::advance_by_threads", Kernel::make_policy(space, count),
                       Kernel{chunks, slot_corners, block, motion, fields});
}

}  // namespace percuss
