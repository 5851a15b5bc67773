#pragma once
// Boxes along the axes, and the box of a face over a step.

#include "kernels/contact/geometry/face_geometry.hpp"

namespace percuss {

/// Boxes [n][6]: lowest x, y, z, highest x, y, z; both ends belong to the box.
using Boxes = Kokkos::View<double* [6], Kokkos::LayoutRight, MemSpace>;

/// One box.
template <class T>
struct BoxOf {
  Vector3<T> low, high;
};

/// Box over a step of a face with corners at `x` and predicted velocities `v`, at n and at its predicted place, widened
/// by `reach`.
template <class T>
PERCUSS_FORCE_INLINE BoxOf<T> bound_corners(const FaceOf<T>& x, const FaceOf<T>& v, const T& dt, const T& reach) {
  BoxOf<T> box{};
  const auto add = [&](bool is_first, const T& known, const T& move, T& low, T& high) {
    const auto is_back = move < T(0);
    const T before = select(is_back, known + move, known), after = select(is_back, known, known + move);
    low = is_first ? before : smaller(low, before);
    high = is_first ? after : larger(high, after);
  };
  for (int i = 0; i < 4; ++i) {
    const Vector3<T>&at = x.corner[i], move = dt * v.corner[i];
    add(i == 0, at.x, move.x, box.low.x, box.high.x);
    add(i == 0, at.y, move.y, box.low.y, box.high.y);
    add(i == 0, at.z, move.z, box.low.z, box.high.z);
  }
  const Vector3<T> wider{reach, reach, reach};
  return {box.low - wider, box.high + wider};
}

}  // namespace percuss
