#pragma once
// Plasticity of rolled sheets: yield by direction, isotropic hardening.

#include <cmath>

#include "kernels/material/material_axes.hpp"
#include "kernels/material/quadratic_return.hpp"
#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// Yield by the axes 1 (rolling), 2 and 3 of a material: F (s22 - s33)^2 + G (s33 - s11)^2 + H (s11 - s22)^2 +
/// 2 L s23^2 + 2 M s13^2 + 2 N s12^2 = equivalent stress^2 (Hill, Proc. Roy. Soc. A 193, 1948).
struct HillCoefficients {
  double f = 0.5, g = 0.5, h = 0.5, l = 1.5, m = 1.5, n = 1.5;

  /// Coefficients from ratios of plastic strain, width over thickness, in tension at 0, 45 and 90 degrees to axis 1, in
  /// which the uniaxial stress is the equivalent one. Shear across the sheet is as that of an isotropic metal.
  static HillCoefficients of_strain_ratios(const double (&r)[3]) {
    const double shear = (r[0] + r[2]) * (1 + 2 * r[1]) / (2 * r[2] * (1 + r[0]));
    return {r[0] / (r[2] * (1 + r[0])), 1 / (1 + r[0]), r[0] / (1 + r[0]), 1.5, 1.5, shear};
  }

  /// Coefficients from yield stresses over the reference one: 11, 22, 33, and shears 12, 23, 13 times the square root
  /// of 3.
  static HillCoefficients of_stress_ratios(const double (&normal)[3], const double (&shear)[3]) {
    double over[3], of_shear[3];
    for (int k = 0; k < 3; ++k) {
      over[k] = 1 / (normal[k] * normal[k]);
      of_shear[k] = 1.5 / (shear[k] * shear[k]);
    }
    return {0.5 * (over[1] + over[2] - over[0]),
            0.5 * (over[2] + over[0] - over[1]),
            0.5 * (over[0] + over[1] - over[2]),
            of_shear[1],
            of_shear[2],
            of_shear[0]};
  }

  /// Coefficients of the plane-stress surface below with exponent 2.
  static HillCoefficients of_plane(const double (&chp)[3]) {
    const auto [c, h, p] = chp;
    return {h * h - 0.5 * c * h, 1 - 0.5 * c * h, 0.5 * c * h, 1.5, 1.5, 0.5 * p * p * (2 + c)};
  }

  bool is_convex() const { return f * g + g * h + h * f > 0 && f + g + h > 0 && l > 0 && m > 0 && n > 0; }
};

struct AnisotropicPlasticityConstants {
  double youngs_modulus = 0, poissons_ratio = 0;
  MaterialTable hardening;
  double r_values[3] = {1, 1, 1};
  double yield_ratios[3] = {0, 0, 0}, shear_yield_ratios[3] = {1, 1, 1};  // the first zeros: by r_values
  double barlat[3] = {0, 0, 0};                                           // c, h, p; zeros: by r_values
  double exponent = 2;
  double first_axis[3] = {1, 0, 0}, second_axis[3] = {0, 0, 0};  // of the second zeros: find_second_direction()
  bool follows_elements = false;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static bool is_given(const double (&values)[3]) { return values[0] != 0 || values[1] != 0 || values[2] != 0; }
  bool is_quadratic() const { return exponent == 2; }

  HillCoefficients find_hill() const {
    if (is_given(barlat)) return HillCoefficients::of_plane(barlat);
    if (is_given(yield_ratios)) return HillCoefficients::of_stress_ratios(yield_ratios, shear_yield_ratios);
    return HillCoefficients::of_strain_ratios(r_values);
  }

