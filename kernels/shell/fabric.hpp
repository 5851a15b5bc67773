#pragma once
// Fabric: a membrane of two families of threads, warp and weft, that turn and stretch with the surface.
//
// Strains are Green's, E, by the threads as they lay at the start, of the whole motion from there: no increments add
// up, and no strain need be small. Stresses are the second of Piola and Kirchhoff, S, linear in E. Without compression
// S is that of a tension field (Reissner 1938; Pipkin 1986 and 1993): the sheet wrinkles, at no cost, until nothing is
// compressed. Its energy is the least over all wrinkles, so that S follows from an energy, and a cycle gives back what
// it took. Formulas: docs/theory_shells.md.

#include <array>
#include <cmath>

#include "kernels/material/elastic.hpp"
#include "kernels/material/material_axes.hpp"
#include "kernels/shell/plane_stress.hpp"
#include "kernels/shell/ply.hpp"

namespace percuss {

/// Constants of a fabric by its warp, 1, and its weft, 2.
struct FabricConstants {
  double warp_modulus = 0, weft_modulus = 0, shear_modulus = 0, poissons_ratio = 0;
  double first_axis[3] = {1, 0, 0};
  bool by_elements = false, no_compression = false;
  double compression_share = 1e-3;

  double find_weft_ratio() const { return poissons_ratio * weft_modulus / warp_modulus; }

  const char* find_fault() const {
    if (!(poissons_ratio * find_weft_ratio() < 1))
      return "warp_poissons_ratio that no stable material has (its square is below warp_modulus / weft_modulus)";
    if (first_axis[0] == 0 && first_axis[1] == 0 && first_axis[2] == 0) return "first_axis that is zero";
    return "";
  }
};

/// The law as a deck gives it. Only membranes have it: FabricLayer is what they compute.
struct Fabric {
  static constexpr const char* name = "fabric";
  using Constants = FabricConstants;
  Constants constants;

  static constexpr auto keys() {
    using C = FabricConstants;
    return std::array{
        need("warp_modulus", &C::warp_modulus, KeyRange::positive, "pressure", "Young's modulus along the warp."),
        need("weft_modulus", &C::weft_modulus, KeyRange::positive, "pressure", "Along the weft."),
        need("shear_modulus", &C::shear_modulus, KeyRange::positive, "pressure", "Of shear between both."),
        may("warp_poissons_ratio", &C::poissons_ratio, KeyRange::not_negative, "-",
            "Strain along the weft by a stress along the warp."),
        may("first_axis", &C::first_axis, KeyRange::any, "-",
            "Direction of the warp in space at the start, of which membranes take what lies in their plane; the weft "
            "is "
            "at a right angle to it there."),
        may("axes", &C::by_elements, "space", "elements",
            "elements: the warp of each membrane points from its first corner to its second instead."),
        may("no_compression", &C::no_compression, "false", "true",
            "true: a tension field, which wrinkles instead of taking compression."),
        may("compression_share", &C::compression_share, KeyRange::share, "-",
            "With no_compression: share of the stress without wrinkles that is kept.")};
  }

  static Fabric make(const Constants& c) { return {c}; }

  /// Isotropic ones that are nowhere softer, of small strains.
  LameConstants moduli() const { return {0, 0.5 * find_largest()}; }

  /// The largest eigenvalue of the stiffness of strains as tensors.
  double find_largest() const {
    const double over = 1 / (1 - constants.poissons_ratio * constants.find_weft_ratio());
    const double q11 = constants.warp_modulus * over, q22 = constants.weft_modulus * over;
    const double q12 = constants.poissons_ratio * q22;
    const double plane = 0.5 * (q11 + q22) + std::hypot(0.5 * (q11 - q22), q12);
    return larger(plane, 2 * constants.shear_modulus);
  }
};

/// What a membrane of fabric keeps: the threads by the diagonals of the element, warp = r of_r + s of_s, so that they
/// follow it whatever it does; the energy per volume at n; the square of the warp of the element at the start.
struct FabricHistory {
  static constexpr int warp_r = 0, warp_s = 1, weft_r = 2, weft_s = 3, energy = 4, start_warp = 5, count = 6;
};

/// The threads of an element in its frame, as long as they are stretched.
template <class T>
struct Threads {
  T warp[2], weft[2];
  T area_ratio;  // of the element to that at the start
  T start_area;
};

/// What a fabric tells the element.
template <class T>
struct FabricResponse {
  T stress[3];  // Cauchy's with the thickness of the start, xx, yy, xy
  T energy;     // that the step added, per volume of the start
  T start_area;
  T stiffening;  // bound of its stiffness now over that of small strains
};

struct FabricLayer {
  static constexpr int most_history = FabricHistory::count;
  static constexpr bool can_yield = false;
  static constexpr bool is_fabric = true;
  static constexpr int samples = 9;           // of directions of a tension field, from warp to weft
  static constexpr int most_iterations = 60;  // of the search between two of them
  /// Hourglass stiffness of a sheet that cannot be compressed, as a share of the physical stiffness.
  static constexpr double slack_hourglass = 0.05;

