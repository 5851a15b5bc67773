#pragma once
// What a shortening at rest does to the record of an element: stresses grow, the places of nodes stay. Each function
// returns the energy that this takes. Internal to preload_stage.cpp.

#include "kernels/beam/beam_force.hpp"
#include "kernels/core/common_record.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/shell/shell_record.hpp"
#include "kernels/shell/thickness_points.hpp"

namespace percuss {

/// Strain and stress by which the records of a layer are shortened.
struct Shortening {
  // xx, yy, zz, xy, yz, zx of n n, and of the stress of a strain of 1 along n
  Kokkos::Array<double, 6> dyad, stress;
  double modulus;                    // lambda + 2 mu
  double plane_lambda, shear_twice;  // of plane stress: s = plane_lambda tr(e) 1 + shear_twice e
  bool is_kirchhoff;                 // the law has the rate of J sigma
  double strain;
};

/// J = det V of a record.
KOKKOS_INLINE_FUNCTION double find_volume_ratio(const ElementRecord& record) {
  double c[6];
  for (int k = 0; k < 6; ++k) c[k] = record.get(SolidRecord::stretch + k);
  return c[0] * (c[1] * c[2] - c[4] * c[4]) - c[3] * (c[3] * c[2] - c[4] * c[5]) + c[5] * (c[3] * c[4] - c[1] * c[5]);
}

/// A solid, by a strain along the normal. The energy is per volume at time 0.
KOKKOS_INLINE_FUNCTION double shorten_solid(const LaneRecord<Real>& record, int points, const Shortening& by) {
  const double j = find_volume_ratio(record), share = by.is_kirchhoff ? 1 / j : 1;
  double energy = 0;
  for (int p = 0; p < points; ++p) {
    const LaneRecord<Real> s = record.from(SolidRecord::stress + 6 * p);
    double along = 0;  // n . s n
    for (int k = 0; k < 6; ++k) along += (k < 3 ? 1 : 2) * by.dyad[k] * s.get(k);
    energy += by.strain * (along + 0.5 * share * by.strain * by.modulus);
    for (int k = 0; k < 6; ++k) s[k] += static_cast<Real>(share * by.strain * by.stress[k]);
  }
  return j * energy / points;
}

/// A beam or truss, by a strain along its axis. The energy is per length.
KOKKOS_INLINE_FUNCTION double shorten_beam(const LaneRecord<Real>& record, const BeamParameters& parameters,
                                           double strain) {
  Real& normal = record[BeamRecord::forces];
  const double more = parameters.stiffness.axial * strain, before = static_cast<double>(normal);
  for (int i = 0; i < parameters.fibres.count; ++i)
    record[BeamRecord::fibres + 2 * i] += static_cast<Real>(parameters.law.youngs_modulus * strain);
  normal += static_cast<Real>(more);
  return strain * (before + 0.5 * more);
}

/// The layers of a shell. n: of the normal in the frame of the element. The energy is per volume.
KOKKOS_INLINE_FUNCTION double shorten_shell(const LaneRecord<Real>& record, const ThicknessPoints& rule, int layer_size,
                                            const double (&n)[2], const Shortening& by) {
  const double strain[3] = {by.strain * n[0] * n[0], by.strain * n[1] * n[1], 2 * by.strain * n[0] * n[1]};
  const double pressure = by.plane_lambda * (strain[0] + strain[1]);
  const double more[3] = {pressure + by.shear_twice * strain[0], pressure + by.shear_twice * strain[1],
                          0.5 * by.shear_twice * strain[2]};
  double energy = 0;
  for (int p = 0; p < rule.count; ++p) {
    const LaneRecord<Real> s = record.from(ShellRecord::layers + layer_size * p);
    for (int k = 0; k < 3; ++k) {
      energy += rule.weight[p] * strain[k] * (s.get(k) + 0.5 * more[k]);
      s[k] += static_cast<Real>(more[k]);
    }
  }
  return energy;
}

}  // namespace percuss
