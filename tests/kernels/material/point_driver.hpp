#pragma once
// Leads a law through a path of strain at one point, and integrates the rate equations of plasticity independently.

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/material/laws/call_material.hpp"

namespace percuss::test {

using Strain = Symmetric3<double>;

inline Strain scale(double s, const Strain& a) { return s * a; }

/// One piece of a path: a constant rate of deformation for a time, in a number of steps of the law.
struct Leg {
  Strain rate;
  double time;
  int steps;
};

/// A point of a law that is led along a path.
template <class Law>
class Point {
 public:
  // Not inlined: GCC 12 would warn of loops of laws that this one is not.
  template <class... State>
  [[gnu::noinline]] explicit Point(const Law& law, double density, const State&... state)
      : material(make_called_material(law, density, state...)) {
    const double center[3] = {0, 0, 0};
    start_history(material, history, center);
  }

  /// One step; the material's own volume follows the strain exactly.
  void advance(const Strain& de, double dt) {
    time += dt;
    log_volume += trace(de);
    const double now = std::exp(log_volume);
    PointStep<double> step{{de, dt, now, 1, viscosity, time, {now - last_volume, 1 / now}}, stress, history};
    last_volume = now;
    material.update(step);
    stress = step.stress;
    plastic = step.plastic;
    modulus = step.lambda + 2 * step.mu;
  }

  void follow(const Leg& leg) {
    for (int i = 0; i < leg.steps; ++i) advance(scale(leg.time / leg.steps, leg.rate), leg.time / leg.steps);
  }

  CalledMaterial material;
  Symmetric3<double> stress{};
  double history[CalledMaterial::history_count] = {};
  double viscosity = 0;  // mean viscous pressure of the next step
  double time = 0, log_volume = 0, last_volume = 1, modulus = 0;
  PlasticReturn<double> plastic{};
  double p() const { return history[1]; }
};

inline double von_mises(const Symmetric3<double>& s) {
  const double m = trace(s) / 3;
  const Symmetric3<double> d{s.xx - m, s.yy - m, s.zz - m, s.xy, s.yz, s.zx};
  return std::sqrt(1.5 * contract(d, d));
}

inline double largest_difference(const Symmetric3<double>& a, const Symmetric3<double>& b) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.yy - b.yy), std::abs(a.zz - b.zz), std::abs(a.xy - b.xy),
                   std::abs(a.yz - b.yz), std::abs(a.zx - b.zx)});
}

/// The rate equations of J2 plasticity by Euler's method in many substeps, from what a test says of the flow:
///   s' = 2 mu (dev d - 3/2 p' (s - a) / |s - a|),  a' = k p' (s - a) / |s - a|,  T' = heat J p' |s|,  |s| von Mises
/// p' either from consistency (yield and slope over p), or from a law p'(von Mises stress, p, T).
struct PlasticReference {
  LameConstants moduli;
  double kinematic = 0;
  double heat = 0;
  Symmetric3<double> deviator{}, back{};
  double pressure = 0, p = 0, temperature = 0, log_volume = 0;

  template <class YieldOf, class SlopeOf>
  void follow_by_consistency(const Leg& leg, int substeps, const YieldOf& yield, const SlopeOf& slope) {
    follow(leg, substeps, [&](const Symmetric3<double>& n, double size, const Symmetric3<double>& rate) {
      const double loading = 2 * moduli.mu * 1.5 * contract(n, rate);  // n: deviator / von Mises
      if (size < yield(p) || loading <= 0) return 0.0;
      return loading / (3 * moduli.mu + kinematic + slope(p));
    });
  }

  template <class RateOf>
  void follow_by_rate(const Leg& leg, int substeps, const RateOf& rate_of) {
    follow(leg, substeps, [&](const Symmetric3<double>&, double size, const Symmetric3<double>&) {
      return rate_of(size, p, temperature);
    });
  }

  Symmetric3<double> stress() const { return deviator + Symmetric3<double>{-pressure, -pressure, -pressure, 0, 0, 0}; }

 private:
  template <class Flow>
  void follow(const Leg& leg, int substeps, const Flow& flow) {
    const double dt = leg.time / substeps, mean = trace(leg.rate) / 3;
    const Symmetric3<double> rate = leg.rate + Symmetric3<double>{-mean, -mean, -mean, 0, 0, 0};
    for (int i = 0; i < substeps; ++i) {
      const Symmetric3<double> relative = deviator + (-1.0) * back;
      const double size = von_mises(relative);
      const Symmetric3<double> n = (size > 0 ? 1 / size : 0) * relative;
      const double flowing = flow(n, size, rate);
      deviator = deviator + (2 * moduli.mu * dt) * (rate + (-1.5 * flowing) * n);
      back = back + (kinematic * flowing * dt) * n;
      log_volume += 3 * mean * dt;
      temperature += heat * std::exp(log_volume) * flowing * von_mises(deviator) * dt;
      p += flowing * dt;
      pressure -= (moduli.lambda + 2.0 / 3.0 * moduli.mu) * 3 * mean * dt;
    }
  }
};

}  // namespace percuss::test