  PlaneElasticity elasticity;  // isotropic mean over all directions, for the hourglass modes
  PlaneElasticity bound;
  double q11 = 0, q22 = 0, q12 = 0, g12 = 0;
  double warp_compliance = 0, weft_compliance = 0,
         mixed_compliance = 0;  // of tension along t: a c^4 + m c^2 s^2 + b s^4
  double cosine[samples] = {}, sine[samples] = {};
  double compression_share = 1;  // 1: it takes compression

  static constexpr int count_history() { return FabricHistory::count; }

  static FabricLayer make(const Fabric& law) {
    const FabricConstants& c = law.constants;
    FabricLayer layer;
    const double over = 1 / (1 - c.poissons_ratio * c.find_weft_ratio());
    layer.q11 = c.warp_modulus * over;
    layer.q22 = c.weft_modulus * over;
    layer.q12 = c.poissons_ratio * layer.q22;
    layer.g12 = c.shear_modulus;
    layer.warp_compliance = 1 / c.warp_modulus;
    layer.weft_compliance = 1 / c.weft_modulus;
    layer.mixed_compliance = 1 / c.shear_modulus - 2 * c.poissons_ratio / c.warp_modulus;
    if (c.no_compression) layer.compression_share = c.compression_share;
    // Invariants of the stiffness (Tsai and Pagano 1968).
    const double u1 = (3 * layer.q11 + 3 * layer.q22 + 2 * layer.q12 + 4 * layer.g12) / 8;
    const double u4 = (layer.q11 + layer.q22 + 6 * layer.q12 - 4 * layer.g12) / 8;
    const double share = c.no_compression ? slack_hourglass : 1;
    layer.elasticity = find_plane_elasticity(share * (u1 * u1 - u4 * u4) / u1, u4 / u1);
    layer.bound = find_plane_elasticity(law.find_largest(), 0);
    layer.set_samples();
    return layer;
  }

  /// The stress at n+1 of where the corners are. warp_strain: Green's strain by the warp of the element, 11, 22, 12.
  template <class T>
  PERCUSS_FORCE_INLINE FabricResponse<T> update(const Threads<T>& threads, const T (&warp_strain)[3],
                                                T* history) const {
    const T half = T(0.5);
    const T(&a)[2] = threads.warp;
    const T(&b)[2] = threads.weft;
    const T aa = a[0] * a[0] + a[1] * a[1], bb = b[0] * b[0] + b[1] * b[1], ab = a[0] * b[0] + a[1] * b[1];
    const T e[3] = {half * (aa - T(1)) + warp_strain[0], half * (bb - T(1)) + warp_strain[1],
                    half * ab + warp_strain[2]};
    T s[3];
    find_stress(e, s);
    FabricResponse<T> to;
    const T over = T(1) / threads.area_ratio;
    to.stress[0] = over * (s[0] * a[0] * a[0] + T(2) * s[2] * a[0] * b[0] + s[1] * b[0] * b[0]);
    to.stress[1] = over * (s[0] * a[1] * a[1] + T(2) * s[2] * a[1] * b[1] + s[1] * b[1] * b[1]);
    to.stress[2] = over * (s[0] * a[0] * a[1] + s[2] * (a[0] * b[1] + a[1] * b[0]) + s[1] * b[0] * b[1]);
    const T energy = half * (s[0] * e[0] + s[1] * e[1]) + s[2] * e[2];
    to.energy = energy - history[FabricHistory::energy];
    history[FabricHistory::energy] = energy;
    to.start_area = threads.start_area;
    // Moduli grow with the fourth power of the stretch; tension resists any motion across its direction.
    const T middle = half * (aa + bb), stretch = middle + square_root(half * half * (aa - bb) * (aa - bb) + ab * ab);
    const T mean = half * (to.stress[0] + to.stress[1]), difference = half * (to.stress[0] - to.stress[1]);
    const T tension = larger(mean + square_root(difference * difference + to.stress[2] * to.stress[2]), T(0));
    to.stiffening = larger(stretch * stretch * over, T(1)) + T(2 / bound.youngs_modulus) * tension;
    return to;
  }

