#pragma once
// Orthotropic elasticity: three planes of symmetry, as of plies with fibres, wood and rolled sheets.

#include <cmath>

#include "kernels/material/elastic.hpp"
#include "kernels/material/material_axes.hpp"

namespace percuss {

/// Constants of an orthotropic material by its axes 1, 2, 3, and strengths that plies of shells have
/// (kernels/shell/ply.hpp).
struct OrthotropicConstants {
  double moduli[3] = {0, 0, 0}, poissons_ratios[3] = {0, 0, 0}, shear_moduli[3] = {0, 0, 0};
  double first_axis[3] = {1, 0, 0}, second_axis[3] = {0, 0, 0};  // of the second zeros: find_second_direction()
  bool follows_elements = false, is_tsai_wu = false;             // the criterion of the matrix
  // 0: never fails so
  double fibre_tension = 0, fibre_compression = 0, matrix_tension = 0, matrix_compression = 0, shear = 0;
  double transverse_shear = 0, shear_in_fibre_tension = 0;
  double fibre_tension_energy = 0, fibre_compression_energy = 0, matrix_tension_energy = 0,
         matrix_compression_energy = 0;

  bool has_strength() const {
    return fibre_tension > 0 || fibre_compression > 0 || matrix_tension > 0 || matrix_compression > 0 || shear > 0;
  }

  /// Strain along b by a stress along a is -nu_ab / E_a; [12], [23], [13].
  const char* find_fault() const {
    const auto [e1, e2, e3] = moduli;
    const auto [n12, n23, n13] = poissons_ratios;
    const double n21 = n12 * e2 / e1, n32 = n23 * e3 / e2, n31 = n13 * e3 / e1;
    if (!(n12 * n21 < 1 && n23 * n32 < 1 && n13 * n31 < 1 &&
          1 - n12 * n21 - n23 * n32 - n13 * n31 - 2 * n21 * n32 * n13 > 0))
      return "poissons_ratios that no stable material has (nu_ab^2 < E_a / E_b of each pair, and all together)";
    if (!are_axes(first_axis, second_axis)) return "first_axis and second_axis that are zero or parallel";
    if (matrix_compression > 0 && !(shear > 0)) return "matrix_compression without shear, the strength in shear";
    if (is_tsai_wu && !(matrix_tension > 0 && matrix_compression > 0))
      return "matrix_criterion tsai_wu without matrix_tension and matrix_compression";
    if (matrix_tension > 0 && !(shear > 0)) return "matrix_tension without shear, the strength in shear";
    return "";
  }
};

/// sigma = C e in the material's axes, by increments; the rate is that of J sigma as in elastic.hpp. The axes are given
/// in space at the start and turn with the element. C is the inverse of the compliance (Jones, Mechanics of Composite
/// Materials, 2nd edition, section 2.2).
struct Orthotropic {
  static constexpr const char* name = "orthotropic";
  using Constants = OrthotropicConstants;
  Constants constants;
  double stiffness[6][6] = {};  // of the strains xx, yy, zz, 2 xy, 2 yz, 2 zx in space axes [stress]
  double largest = 0;           // bound of its eigenvalues

  static constexpr auto keys() {
    using C = OrthotropicConstants;
    return std::array{
        need("moduli", &C::moduli, KeyRange::positive, "pressure",
             "Young's moduli along the axes 1 (fibres), 2 and 3."),
        need("poissons_ratios", &C::poissons_ratios, KeyRange::any, "-",
             "nu12, nu23, nu13: strain along the second axis by a stress along the first."),
        need("shear_moduli", &C::shear_moduli, KeyRange::positive, "pressure", "G12, G23, G13."),
        may("first_axis", &C::first_axis, KeyRange::any, "-",
            "Direction of axis 1 in space at the start; shells take what of it lies in their plane."),
        may("second_axis", &C::second_axis, KeyRange::any, "-",
            "Of solids: a direction in the plane of the axes 1 and 2, on the side of axis 2."),
        may("axes", &C::follows_elements, "space", "elements",
            "elements: axis 1 of each shell points from its first corner to its second instead."),
        may("fibre_tension", &C::fibre_tension, KeyRange::not_negative, "pressure",
            "Strength along axis 1 of plies of shells; 0: never fails so."),
        may("fibre_compression", &C::fibre_compression, KeyRange::not_negative, "pressure", "Likewise in compression."),
        may("matrix_tension", &C::matrix_tension, KeyRange::not_negative, "pressure", "Strength along axis 2."),
        may("matrix_compression", &C::matrix_compression, KeyRange::not_negative, "pressure",
            "Likewise in compression."),
        may("matrix_criterion", &C::is_tsai_wu, "hashin", "tsai_wu",
            "hashin: Hashin's criteria of the matrix, those of Chang and Chang without transverse_shear. tsai_wu: that "
            "of Tsai and Wu (1971)."),
        may("shear", &C::shear, KeyRange::not_negative, "pressure", "Strength in shear 12."),
        may("transverse_shear", &C::transverse_shear, KeyRange::not_negative, "pressure",
            "Strength in shear 23 (Hashin); 0: as `shear` (Chang and Chang)."),
        may("shear_in_fibre_tension", &C::shear_in_fibre_tension, KeyRange::share, "-",
            "Share of the shear in the criterion of fibres in tension."),
        may("fibre_tension_energy", &C::fibre_tension_energy, KeyRange::not_negative, "energy / area",
            "Energy of a crack of this kind; 0: brittle."),
        may("fibre_compression_energy", &C::fibre_compression_energy, KeyRange::not_negative, "energy / area",
            "Likewise."),
        may("matrix_tension_energy", &C::matrix_tension_energy, KeyRange::not_negative, "energy / area", "Likewise."),
        may("matrix_compression_energy", &C::matrix_compression_energy, KeyRange::not_negative, "energy / area",
            "Likewise.")};
  }

