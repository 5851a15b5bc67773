#pragma once
// Fibres of every law with a flow stress that depends on the equivalent plastic strain, its rate and the temperature:
// the solid's own laws under a normal stress alone. Formulas: docs/theory_line_elements.md.

#include <cmath>

#include "kernels/material/laws/materials.hpp"

namespace percuss {

/// A law that beams have: linear, or one with a flow stress.
template <class Law>
concept BeamLaw = LawOfFibres<Law> || FlowLaw<Law>;

template <class Law>
struct IsFibreLaw : std::bool_constant<FlowLaw<Law>> {};
using FibreLaws = FilterList<Materials, IsFibreLaw>::type;

/// Data of a step that the fibres of a section share.
struct FibreStep {
  double youngs_modulus = 0, density = 0, dt = 0;
};

/// Scalars that a fibre of a law remembers: p, then one for each component of a back stress, or the temperature.
template <class Law>
constexpr int count_fibre_history() {
  if constexpr (requires { &Law::back_stresses; })
    return 1 + BackStresses::most;
  else if constexpr (requires(const Law& law) { law.kinematic_modulus(); })
    return 2;
  else
    return Law::history_count;
}
inline constexpr int most_fibre_history = 1 + BackStresses::most;

/// The stress after a strain, about a back stress that moves by the law's kinematic modulus, if it has one. The plastic
/// increment takes E from the stress for each unit; history: p, then the back stress or the temperature.
template <class Law>
KOKKOS_INLINE_FUNCTION double advance_fibre(const Law& law, const FibreStep& step, double stress, double strain,
                                            double* history) {
  constexpr bool moves = requires { law.kinematic_modulus(); };
  double back = 0, modulus = 0;
  if constexpr (moves) back = history[1], modulus = law.kinematic_modulus();
  const double trial = stress - back + step.youngs_modulus * strain, size = std::fabs(trial);
  const auto flow = law.start_flow(history, step.dt);
  const double resistance = step.youngs_modulus + modulus;
  const double dp = find_plastic_increment(size, resistance, flow);
  const double after = size - resistance * dp;
  history[0] += dp;
  if constexpr (moves) history[1] = back + std::copysign(modulus * dp, trial);
  double next = back + std::copysign(after + modulus * dp, trial);
  if constexpr (requires { law.heat(history, dp, dp, 1.0); }) {
    const double before = history[1];
    law.heat(history, dp, 0.5 * (std::fabs(stress) + larger(after, flow.at_rest)), step.density);
    next -= step.youngs_modulus * law.thermal_expansion * (history[1] - before);
  }
  return next;
}

/// What several back stresses leave of a trial after dp, and its slope by dp.
KOKKOS_INLINE_FUNCTION ValueAndSlope<double> find_about_terms(const MaterialTable& terms, const double* back,
                                                              double trial, double dp) {
  ValueAndSlope<double> about{trial, 0};
  for (int k = 0; k < terms.rows; ++k) {
    const double kept = BackStresses::keep(terms.x[k], dp);
    about.value -= kept * back[k];
    about.slope += terms.x[k] * kept * kept * back[k];
  }
  return about;
}

/// Likewise about several back stresses that recover. history: p, then those of the terms.
KOKKOS_INLINE_FUNCTION double advance_fibre(const Chaboche& law, const FibreStep& step, double stress, double strain,
                                            double* history) {
  const MaterialTable& terms = law.back_stresses;
  const double young = step.youngs_modulus, trial = stress + young * strain;
  double* const back = history + 1;
  const auto flow = law.start_flow(history, step.dt);
  const double start = std::fabs(find_about_terms(terms, back, trial, 0).value);
  if (!(start > flow.at_rest)) return trial;
  const double high = (start - flow.lowest) / young;
  const double dp = find_falling_root<BackStresses::halving>(true, high, start, [&](double x) {
    const ValueAndSlope<double> about = find_about_terms(terms, back, trial, x);
    const ValueAndSlope<double> modulus = BackStresses::find_modulus(terms, x);
    const FlowStress<double> now = flow(x);
    return ValueAndSlope<double>{std::fabs(about.value) - (young + modulus.value) * x - now.value,
                                 std::copysign(1.0, about.value) * about.slope - young - modulus.slope - now.slope};
  });
  const double along = std::copysign(dp, find_about_terms(terms, back, trial, dp).value);
  for (int k = 0; k < terms.rows; ++k) back[k] = BackStresses::keep(terms.x[k], dp) * (back[k] + terms.y[k] * along);
  history[0] += dp;
  return trial - young * along;
}

/// A law of the list, the same for all fibres of a section.
struct CalledFibreLaw {
  AnyOf<4096> law;
  double density = 0;
  int history_count = 0;  // scalars of a fibre; 0: no law, the fibres are linear
  double start[most_fibre_history] = {};

  template <class Law>
  static CalledFibreLaw make(const Law& law, double density) {
    static_assert(count_fibre_history<Law>() <= most_fibre_history);
    CalledFibreLaw made;
    set_any_of(made.law, FibreLaws(), law);
    made.density = density;
    made.history_count = count_fibre_history<Law>();
    if constexpr (requires { law.start(made.start); }) law.start(made.start);
    return made;
  }
};

}  // namespace percuss
