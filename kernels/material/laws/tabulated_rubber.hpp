#pragma once
// Rubber from the curve of one uniaxial test, nearly incompressible.

#include <cmath>

#include "kernels/material/principal_stretches.hpp"

namespace percuss {

/// Principal stresses (s(b_i) - (s(b_1) + s(b_2) + s(b_3)) / 3) / J + K (J - 1), b = J^(-1/3) l, where s gives the
/// curve back in an incompressible uniaxial test: s(l) = g(l) + s(l^(-1/2)) = g(l) + g(l^(-1/2)) + g(l^(1/4)) + ..., g
/// = l times the engineering stress (Kolling, Du Bois, Benson and Feng, Computational Mechanics 40, 885, 2007). s is a
/// function of one stretch, so that the stress stores energy. It is held in rows over ln l. History: U.
struct TabulatedRubber {
  static constexpr const char* name = "tabulated_rubber";
  static constexpr bool stores_energy = true;
  static constexpr int intervals = 400;
  struct Constants {
    MaterialTable uniaxial;
    double bulk_modulus = 0;
    const char* find_fault() const;
  };
  double bulk_modulus = 0;
  double first = 0, over_width = 1, start_slope = 0;  // rows begin at ln l = first
  double value[intervals + 1] = {};

  static constexpr auto keys() {
    using C = Constants;
    return std::array{
        need("uniaxial", &C::uniaxial, KeyRange::any, "-, pressure",
             "Engineering stress over engineering strain of a uniaxial test, in compression (both negative) and "
             "tension, through [0, 0]; the slopes of its ends go on."),
        need("bulk_modulus", &C::bulk_modulus, KeyRange::positive, "pressure", "Bulk modulus.")};
  }

  static TabulatedRubber make(const Constants& c) {
    TabulatedRubber law;
    law.bulk_modulus = c.bulk_modulus;
    const MaterialTable& curve = c.uniaxial;
    // biaxial tension shortens the third direction by the square of the stretch
    const double reach = 2 * larger(-std::log(1 + curve.x[0]), std::log(1 + curve.x[curve.rows - 1]));
    law.first = -reach;
    law.over_width = intervals / (2 * reach);
    for (int i = 0; i <= intervals; ++i) law.value[i] = find_series(curve, -reach + i / law.over_width);
    const int middle = intervals / 2;
    law.start_slope =
        larger(law.value[middle] - law.value[middle - 1], law.value[middle + 1] - law.value[middle]) * law.over_width;
    return law;
  }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  /// The slope at rest is 2 mu.
  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    const double mu = 0.5 * start_slope;
    return {bulk_modulus - 2.0 / 3.0 * mu, mu};
  }

  /// s, and the largest slope by ln l of these rows and their neighbours; beyond the rows on with the slope of the
  /// last.
  template <class T>
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> find_term(const T& stretch) const {
    const T place = (logarithm(stretch) - T(first)) * T(over_width);
    const T row = smaller(larger(truncate(place), T(1)), T(intervals - 2));
    const T low = pick(row, 0), rise = pick(row, 1) - low;
    const T steepest = larger(rise, larger(low - pick(row, -1), pick(row, 2) - pick(row, 1)));
    return {low + (place - row) * rise, steepest * T(over_width)};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    advance_isochoric_stretches(step, bulk_modulus, [this](const T& stretch) { return find_term(stretch); });
  }

 private:
  KOKKOS_INLINE_FUNCTION double pick(double row, int ahead) const { return value[static_cast<int>(row) + ahead]; }
#ifdef PERCUSS_HAS_SIMD
  /// Picks the row of each lane.
  template <class Scalar, class Abi>
  KOKKOS_INLINE_FUNCTION std::experimental::simd<Scalar, Abi> pick(const std::experimental::simd<Scalar, Abi>& row,
                                                                   int ahead) const {
    return std::experimental::simd<Scalar, Abi>(
        [&](auto lane) { return static_cast<Scalar>(value[static_cast<int>(Scalar(row[lane])) + ahead]); });
  }
#endif

  /// l times the engineering stress, of ln l.
  static double find_true_stress(const MaterialTable& curve, double log_stretch) {
    const double strain = std::exp(log_stretch) - 1;
    const int last = curve.rows - 1;
    int i = 0;
    while (i + 2 <= last && strain > curve.x[i + 1]) ++i;
    const double slope = (curve.y[i + 1] - curve.y[i]) / (curve.x[i + 1] - curve.x[i]);
    // from the end that is nearer, so that 0 is exact
    const double stress =
        strain > 0 ? curve.y[i] + slope * (strain - curve.x[i]) : curve.y[i + 1] + slope * (strain - curve.x[i + 1]);
    return (1 + strain) * stress;
  }

  /// s: 60 terms, each of half the strain of the one before.
  static double find_series(const MaterialTable& curve, double log_stretch) {
    constexpr int terms = 60;
    double sum = 0;
    for (int n = 0; n < terms; ++n, log_stretch *= -0.5) sum += find_true_stress(curve, log_stretch);
    return sum;
  }
};

inline const char* TabulatedRubber::Constants::find_fault() const {
  if (uniaxial.rows < 3 || uniaxial.x[0] >= 0 || uniaxial.x[uniaxial.rows - 1] <= 0)
    return "a uniaxial curve without a row of compression and one of tension";
  if (uniaxial.x[0] <= -1) return "a uniaxial curve with a strain of -1 or less";
  bool has_origin = false;
  for (int i = 0; i < uniaxial.rows; ++i) {
    const double x = uniaxial.x[i], y = uniaxial.y[i];
    has_origin = has_origin || (x == 0 && y == 0);
    if (x * y < 0 || (x == 0) != (y == 0)) return "a uniaxial curve whose stress has not the sign of its strain";
  }
  return has_origin ? "" : "a uniaxial curve without the row [0, 0]";
}

}  // namespace percuss
