#pragma once
// Failure state of elements: what elements of materials that can fail store besides their records.
//
// An element that meets a criterion fails: its force falls to zero in equal parts over the next evaluations, one or
// more, and then it is eroded. With an evolution or a coupling of damage it keeps a share of its force. The work of a
// step uses the mean of the factors at its ends, the trapezoid of the audit: the booked work is what the element has
// absorbed. Only chunks whose material can fail have entries.

#include <cstddef>
#include <limits>

#include "kernels/core/precision.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"
#include "kernels/core/work_kinds.hpp"
#include "kernels/material/material_table.hpp"

namespace percuss {

/// Johnson-Cook failure strain (d1 + d2 exp(d3 s)) (1 + d4 ln(rate / reference)) (1 + d5 T), s: mean over von Mises
/// stress; without d1 and d2: none.
struct JohnsonCookDamage {
  double d1 = 0, d2 = 0, d3 = 0, d4 = 0, d5 = 0;
  double reference_rate = 1;

  KOKKOS_INLINE_FUNCTION bool any() const { return d1 != 0 || d2 != 0; }
};

/// How damage grows after its onset with the plastic strain. Damage is 1 at the onset and 2 where no force is left; the
/// force in between falls along a straight line, an exponential or a table.
struct DamageEvolution {
  double by_strain = 0;  // for each plastic strain: the size of the element over the displacement until failure
  double by_work = 0;    // for each plastic strain and von Mises stress: share of force that is left, summed until
                         // failure, times the size over the energy by area
  double exponent = 0;   // a in a share of force (exp(-a p) - exp(-a)) / (1 - exp(-a)) at the progress p; 0: 1 - p
  const MaterialTable* lost = nullptr;  // share of force that is lost over the progress from 0 to 1; none: as above

  KOKKOS_INLINE_FUNCTION bool any() const { return by_strain > 0 || by_work > 0; }
};

/// How force falls before failure: the share ((D - D0) / (1 - D0))^fade of it is lost at a damage D above D0. D is the
/// sum of the damage to a power; D0 is given, or what D is where another sum over the plastic strain reaches 1.
/// Source: Neukamm, Feucht and Haufe, Considering damage history in crashworthiness simulations, 7th European LS-DYNA
/// Conference (2009).
struct DamageCoupling {
  const MaterialTable* strain = nullptr;  // of that other sum: the plastic strain over mean by von Mises stress
  double start = -1;                      // D0 without it; negative: none
  double damage_exponent = 1, fade_exponent = 1;

  KOKKOS_INLINE_FUNCTION bool any() const { return strain != nullptr || start >= 0; }
};

/// Failure by shear: plastic strain over (von Mises stress - pressure_factor mean stress) / largest shear stress.
struct ShearDamage {
  const MaterialTable* strain = nullptr;  // none: no criterion
  double pressure_factor = 0;
};

/// When an element of a material fails; a limit that is not set is infinite.
struct FailureLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double plastic_strain = none;    // equivalent
  double principal_stress = none;  // largest
  double principal_strain = none;  // largest logarithmic
  double thinning = none;          // of a layer of a shell, logarithmic
  double mean_thinning = none;     // over the thickness of a shell
  double compressibility = 0;      // volume strain over the sum of the normal stresses, for these two
  double tension = none;           // of the mean stress
  double yield_time = none;        // at yield, in all
  JohnsonCookDamage johnson_cook;
  double room_temperature = 0, melt_temperature = 0;  // where T is 0 and 1; equal: T is 0
  double least_step = 0;        // a smaller bound of its own takes an element out at once; 0: none
  bool takes_inverted = false;  // so does no positive volume
  bool of_element = false;      // of one element of the size that it has: the next row is that of the next element
  int fade_steps = 1;           // evaluations until a failed element, or layer of a shell, has no force
  double layers = 1;            // of a shell: share of the thickness that has to fail; of a beam, of the section
  double least_volume = 0;      // V / V(0)
  double most_volume = none;
  double fibre_damage = none;                  // of a ply of a shell
  const MaterialTable* triaxiality = nullptr;  // failure strain over mean by von Mises stress; none: no criterion
  ShearDamage shear;
  const MaterialTable* rate_factor =
      nullptr;                // of these strains and of that of `coupling`, over the plastic strain rate
  double strain_factor = 1;   // of the failure strains of both
  DamageEvolution evolution;  // none: an element fails at the onset of damage
  DamageCoupling coupling;    // none: it has its whole force up to there

