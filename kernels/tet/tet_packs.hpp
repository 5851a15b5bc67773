#pragma once
// What the launchers of tetrahedra share: a chunk's nodes in scratch, packs of elements from them, and what packs
// leave.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include "kernels/element/chunk_records.hpp"
#include "kernels/element/living_lanes.hpp"
#include "kernels/tet/tet_chunks.hpp"

namespace percuss {

inline constexpr int tet_width = pack_size<double>;
using TetScratch = ChunkScratch<node_record, force_record>;

/// A vector of the pack's corners, from rows of so many numbers, at least four.
PERCUSS_FORCE_INLINE void gather_tets(const double* rows, int row_size, const std::uint16_t* corners,
                                      TetCorners<Lanes>& u) {
  for (int i = 0; i < 4; ++i) {
    const double* records[tet_width];
    for (int lane = 0; lane < tet_width; ++lane)
      records[lane] = rows + static_cast<std::size_t>(row_size) * corners[i * tet_width + lane];
    Lanes packs[3];
    transpose_to_packs(records, packs);
    u[i] = {packs[0], packs[1], packs[2]};
  }
}

/// Subtracts the forces of the first `lanes` elements from the chunk's records, element by element.
PERCUSS_FORCE_INLINE void scatter_tets(const TetCorners<Lanes>& f, const std::uint16_t* corners, int lanes,
                                       double* forces) {
  alignas(64) double records[4][tet_width][4];
  for (int i = 0; i < 4; ++i) {
    const Lanes packs[3] = {f[i].x, f[i].y, f[i].z};
    transpose_to_records(packs, records[i]);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (int i = 0; i < 4; ++i)
      subtract_record(records[i][lane],
                      forces + force_record * static_cast<std::size_t>(corners[i * tet_width + lane]));
  }
}

/// to[0..4) += from[0..4), both aligned to four doubles.
PERCUSS_FORCE_INLINE void add_record(const double* from, double* to) {
#ifdef PERCUSS_HAS_SIMD
  using Raw = detail::RawPack<4>::type;
  *reinterpret_cast<Raw*>(to) += *reinterpret_cast<const Raw*>(from);
#else
  for (int k = 0; k < 4; ++k) to[k] += from[k];
#endif
}

/// Groups of three numbers of a pack's elements, by lane: records[lane][group].
template <int Groups>
struct TetGroups {
  alignas(64) double record[Groups][tet_width][4];

  PERCUSS_FORCE_INLINE void set(int group, const Lanes& a, const Lanes& b, const Lanes& c) {
    const Lanes packs[3] = {a, b, c};
    transpose_to_records(packs, record[group]);
  }

  /// Adds them to the row of a corner.
  PERCUSS_FORCE_INLINE void add(int lane, double* row) const {
    for (int g = 0; g < Groups; ++g) add_record(record[g][lane], row + 4 * g);
  }
};

/// Averages at the corners, one group of three: rows[corner].
struct TetGather {
  const double* rows;
  int row_size;
  const int* slots_to_records;

  PERCUSS_FORCE_INLINE Vector3<Lanes> operator()(int corner, int group, const std::uint16_t* corners) const {
    const double* records[tet_width];
    for (int lane = 0; lane < tet_width; ++lane) {
      const int record = slots_to_records[corners[corner * tet_width + lane]];
      records[lane] = rows + static_cast<std::size_t>(row_size) * static_cast<std::size_t>(record) + 4 * group;
    }
    Lanes packs[3];
    transpose_to_packs(records, packs);
    return {packs[0], packs[1], packs[2]};
  }

  /// Mean over the corners of a tensor in groups 0 and 1.
  PERCUSS_FORCE_INLINE Symmetric3<Lanes> find_mean(const std::uint16_t* corners) const {
    const Lanes zero(0.0), quarter(0.25);
    Vector3<Lanes> low{zero, zero, zero}, high{zero, zero, zero};
    for (int i = 0; i < 4; ++i) {
      low = low + (*this)(i, 0, corners);
      high = high + (*this)(i, 1, corners);
    }
    return quarter * Symmetric3<Lanes>{low.x, low.y, low.z, high.x, high.y, high.z};
  }
};

/// The chunk of a team.
struct TetChunk {
  const HexChunks& chunks;
  int c, first_slot, slot_count, first_element, end_element;

  KOKKOS_FUNCTION TetChunk(const HexChunks& of, int chunk)
      : chunks(of),
        c(chunk),
        first_slot(of.first_slot(chunk)),
        slot_count(of.first_slot(chunk + 1) - first_slot),
        first_element(of.first_element(chunk)),
        end_element(of.first_element(chunk + 1)) {}

