#pragma once
// What the launchers of tetrahedra share: groups of numbers that packs of elements give to nodes and take from them.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include "kernels/element/solid_packs.hpp"
#include "kernels/tet/tet_chunks.hpp"

namespace percuss {

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
  alignas(64) double record[Groups][solid_width][4];

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
    const double* records[solid_width];
    for (int lane = 0; lane < solid_width; ++lane) {
      const int record = slots_to_records[corners[corner * solid_width + lane]];
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

}  // namespace percuss
