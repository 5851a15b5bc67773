#pragma once
// The yield surface of Barlat and Lian in plane stress, and the return to it.
//
// Barlat and Lian, Int. J. Plasticity 5 (1989). Return: Newton's method with a line search (Scherzinger, Comput.
// Methods Appl. Mech. Eng. 317, 2017). Formulas: docs/theory_shells.md.

#include <cmath>

#include "kernels/material/radial_return.hpp"
#include "kernels/shell/plane_stress.hpp"

namespace percuss {

/// Equivalent stress s of a |k + q|^m + a |k - q|^m + c |2 q|^m = 2 s^m with a = 2 - c. Stresses by three numbers:
/// k = (s11 + h s22) / 2, d = (s11 - h s22) / 2 and z = p s12; q^2 = d^2 + z^2.
struct BarlatSurface {
  double c = 1, h = 1, p = 1, exponent = 2;

  /// Equivalent stress, its gradient and its second derivatives by k, d, z (in the places of x, y, z).
  template <class T>
  struct Value {
    T stress;
    Vector3<T> gradient;
    Symmetric3<T> curvature;
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION Vector3<T> find_numbers(const T (&s)[3]) const {
    return {T(0.5) * (s[0] + T(h) * s[1]), T(0.5) * (s[0] - T(h) * s[1]), T(p) * s[2]};
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION void find_stress(const Vector3<T>& y, T (&s)[3]) const {
    s[0] = y.x + y.y;
    s[1] = T(1 / h) * (y.x - y.y);
    s[2] = T(1 / p) * y.z;
  }
  /// Strains 11, 22, 2 12 that work on s as e does on k, d, z.
  template <class T>
  KOKKOS_INLINE_FUNCTION void find_strain(const Vector3<T>& e, T (&strain)[3]) const {
    strain[0] = T(0.5) * (e.x + e.y);
    strain[1] = T(0.5 * h) * (e.x - e.y);
    strain[2] = T(p) * e.z;
  }

  /// Compliance of k, d, z.
  KOKKOS_INLINE_FUNCTION Symmetric3<double> find_compliance(const PlaneElasticity& e) const {
    const double over_e = 1 / e.youngs_modulus, nu = e.poissons_ratio, over_h = 1 / h;
    return {over_e * (1 - 2 * nu * over_h + over_h * over_h),
            over_e * (1 + 2 * nu * over_h + over_h * over_h),
            1 / (e.shear_modulus * p * p),
            over_e * (1 - over_h * over_h),
            0,
            0};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION Value<T> operator()(const Vector3<T>& y) const {
    constexpr double least = 1e-5;  // q below it, over the stress: derivatives by q are those at 0, where f is even
    const double m = exponent, a = 2 - c;
    const T tiny = T(1e-300), q = square_root(y.y * y.y + y.z * y.z);
    const T size = larger(larger(y.x, T(0) - y.x) + q, tiny), over_size = T(1) / size;
    const T k = select(size > tiny, over_size * y.x, T(1)), w = over_size * q;  // finite without stress, too
    const T sum = k + w, rest = k - w;
    const T u = larger(sum, T(0) - sum), v = larger(rest, T(0) - rest), both = T(2) * w;
    const T high[3] = {raise(u), raise(v), raise(both)};
    const T of[3] = {T(a) * high[0], T(a) * high[1], T(c) * high[2]};
    const T level = T(0.5) * (of[0] * u * u + of[1] * v * v + of[2] * both * both);
    const T f = power(level, 1 / m);  // over size
    const T first = T(0.5) * f / level;
    const T by_k = first * (of[0] * sum + of[1] * rest),
            by_q = first * (of[0] * sum - of[1] * rest + T(2) * of[2] * both);
    const T second = T(m - 1) * first, bend = T(m - 1) / f;
    const T kk = second * (of[0] + of[1]) - bend * by_k * by_k, kq = second * (of[0] - of[1]) - bend * by_k * by_q;
    const T qq = second * (of[0] + of[1] + T(4) * of[2]) - bend * by_q * by_q;
    const auto is_round = w < T(least);
    const T over_q = T(1) / larger(w, T(least));
    const T around = select(is_round, qq, by_q * over_q);
    const T d = select(q > tiny, y.y / larger(q, tiny), T(1)), z = select(q > tiny, y.z / larger(q, tiny), T(0));
    return {size * f,
            {by_k, by_q * d, by_q * z},
            {over_size * kk, over_size * (qq * d * d + around * z * z), over_size * (qq * z * z + around * d * d),
             over_size * kq * d, over_size * (qq - around) * d * z, over_size * kq * z}};
  }

  /// x^(exponent - 2); of an integer by products, which take a fifth of the time.
  template <class T>
  KOKKOS_INLINE_FUNCTION T raise(T x) const {
    int left = static_cast<int>(exponent) - 2;
    if (exponent - 2 != left) return power(x, exponent - 2);
    T product = left % 2 == 1 ? x : T(1);
    for (left /= 2; left > 0; left /= 2) {
      x = x * x;
      if (left % 2 == 1) product = product * x;
    }
    return product;
  }

  /// Plastic strain of the width over that of the thickness in tension at 45 degrees.
  double find_diagonal_ratio() const {
    const double s[3] = {0.5, 0.5, 0.5};
    double e[3];
    find_strain((*this)(find_numbers(s)).gradient, e);
    return 0.5 * e[2] / (e[0] + e[1]) - 0.5;
  }

  /// c, h, p by ratios of plastic strain at 0, 45 and 90 degrees to axis 1.
  static BarlatSurface of_strain_ratios(const double (&r)[3], double exponent) {
    const double first = r[0] / (1 + r[0]), last = r[2] / (1 + r[2]);
    BarlatSurface of{2 * std::sqrt(first * last), std::sqrt(first / last), 1, exponent};
    double low = 1e-3, high = 1e3;
    for (int i = 0; i < 120; ++i) {
      of.p = std::sqrt(low * high);
      (of.find_diagonal_ratio() < r[1] ? low : high) = of.p;
    }
    return of;
  }
};

/// What the return gives: dp, and the stress by k, d, z with its surface.
template <class T>
struct BarlatReturn {
  Vector3<T> stress;
  Vector3<T> gradient;
  T equivalent, dp;
};

/// One point on the way of the return.
template <class T>
struct BarlatTry {
  Vector3<T> stress;
  T dp;
  BarlatSurface::Value<T> at;
  FlowStress<T> flow;
  Vector3<T> residual;  // compliance (stress - trial) + dp gradient
  T excess;             // equivalent less flow stress
  T merit;              // of both [stress^2]
};

/// Solves compliance (y - trial) + dp gradient(y) = 0, stress(y) = flow(dp). Elastic where the trial is not above
/// flow.at_rest. A lane stays as it is once it has converged, so that its bits do not depend on its neighbours.
template <class T, class Flow>
class BarlatSolver {
 public:
  KOKKOS_INLINE_FUNCTION BarlatSolver(const BarlatSurface& surface, const PlaneElasticity& elasticity,
                                      const Vector3<T>& trial, const Flow& flow)
      : surface_(surface), flow_(flow), trial_(trial) {
    const Symmetric3<double> s = surface.find_compliance(elasticity);
    const Adjugate<double> inverse = find_adjugate(s);
    const double over = 1 / inverse.determinant;
    const Symmetric3<double>& i = inverse.matrix;
    compliance_ = {T(s.xx), T(s.yy), T(s.zz), T(s.xy), T(s.yz), T(s.zx)};
    stiffness_ = {T(over * i.xx), T(over * i.yy), T(over * i.zz), T(over * i.xy), T(over * i.yz), T(over * i.zx)};
    youngs_modulus_ = elasticity.youngs_modulus;
  }

  KOKKOS_INLINE_FUNCTION BarlatReturn<T> solve() const {
    constexpr int most_steps = 200;
    constexpr double tolerance = 4e-15;  // share of the trial's equivalent stress
    BarlatTry<T> now = start();
    const T size = now.at.stress;
    auto open = size > flow_.at_rest;
    if (!any(open)) return {now.stress, now.at.gradient, now.at.stress, T(0)};
    open = open && now.merit > T(0);
    const auto yields = open;
    const BarlatTry<T> elastic = now;
    begin(yields, now);
    Vector3<T> way{T(0), T(0), T(0)};
    T more = T(0), share = T(1);
    find_way(now, way, more);
    for (int i = 0; i < most_steps && any(open); ++i) {
      const BarlatTry<T> next = evaluate(now.stress + share * way, larger(now.dp + share * more, T(0.1) * now.dp));
      const auto better = next.merit < (T(1) - T(2e-4) * share) * now.merit;
      take(open && better, next, now);
      open = open && now.merit > T(tolerance * tolerance) * size * size && share > T(1e-4);
      share = select(better, T(1), T(0.4) * share);
      find_way(now, way, more);
    }
    take(!yields, elastic, now);
    return {now.stress, now.at.gradient, now.at.stress, select(yields, now.dp, T(0))};
  }

 private:
  KOKKOS_INLINE_FUNCTION BarlatTry<T> evaluate(const Vector3<T>& stress, const T& dp) const {
    BarlatTry<T> of;
    of.stress = stress;
    of.dp = dp;
    of.at = surface_(stress);
    of.flow = flow_(dp);
    of.residual = compliance_ * (stress - trial_) + dp * of.at.gradient;
    of.excess = of.at.stress - of.flow.value;
    of.merit = of.excess * of.excess + T(youngs_modulus_) * dot(of.residual, stiffness_ * of.residual);
    return of;
  }

  KOKKOS_INLINE_FUNCTION BarlatTry<T> start() const {
    BarlatTry<T> of = evaluate(trial_, T(0));
    of.merit = larger(of.merit, T(1e-300));
    return of;
  }

  /// From the trial to the surface along its radius.
  template <class Mask>
  KOKKOS_INLINE_FUNCTION void begin(const Mask& yields, BarlatTry<T>& now) const {
    const T excess = now.at.stress - flow_.at_rest;
    const T resistance = dot(now.at.gradient, stiffness_ * now.at.gradient);
    const T dp = select(yields, excess / resistance, T(0));
    const T shrink = select(yields, flow_.at_rest / now.at.stress, T(1));
    take(yields, evaluate(shrink * trial_, dp), now);
  }

  /// Newton's step.
  KOKKOS_INLINE_FUNCTION void find_way(const BarlatTry<T>& now, Vector3<T>& way, T& more) const {
    const Adjugate<T> tangent = find_adjugate(compliance_ + now.dp * now.at.curvature);
    const T over = T(1) / tangent.determinant;
    const Vector3<T> by_residual = over * (tangent.matrix * now.residual),
                     by_flow = over * (tangent.matrix * now.at.gradient);
    more = (now.excess - dot(now.at.gradient, by_residual)) / (dot(now.at.gradient, by_flow) + now.flow.slope);
    way = T(-1) * (by_residual + more * by_flow);
  }

  template <class Mask>
  KOKKOS_INLINE_FUNCTION static void take(const Mask& lanes, const BarlatTry<T>& from, BarlatTry<T>& to) {
    const auto of = [&](const T& yes, T& no) { no = select(lanes, yes, no); };
    const auto of_vector = [&](const Vector3<T>& yes, Vector3<T>& no) {
      of(yes.x, no.x);
      of(yes.y, no.y);
      of(yes.z, no.z);
    };
    of_vector(from.stress, to.stress);
    of(from.dp, to.dp);
    of(from.at.stress, to.at.stress);
    of_vector(from.at.gradient, to.at.gradient);
    of(from.at.curvature.xx, to.at.curvature.xx);
    of(from.at.curvature.yy, to.at.curvature.yy);
    of(from.at.curvature.zz, to.at.curvature.zz);
    of(from.at.curvature.xy, to.at.curvature.xy);
    of(from.at.curvature.yz, to.at.curvature.yz);
    of(from.at.curvature.zx, to.at.curvature.zx);
    of(from.flow.value, to.flow.value);
    of(from.flow.slope, to.flow.slope);
    of_vector(from.residual, to.residual);
    of(from.excess, to.excess);
    of(from.merit, to.merit);
  }

  const BarlatSurface& surface_;
  const Flow& flow_;
  Vector3<T> trial_;
  Symmetric3<T> compliance_, stiffness_;
  double youngs_modulus_;
};

}  // namespace percuss