  /// Whether damage adds up over the strain.
  KOKKOS_INLINE_FUNCTION bool adds_damage() const {
    return johnson_cook.any() || triaxiality != nullptr || shear.strain != nullptr;
  }
  /// Whether force is lost by damage.
  KOKKOS_INLINE_FUNCTION bool softens() const { return evolution.any() || coupling.any(); }
  /// Damage of an element without force.
  KOKKOS_INLINE_FUNCTION double whole_damage() const { return evolution.any() ? 2 : 1; }
  KOKKOS_INLINE_FUNCTION bool reads_stress() const {
    return tension < none || principal_stress < none || adds_damage() || evolution.by_work > 0;
  }
  KOKKOS_INLINE_FUNCTION bool reads_stretch() const { return principal_strain < none; }
  KOKKOS_INLINE_FUNCTION bool reads_volume() const { return least_volume > 0 || most_volume < none; }

  /// With failure strains times a factor.
  KOKKOS_INLINE_FUNCTION FailureLimits scale_strains(double factor) const {
    FailureLimits scaled = *this;
    scaled.plastic_strain *= factor;
    scaled.principal_strain *= factor;
    scaled.thinning *= factor;
    scaled.mean_thinning *= factor;
    scaled.johnson_cook.d1 *= factor;
    scaled.johnson_cook.d2 *= factor;
    scaled.strain_factor *= factor;
    return scaled;
  }
};

/// The chunks that can fail; const after set-up.
struct FailingChunks {
  Array<int> list;        // chunks, ascending
  Array<int> first_pack;  // [chunks of the rank] place of its first pack among those that can fail, -1: cannot; empty:
                          // no chunk can
  Array<int> row;         // [chunks of the rank] of `limits`: of the material, or of the first element
  Kokkos::View<FailureLimits*, MemSpace> limits;
  Kokkos::View<MaterialTable*, MemSpace> tables;  // to which limits point
  int pack_count = 0;
  Array<std::size_t> first_layer;  // [chunks of the rank] place in ElementLives::layers of shells; empty: none can fail
  std::size_t layer_scalars = 0;   // of ElementLives::layers

  KOKKOS_INLINE_FUNCTION int find_pack(int chunk) const {
    return first_pack.extent(0) == 0 ? -1 : first_pack(static_cast<std::size_t>(chunk));
  }

  /// Limits of element i of a chunk that can fail.
  KOKKOS_INLINE_FUNCTION const FailureLimits& find_limits(int chunk, int i) const {
    const int first = row(chunk);
    return limits(first + (limits(first).of_element ? i : 0));
  }
};

/// What the lanes of their packs carry; lanes past the end repeat the last element. State.
struct ElementLives {
  static constexpr int whole = -1;
  static constexpr double dead = -1;

  Array<Real> force_share;       // [lanes] share of the force at the next evaluation; `dead`
  Array<Real> work_share;        // [lanes] share of the work of the step up to there
  Array<double> work;            // [packs][work_kinds][W] put in since the start
  Array<int> steps_left;         // [lanes] evaluations until the force is gone; `whole`; 0: dead
  Array<double> plastic_strain;  // [lanes] at n
  Array<double> damage;          // [lanes] at n; 1: failed, or at its onset where it evolves; 2: failed there
  Array<double> second;          // [lanes] at n: FailureHistory::second
  Array<double> layers;          // of shells (kernels/shell/layer_lives.hpp); of them the three above are means
};

/// The elements that can fail: their chunks, the records of all elements at n+1, and their lives, in and out.
struct FailingElements {
  FailingChunks chunks;
  Array<Real> records;
  ElementLives lives;
};

/// What counts of an element in the step to its next evaluation.
struct LifeShares {
  double now = 1;    // of its force at n
  double force = 1;  // at the next evaluation
  double work = 1;   // of the step up to there
};

/// The shares of an element with so many evaluations left.
KOKKOS_INLINE_FUNCTION LifeShares find_life_shares(int left, int fade_steps) {
  if (left == ElementLives::whole) return {};
  if (left == 0) return {0, ElementLives::dead, 0};
  const double now = static_cast<double>(left) / fade_steps, next = static_cast<double>(left - 1) / fade_steps;
  return {now, next, 0.5 * (now + next)};
}

}  // namespace percuss
