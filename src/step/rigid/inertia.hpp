#pragma once
// Inertia of masses from their second moments J = sum m r r^T, and back.

#include <array>

#include "kernels/core/tensor.hpp"

namespace percuss {

/// tr(J) 1 - J.
inline Symmetric3<double> to_inertia(const Symmetric3<double>& j) {
  return {j.yy + j.zz, j.zz + j.xx, j.xx + j.yy, -j.xy, -j.yz, -j.zx};
}

/// tr(I) / 2 1 - I; of xx, yy, zz, xy, yz, zx.
inline Symmetric3<double> to_second_moments(const std::array<double, 6>& i) {
  const double half = 0.5 * (i[0] + i[1] + i[2]);
  return {half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]};
}

/// Inertia of second moments. Masses on a line get a share of the inertia across it about it as well: forces on them
/// have no moment about their line, so that none of their motion depends on it, and the inertia has an inverse.
inline Symmetric3<double> to_inertia_of_line(const Symmetric3<double>& j) {
  constexpr int iterations = 20;
  constexpr double narrow = 1e-6, share = 1e-3;  // of the sum of the second moments
  const double size = trace(j);
  const Vector3<double> columns[3] = {{j.xx, j.xy, j.zx}, {j.xy, j.yy, j.yz}, {j.zx, j.yz, j.zz}};
  Vector3<double> along = columns[j.xx >= j.yy && j.xx >= j.zz ? 0 : (j.yy >= j.zz ? 1 : 2)];
  if (!(size > 0) || !(norm(along) > 0)) return to_inertia(j);
  along = (1 / norm(along)) * along;
  for (int i = 0; i < iterations; ++i) along = (1 / norm(j * along)) * (j * along);  // to the largest of its values
  Symmetric3<double> inertia = to_inertia(j);
  if (size - dot(along, j * along) > narrow * size) return inertia;
  const Vector3<double>& a = along;
  return inertia +
         (share * size) * Symmetric3<double>{a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.y * a.z, a.z * a.x};
}

}  // namespace percuss