  /// S of E, both 11, 22, 12 as tensors.
  template <class T>
  PERCUSS_FORCE_INLINE void find_stress(const T (&e)[3], T (&s)[3]) const {
    const T elastic[3] = {T(q11) * e[0] + T(q12) * e[1], T(q12) * e[0] + T(q22) * e[1], T(2 * g12) * e[2]};
    for (int k = 0; k < 3; ++k) s[k] = elastic[k];
    if (compression_share == 1) return;
    const auto is_taut = (elastic[0] + elastic[1] >= T(0)) & (elastic[0] * elastic[1] >= elastic[2] * elastic[2]);
    const auto is_slack = (e[0] + e[1] <= T(0)) & (e[0] * e[1] >= e[2] * e[2]);
    T field[3] = {T(0), T(0), T(0)};
    if (!all_of(is_taut | is_slack)) find_tension(e, field);
    for (int k = 0; k < 3; ++k) {
      const T left = select(is_taut, elastic[k], select(is_slack, T(0), field[k]));
      s[k] = left + T(compression_share) * (elastic[k] - left);
    }
  }

 private:
  template <class Mask>
  PERCUSS_FORCE_INLINE static bool all_of(const Mask& mask) {
    return !any(!mask);
  }

  /// Directions between warp and weft, closer to the stiffer one.
  void set_samples() {
    const double scale = std::pow(warp_compliance / weft_compliance, 0.25);
    for (int i = 0; i < samples; ++i) {
      const double angle = i * std::acos(-1.0) / (2 * (samples - 1));
      const double c = i == samples - 1 ? 0 : std::cos(angle), s = i == 0 ? 0 : scale * std::sin(angle);
      cosine[i] = c / std::hypot(c, s);
      sine[i] = s / std::hypot(c, s);
    }
  }

  /// Strain along t = (c, s) and how much of it a unit of tension there gives; e: of a first quadrant, e[2] >= 0.
  template <class T>
  PERCUSS_FORCE_INLINE T find_tension_along(const T (&e)[3], const T& c, const T& s) const {
    const T cc = c * c, ss = s * s;
    const T strain = larger(cc * e[0] + T(2) * c * s * e[2] + ss * e[1], T(0));
    return strain / (T(warp_compliance) * cc * cc + T(mixed_compliance) * cc * ss + T(weft_compliance) * ss * ss);
  }
  template <class T>
  PERCUSS_FORCE_INLINE T find_energy_along(const T (&e)[3], const T& c, const T& s) const {
    const T cc = c * c, ss = s * s;
    return find_tension_along(e, c, s) * (cc * e[0] + T(2) * c * s * e[2] + ss * e[1]);
  }

  /// Positive where the energy grows from t towards the weft.
  template <class T>
  PERCUSS_FORCE_INLINE T find_slope_along(const T (&e)[3], const T& c, const T& s) const {
    const double a = warp_compliance, b = weft_compliance, m = 0.5 * mixed_compliance;
    const T cc = c * c, ss = s * s;
    return T(a) * e[2] * cc * cc + (T(a) * e[1] - T(m) * e[0]) * cc * c * s + (T(m) * e[1] - T(b) * e[0]) * c * s * ss -
           T(b) * e[2] * ss * ss;
  }

  /// The stress of a wrinkled sheet: tension along the direction t in which its energy, strain(t)^2 / 2 compliance(t),
  /// is largest. Of the samples and the direction of the largest strain the best is next to that one.
  template <class T>
  PERCUSS_NO_INLINE void find_tension(const T (&given)[3], T (&s)[3]) const {
    const auto turns = given[2] < T(0);
    const T e[3] = {given[0], given[1], select(turns, T(0) - given[2], given[2])};
    T own[2], below[2] = {T(1), T(0)}, above[2] = {T(0), T(1)};
    find_largest_strain(e, own);
    for (int i = 0; i < samples; ++i) {
      const int j = samples - 1 - i;
      const auto is_below =
          T(sine[i]) * own[0]<T(cosine[i]) * own[1], is_above = T(sine[j]) * own[0]> T(cosine[j]) * own[1];
      below[0] = select(is_below, T(cosine[i]), below[0]);
      below[1] = select(is_below, T(sine[i]), below[1]);
      above[0] = select(is_above, T(cosine[j]), above[0]);
      above[1] = select(is_above, T(sine[j]), above[1]);
    }
    T best = find_energy_along(e, own[0], own[1]), low[2], high[2];
    auto rises = find_slope_along(e, own[0], own[1]) > T(0);
    for (int k = 0; k < 2; ++k) {
      low[k] = select(rises, own[k], below[k]);
      high[k] = select(rises, above[k], own[k]);
    }
    for (int i = 0; i < samples; ++i) {
      const int next = i + 1 < samples ? i + 1 : i, last = i > 0 ? i - 1 : i;
      const T c = T(cosine[i]), t = T(sine[i]), energy = find_energy_along(e, c, t);
      const auto is_best = energy > best, grows = find_slope_along(e, c, t) > T(0);
      best = select(is_best, energy, best);
      low[0] = select(is_best, select(grows, c, T(cosine[last])), low[0]);
      low[1] = select(is_best, select(grows, t, T(sine[last])), low[1]);
      high[0] = select(is_best, select(grows, T(cosine[next]), c), high[0]);
      high[1] = select(is_best, select(grows, T(sine[next]), t), high[1]);
      rises = (is_best && grows) || (!is_best && rises);
    }
    set_tension(e, turns, low, high, rises, s);
  }