  /// Places and velocities of its nodes into node records.
  KOKKOS_FUNCTION void fill_nodes(const ElementMotion& motion, double* nodes) const {
    const int* const slots_to_nodes = &chunks.slots_to_nodes(first_slot);
    for (int s = 0; s < slot_count; ++s) {
      const std::size_t n = 3 * static_cast<std::size_t>(slots_to_nodes[s]);
      copy_row(motion.x.data() + n, nodes + node_record * s);
      copy_row(motion.v.data() + n, nodes + node_record * s + 4);
    }
  }

  KOKKOS_FUNCTION const std::uint16_t* find_corners() const {
    return &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * 8 * tet_width);
  }

  /// Calls visit(i, lanes, corners) for each pack i with so many elements.
  template <class Visit>
  KOKKOS_FUNCTION void for_each_pack(const Visit& visit) const {
    const std::uint16_t* corners = find_corners();
    for (int e = first_element, i = 0; e < end_element; e += tet_width, ++i, corners += 8 * tet_width)
      visit(i, end_element - e < tet_width ? end_element - e : tet_width, corners);
  }
};

/// Active lanes of a chunk of tetrahedra, pass by pass (LivingLanes). A template for its users: where solids are in
/// single precision its packs are not theirs, and none of them is compiled.
template <class>
class LivingTets : public LivingLanes {
 public:
  KOKKOS_FUNCTION LivingTets(const FailingChunks& failing, const ElementLives& lives, int chunk)
      : LivingLanes(failing, lives, chunk),
        shares_(&lives.force_share),
        first_((failing.find_pack(chunk) - 1) * width) {}

  KOKKOS_FUNCTION bool take_pack(const std::uint16_t*& corners) {
    first_ += width;
    return LivingLanes::take_pack(corners);
  }

  /// Shares of its force that each lane leaves at this evaluation, as far as the last one says; negative: eroded.
  KOKKOS_FUNCTION Lanes load_force_share() const { return load_pack(&(*shares_)(static_cast<std::size_t>(first_))); }

  using LivingLanes::take_force_share;
  using LivingLanes::take_work;

 private:
  const Array<Real>* shares_;
  int first_;  // lane of the pack
};

/// What the elements of a chunk add up to, taken lane by lane in their order.
struct TetChunkSums {
  double step = 1e300;
  int controlling = -1, failed = -1;
  double work[work_kinds] = {0, 0, 0, 0};

  PERCUSS_FORCE_INLINE void take_work(const TetWork<Lanes>& of, int lanes) {
    work[0] += sum_first(of.internal, lanes);
    work[2] += sum_first(of.viscous, lanes);
    work[3] += sum_first(of.guard, lanes);
  }

  PERCUSS_FORCE_INLINE void take_step(const Lanes& stable_step, const Lanes& volume, int first_element, int lanes) {
    alignas(64) double steps[tet_width], volumes[tet_width];
    store_pack(steps, stable_step);
    store_pack(volumes, volume);
    for (int lane = 0; lane < lanes; ++lane) {
      if (steps[lane] < step) {
        step = steps[lane];
        controlling = first_element + lane;
      }
      if (failed < 0 && !(volumes[lane] > 0 && steps[lane] > 0)) failed = first_element + lane;  // also for NaN
    }
  }

  KOKKOS_FUNCTION void leave_work(int c, const ChunkResults& results) const {
    for (int k = 0; k < work_kinds; ++k) results.work(c, k) += work[k];
  }

  KOKKOS_FUNCTION void leave_step(int c, int first_element, const ChunkResults& results) const {
    results.stable_step(c) = step;
    results.controlling_element(c) = controlling < 0 ? first_element : controlling;
    results.failed_element(c) = failed;
    results.is_settled(c) = 0;
  }

  static PERCUSS_FORCE_INLINE double sum_first(const Lanes& value, int lanes) {
    alignas(64) double row[tet_width];
    store_pack(row, value);
    double sum = 0;
    for (int lane = 0; lane < lanes; ++lane) sum += row[lane];
    return sum;
  }
};

/// Launches a kernel over chunks, a team each.
template <class Kernel>
void launch_tets(const char* label, const ExecSpace& space, const HexChunks& chunks, const Array<int>& list,
                 const Kernel& kernel) {
  const int count = static_cast<int>(list.extent(0));
  if (count == 0 || is_single_precision) return;
  Kokkos::parallel_for(label, TetScratch::make_policy(space, count, chunks.largest_slot_count), kernel);
}

}  // namespace percuss