  const char* find_fault() const {
    for (int k = 0; k < 3; ++k) {
      if (!(r_values[k] > 0)) return "r_values that are not positive";
      if (!(shear_yield_ratios[k] > 0)) return "shear_yield_ratios that are not positive";
      if (is_given(yield_ratios) && !(yield_ratios[k] > 0)) return "yield_ratios that are not positive";
      if (is_given(barlat) && !(barlat[k] > 0)) return "barlat with a number that is not positive";
    }
    if (is_given(barlat) && is_given(yield_ratios)) return "barlat beside yield_ratios, which say the same";
    if (is_given(barlat) && !(barlat[0] < 2)) return "barlat with c that is not below 2 (a is 2 - c)";
    if (!(exponent >= 2 && exponent <= 40)) return "an exponent that is not between 2 and 40";
    if (!is_quadratic() && is_given(yield_ratios)) return "yield_ratios with an exponent (they are Hill's: leave it 2)";
    if (is_quadratic() && !find_hill().is_convex())
      return "yield ratios that no closed yield surface has (F G + G H + H F is not positive)";
    if (!are_axes(first_axis, second_axis)) return "first_axis and second_axis that are zero or parallel";
    return "";
  }
};

/// Isotropic elasticity; flow stress from the rows (p, yield stress). Exponent 2: Hill's surface. Others are of plies
/// of shells alone (kernels/shell/metal_ply.hpp). History: p, whose increment works on the equivalent stress.
struct AnisotropicPlasticity {
  static constexpr const char* name = "anisotropic_plasticity";
  using Constants = AnisotropicPlasticityConstants;
  Constants constants;
  double axes[3][3] = {};   // rows: 1, 2, 3
  double modes[2][3] = {};  // normal stresses of which the surface is diagonal, besides the mean
  double normal[2] = {};    // its coefficients of their squares
  double shear[3] = {};     // of the squares of 12, 23, 13
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using C = Constants;
    return join_keys(
        join_keys(
            with_elastic_keys<C>(
                need("hardening", &C::hardening, KeyRange::positive, "-, pressure",
                     "Yield stress along axis 1 over equivalent plastic strain; level before the first and after the "
                     "last row."),
                may("r_values", &C::r_values, KeyRange::any, "-",
                    "Plastic strain of the width over that of the thickness in tension at 0, 45 and 90 degrees to "
                    "axis 1."),
                may("yield_ratios", &C::yield_ratios, KeyRange::any, "-",
                    "Instead of r_values: yield stresses along the axes 1, 2, 3 over that of `hardening`."),
                may("shear_yield_ratios", &C::shear_yield_ratios, KeyRange::any, "-",
                    "With yield_ratios: those in the shears 12, 23, 13, times the square root of 3."),
                may("barlat", &C::barlat, KeyRange::any, "-",
                    "Instead of r_values: c, h and p of Barlat and Lian; a is 2 - c."),
                may("exponent", &C::exponent, KeyRange::positive, "-",
                    "Of the yield surface: 2 is Hill's of 1948; others, as 6 of steel and 8 of aluminium, are those of "
                    "Barlat and Lian, of shells alone.")),
            std::array{may("first_axis", &C::first_axis, KeyRange::any, "-",
                           "Direction of axis 1 in space at the start; shells take what of it lies in their plane."),
                       may("second_axis", &C::second_axis, KeyRange::any, "-",
                           "Of solids: a direction in the plane of the axes 1 and 2, on the side of axis 2."),
                       may("axes", &C::follows_elements, "space", "elements",
                           "elements: axis 1 of each shell points from its first corner to its second instead.")}),
        rate_keys<C>());
  }

  static AnisotropicPlasticity make(const Constants& c) {
    AnisotropicPlasticity law;
    law.constants = c;
    law.cowper_symonds_rate = c.cowper_symonds_rate;
    law.cowper_symonds_exponent = c.cowper_symonds_exponent;
    const Matrix3<double> rows = find_material_axes(c.first_axis, c.second_axis);
    for (int k = 0; k < 3; ++k) {
      law.axes[k][0] = rows.row[k].x;
      law.axes[k][1] = rows.row[k].y;
      law.axes[k][2] = rows.row[k].z;
    }
    law.set_modes(c.find_hill());
    return law;
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;
  static constexpr bool grows_in_increments = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    return find_lame_constants(constants.youngs_modulus, constants.poissons_ratio);
  }

  /// Static yield stress along axis 1 and its slope at p.
  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const auto row = constants.hardening(p);
    return {row.y, row.slope};
  }

  /// Advances solids, of Hill's surface.
  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const LameConstants c = moduli();
    const ElasticTrial<T> trial = find_trial(c, step.stress, step.motion.de);
    const Matrix3<T> turn = find_axes<T>();
    const Symmetric3<T> own = push_forward(turn, trial.deviator);
    QuadraticTrial<T, 5> of{
        {}, {2 * c.mu * normal[0], 2 * c.mu * normal[1], c.mu * shear[0], c.mu * shear[1], c.mu * shear[2]}};
    T along[2];
    for (int k = 0; k < 2; ++k) {
      along[k] = T(modes[k][0]) * own.xx + T(modes[k][1]) * own.yy + T(modes[k][2]) * own.zz;
      of.part[k] = T(normal[k]) * along[k] * along[k];
    }
    of.part[2] = T(shear[0]) * own.xy * own.xy;
    of.part[3] = T(shear[1]) * own.yz * own.yz;
    of.part[4] = T(shear[2]) * own.zx * own.zx;
    const auto flow = start_rate_flow(*this, step.history, step.motion.dt);
    const T l = find_multiplier(of, flow);
    const T equivalent = of.find_equivalent(l).value;
    T left[5];
    for (int k = 0; k < 5; ++k) left[k] = T(1) / (T(1) + T(of.rate[k]) * l);
    const T first = left[0] * along[0], second = left[1] * along[1];
    const Symmetric3<T> after{T(modes[0][0]) * first + T(modes[1][0]) * second,
                              T(modes[0][1]) * first + T(modes[1][1]) * second,
                              T(modes[0][2]) * first + T(modes[1][2]) * second,
                              left[2] * own.xy,
                              left[3] * own.yz,
                              left[4] * own.zx};
    step.history[0] = step.history[0] + l * equivalent;
    step.stress = add_pressure(pull_back(turn, after), trial.mean);
    const T flow_stress = larger(equivalent, flow.at_rest), ratio = equivalent / larger(flow_stress, T(1e-300));
    step.plastic = {T(1) / (T(1) + T(3 * c.mu) * l), flow_stress, smaller(ratio * ratio, T(1))};
  }

 private:
  template <class T>
  KOKKOS_INLINE_FUNCTION Matrix3<T> find_axes() const {
    const auto row = [&](int k) { return Vector3<T>{T(axes[k][0]), T(axes[k][1]), T(axes[k][2])}; };
    return {{row(0), row(1), row(2)}};
  }

  /// Eigenvectors of the surface among the normal stresses whose sum is 0, of unit length.
  void set_modes(const HillCoefficients& hill) {
    const double across = 1 / std::sqrt(2.0), axial = 1 / std::sqrt(6.0);
    const double base[2][3] = {{across, -across, 0}, {axial, axial, -2 * axial}};
    const auto find_form = [&](const double(&a)[3], const double(&b)[3]) {
      return hill.f * (a[1] - a[2]) * (b[1] - b[2]) + hill.g * (a[2] - a[0]) * (b[2] - b[0]) +
             hill.h * (a[0] - a[1]) * (b[0] - b[1]);
    };
    const double xx = find_form(base[0], base[0]), yy = find_form(base[1], base[1]), xy = find_form(base[0], base[1]);
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy), cosine = std::cos(angle), sine = std::sin(angle);
    for (int k = 0; k < 3; ++k) {
      modes[0][k] = cosine * base[0][k] + sine * base[1][k];
      modes[1][k] = cosine * base[1][k] - sine * base[0][k];
    }
    for (int k = 0; k < 2; ++k) normal[k] = find_form(modes[k], modes[k]);
    shear[0] = 2 * hill.n;
    shear[1] = 2 * hill.l;
    shear[2] = 2 * hill.m;
  }
};

}  // namespace percuss
