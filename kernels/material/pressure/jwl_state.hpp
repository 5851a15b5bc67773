#pragma once
// Detonation products after Jones, Wilkins and Lee (Lee, Hornig and Kury, UCRL-50422, 1968), lit by programmed burn.

#include "kernels/material/pressure/equation_of_state.hpp"

namespace percuss {

/// p = F (A (1 - w / (R1 J)) exp(-R1 J) + B (1 - w / (R2 J)) exp(-R2 J) + w e / J). The share F that has burnt grows
/// from 0 when the detonation arrives, |x - detonation_point| / detonation_velocity after the start, to 1 when it has
/// gone 1.5 elements further (Wilkins 1964).
struct JwlState {
  static constexpr const char* name = "jwl";
  static constexpr bool is_lit = true;
  using Constants = JwlState;
  double a = 0, b = 0, r1 = 0, r2 = 0, omega = 0, energy = 0, detonation_velocity = 0;
  double detonation_point[3] = {0, 0, 0};
  double least_pressure = no_cutoff;

  static constexpr auto keys() {
    using M = JwlState;
    return std::array{
        need("a", &M::a, KeyRange::positive, "pressure", "A of the products' pressure; see theory.md."),
        need("b", &M::b, KeyRange::any, "pressure", "B of the products' pressure; see theory.md."),
        need("r1", &M::r1, KeyRange::positive, "-", "R1 of the products' pressure; see theory.md."),
        need("r2", &M::r2, KeyRange::positive, "-", "R2 of the products' pressure; see theory.md."),
        need("omega", &M::omega, KeyRange::positive, "-", "Omega of the products' pressure; see theory.md."),
        need("energy", &M::energy, KeyRange::positive, "energy / volume", "Chemical energy."),
        need("detonation_velocity", &M::detonation_velocity, KeyRange::positive, "velocity",
             "Speed at which the burn spreads."),
        need("detonation_point", &M::detonation_point, KeyRange::any, "length", "Where it is lit, at time 0."),
        cutoff_key<M>()};
  }
  double find_start_energy() const { return energy; }

  /// When the detonation reaches a point.
  double find_lighting_time(const double (&x)[3]) const {
    double square = 0;
    for (int k = 0; k < 3; ++k) square += (x[k] - detonation_point[k]) * (x[k] - detonation_point[k]);
    return square_root(square) / detonation_velocity;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& at) const {
    constexpr double burning_elements = 1.5;
    const T burnt = smaller(
        larger((T(at.time) - at.lighting_time) * T(detonation_velocity / burning_elements) / at.length, T(0)), T(1));
    const T inverse = T(1) / j;
    const T first = T(a) * exponential(T(-r1) * j), second = T(b) * exponential(T(-r2) * j);
    const T w1 = T(omega / r1) * inverse, w2 = T(omega / r2) * inverse, heat = T(omega) * inverse;
    const T pressure = first * (T(1) - w1) + second * (T(1) - w2) + heat * e;
    const T by_volume = first * (w1 * inverse - T(r1) * (T(1) - w1)) + second * (w2 * inverse - T(r2) * (T(1) - w2)) -
                        heat * inverse * e;
    // what has not burnt carries no pressure, but the step must be ready for what the burn brings
    const T stiff(at.density * detonation_velocity * detonation_velocity);
    const auto is_burnt = burnt >= T(1);
    return {burnt * pressure, select(is_burnt, by_volume, smaller(by_volume, -stiff * inverse)), burnt * heat};
  }
};

}  // namespace percuss
