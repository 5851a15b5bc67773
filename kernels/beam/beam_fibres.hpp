#pragma once
// Fibres of a cross section: points with a normal stress of their own, and weights.
//
// Fibres of rectangles, boxes and I shapes are Gauss points of each half, so that the elastic and the fully plastic
// moments about both axes are exact. Around round sections the latter is within 1.3 %.

#include <cmath>
#include <numbers>

#include "kernels/beam/beam2.hpp"

namespace percuss {

struct BeamFibre {
  double y = 0, z = 0, area = 0;
};

inline constexpr int most_beam_fibres = 48;

struct BeamFibres {
  int count = 0;
  BeamFibre fibre[most_beam_fibres];

  void add(double y, double z, double area) { fibre[count++] = {y, z, area}; }
};

/// Points and weights of Gauss on an interval from 0 to 1.
template <int N>
struct UnitGauss;
template <>
struct UnitGauss<2> {
  static constexpr double place[2] = {0.21132486540518712, 0.78867513459481288}, weight[2] = {0.5, 0.5};
};
template <>
struct UnitGauss<3> {
  static constexpr double place[3] = {0.1127016653792583, 0.5, 0.8872983346207417},
                          weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
};

/// Visits the points of an interval around 0, N in each half. visit(place, length of a point's share).
template <int N, class Visit>
void visit_halves(double width, const Visit& visit) {
  for (int i = 0; i < N; ++i) {
    for (const double side : {-0.5, 0.5})
      visit(side * width * UnitGauss<N>::place[i], 0.5 * width * UnitGauss<N>::weight[i]);
  }
}

inline BeamFibres list_rectangle_fibres(double width_y, double width_z) {
  BeamFibres fibres;
  visit_halves<3>(width_y, [&](double y, double dy) {
    visit_halves<3>(width_z, [&](double z, double dz) { fibres.add(y, z, dy * dz); });
  });
  return fibres;
}

/// Two walls over the whole width along z, and two between them.
inline BeamFibres list_box_fibres(double width_y, double width_z, double wall) {
  using Across = UnitGauss<2>;
  BeamFibres fibres;
  for (int i = 0; i < 2; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double y = side * (0.5 * width_y - wall * Across::place[i]),
                   z = side * (0.5 * width_z - wall * Across::place[i]), thickness = wall * Across::weight[i];
      visit_halves<2>(width_z, [&](double along, double length) { fibres.add(y, along, thickness * length); });
      visit_halves<2>(width_y - 2 * wall,
                      [&](double along, double length) { fibres.add(along, z, thickness * length); });
    }
  }
  return fibres;
}

/// Two flanges over the width along y, and a web between them.
inline BeamFibres list_i_shape_fibres(double width, double depth, double flange, double web) {
  using Across = UnitGauss<2>;
  BeamFibres fibres;
  for (int i = 0; i < 2; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double z = side * (0.5 * depth - flange * Across::place[i]);
      visit_halves<2>(width, [&](double y, double length) { fibres.add(y, z, flange * Across::weight[i] * length); });
    }
    const double y = web * (Across::place[i] - 0.5);
    visit_halves<3>(depth - 2 * flange,
                    [&](double z, double length) { fibres.add(y, z, web * Across::weight[i] * length); });
  }
  return fibres;
}

/// N radii with sixteen around: areas are those of rings, so that the elastic moments are exact.
template <int N>
BeamFibres list_ring_fibres(double outer_radius, double inner_radius) {
  constexpr int around = 16;
  BeamFibres fibres;
  const double depth = outer_radius - inner_radius;
  for (int i = 0; i < N; ++i) {
    const double radius = inner_radius + depth * UnitGauss<N>::place[i];
    const double area = 2 * std::numbers::pi / around * radius * depth * UnitGauss<N>::weight[i];
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / around;
      fibres.add(radius * std::cos(angle), radius * std::sin(angle), area);
    }
  }
  return fibres;
}

/// Normal stress of a fibre, and its plastic strain.
struct FibreState {
  double stress = 0, plastic_strain = 0;
};

/// Linear isotropic hardening in one direction (Simo and Hughes, Computational Inelasticity, box 1.4).
struct FibreLaw {
  double youngs_modulus = 0, yield_stress = 0, hardening_modulus = 0;

  /// strain: of the step.
  KOKKOS_INLINE_FUNCTION FibreState advance(const FibreState& before, double strain) const {
    const double trial = before.stress + youngs_modulus * strain;
    const double excess = std::fabs(trial) - (yield_stress + hardening_modulus * before.plastic_strain);
    if (!(excess > 0)) return {trial, before.plastic_strain};
    const double flow = excess / (youngs_modulus + hardening_modulus);
    return {trial - std::copysign(youngs_modulus * flow, trial), before.plastic_strain + flow};
  }
};

/// Strain of a fibre from that of the section.
KOKKOS_INLINE_FUNCTION double find_fibre_strain(const BeamFibre& fibre, const BeamRates<double>& strain) {
  return strain.stretch + fibre.z * strain.curvature_y - fibre.y * strain.curvature_z;
}

/// Adds normal force and moments of a fibre.
KOKKOS_INLINE_FUNCTION void add_fibre(const BeamFibre& fibre, double stress, BeamForces<double>& f) {
  f.normal += fibre.area * stress;
  f.moment_y += fibre.area * stress * fibre.z;
  f.moment_z -= fibre.area * stress * fibre.y;
}

}  // namespace percuss