  /// Largest principal strain and its direction in the first quadrant.
  template <class T>
  PERCUSS_FORCE_INLINE static void find_largest_strain(const T (&e)[3], T (&to)[2]) {
    const T half = T(0.5), difference = half * (e[0] - e[1]);
    const T size = larger(square_root(difference * difference + e[2] * e[2]), T(1e-300));
    to[0] = square_root(larger(half + half * difference / size, T(0)));
    to[1] = square_root(larger(half - half * difference / size, T(0)));
  }

  template <class T, class Mask>
  PERCUSS_FORCE_INLINE void set_tension(const T (&e)[3], const Mask& turns, const T (&low)[2], const T (&high)[2],
                                        const Mask& rises, T (&s)[3]) const {
    const T share = find_crossing(e, low, high, rises);
    T c = low[0] + share * (high[0] - low[0]), t = low[1] + share * (high[1] - low[1]);
    const T over = T(1) / square_root(c * c + t * t);
    c = over * c;
    t = over * t;
    const T tension = find_tension_along(e, c, t);
    s[0] = tension * c * c;
    s[1] = tension * t * t;
    s[2] = select(turns, T(0) - tension, tension) * c * t;
  }

  /// Where between two directions the slope changes its sign, as a share of the way: by false position, halved where
  /// one end stays (the Illinois method). rises: the best known direction is the lower one, and what is not stretched
  /// lies beyond; else it is the upper one. A lane that has converged keeps its value.
  template <class T, class Mask>
  PERCUSS_FORCE_INLINE T find_crossing(const T (&e)[3], const T (&low)[2], const T (&high)[2],
                                       const Mask& rises) const {
    const auto slope = [&](const T& u) {
      const T c = low[0] + u * (high[0] - low[0]), t = low[1] + u * (high[1] - low[1]);
      const T value = find_slope_along(e, c, t), size = larger(value, T(0) - value);
      const auto is_stretched = c * c * e[0] + T(2) * c * t * e[2] + t * t * e[1] > T(0);
      return select(is_stretched, value, select(rises, T(0) - size, size));
    };
    T from(0), to(1), at_from = slope(from), at_to = slope(to), u(0);
    T last(0);  // 1: the lower end moved, -1: the upper
    const T tiny(1e-300);
    for (int i = 0; i < most_iterations; ++i) {
      const auto open = to - from > T(1e-15);
      if (!any(open)) break;
      const T fall = at_from - at_to;
      const T guess = from + (to - from) * select(fall > tiny, at_from / select(fall > tiny, fall, T(1)), T(0.5));
      const T next = i % 4 == 3 ? T(0.5) * (from + to) : guess;
      const T value = slope(next);
      const auto moves_low = open & (value >= T(0)), moves_high = open & (value <= T(0));  // both: found
      at_to = select(moves_low & (last > T(0)), T(0.5) * at_to, at_to);
      at_from = select(moves_high & (last < T(0)), T(0.5) * at_from, at_from);
      from = select(moves_low, next, from);
      at_from = select(moves_low, value, at_from);
      to = select(moves_high, next, to);
      at_to = select(moves_high, value, at_to);
      last = select(moves_low, T(1), select(moves_high, T(-1), last));
      u = select(open, next, u);
    }
    return u;
  }
};

/// Whether a layer is of fabric, which only membranes have.
template <class Material>
inline constexpr bool is_fabric = requires {
  requires Material::is_fabric;
};

}  // namespace percuss