  static Orthotropic make(const Constants& c) {
    Orthotropic law;
    law.constants = c;
    double own[6][6] = {};
    set_normal_stiffness(c, own);
    for (int k = 0; k < 3; ++k) own[3 + k][3 + k] = 2 * c.shear_moduli[k];
    law.turn_stiffness(own, find_material_axes(c.first_axis, c.second_axis));
    law.largest = find_largest(own);
    return law;
  }

  static constexpr int history_count = 0;

  /// Isotropic ones that are nowhere softer: they bound the stiffness of every strain.
  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return {0, 0.5 * largest}; }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const Symmetric3<T> de = step.motion.de;
    const T strain[6] = {de.xx, de.yy, de.zz, T(2) * de.xy, T(2) * de.yz, T(2) * de.zx};
    T added[6];
    for (int i = 0; i < 6; ++i) {
      added[i] = T(stiffness[i][0]) * strain[0];
      for (int j = 1; j < 6; ++j) added[i] = added[i] + T(stiffness[i][j]) * strain[j];
    }
    const Symmetric3<T> increment{added[0], added[1], added[2], added[3], added[4], added[5]};
    const VolumeChange<T>& change = step.motion.change;
    step.stress = step.stress + change.inverse * (increment + (T(0) - change.growth) * step.stress);
    const Moduli<T> now = find_elastic_moduli<T>(moduli(), bound_pressure(step.stress), change.inverse);
    step.lambda = now.lambda;
    step.mu = now.mu;
  }

 private:
  /// The inverse of the compliance of normal strains.
  static void set_normal_stiffness(const Constants& c, double (&own)[6][6]) {
    const auto [e1, e2, e3] = c.moduli;
    const auto [n12, n23, n13] = c.poissons_ratios;
    const double n21 = n12 * e2 / e1, n32 = n23 * e3 / e2, n31 = n13 * e3 / e1;
    const double over = 1 / (1 - n12 * n21 - n23 * n32 - n13 * n31 - 2 * n21 * n32 * n13);
    own[0][0] = e1 * (1 - n23 * n32) * over;
    own[1][1] = e2 * (1 - n13 * n31) * over;
    own[2][2] = e3 * (1 - n12 * n21) * over;
    own[0][1] = own[1][0] = e1 * (n21 + n31 * n23) * over;
    own[0][2] = own[2][0] = e1 * (n31 + n21 * n32) * over;
    own[1][2] = own[2][1] = e2 * (n32 + n12 * n31) * over;
  }

  /// Sets the stiffness of strains in space axes. own: that of strains as tensors by the axes, [xx, yy, zz, xy, yz,
  /// zx].
  void turn_stiffness(const double (&own)[6][6], const Matrix3<double>& axes) {
    for (int j = 0; j < 6; ++j) {
      const auto unit = [&](int k) { return k != j ? 0.0 : (k < 3 ? 1.0 : 0.5); };  // as a tensor
      const Symmetric3<double> e =
          push_forward(axes, Symmetric3<double>{unit(0), unit(1), unit(2), unit(3), unit(4), unit(5)});
      const double strain[6] = {e.xx, e.yy, e.zz, e.xy, e.yz, e.zx};
      double stress[6] = {};
      for (int k = 0; k < 6; ++k)
        for (int m = 0; m < 6; ++m) stress[k] += own[k][m] * strain[m];
      const Symmetric3<double> s =
          pull_back(axes, Symmetric3<double>{stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]});
      const double column[6] = {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
      for (int i = 0; i < 6; ++i) stiffness[i][j] = column[i];
    }
  }

  /// Bound of the eigenvalues of a stiffness of tensors: the largest of the sums of its rows.
  static double find_largest(const double (&own)[6][6]) {
    double largest = 0;
    for (const auto& row : own) {
      double sum = 0;
      for (const double value : row) sum += std::abs(value);
      largest = larger(largest, sum);
    }
    return largest;
  }
};

}  // namespace percuss
