#pragma once
// Layers in plane stress of every material whose flow stress depends on the equivalent plastic strain, its rate and the
// temperature: the solid's own laws, returned to a yield surface without stress across the layer.

#include "kernels/material/laws/materials.hpp"
#include "kernels/shell/moving_surface.hpp"

namespace percuss {

/// The multiplier l with s_e(l) = flow(l s_e(l)); 0 where the trial is not above flow.at_rest. Where the flow stress
/// does not fall with dp, l is at most where s_e has fallen to flow.at_rest, for which the slower of its two parts
/// gives a bound; a table that falls is seen one step later. A flow that may fall names its lowest value.
template <class T, class Flow>
PERCUSS_FORCE_INLINE T find_plane_multiplier(const PlaneReturnRates& rates, const PlaneTrial<T>& trial,
                                             const Flow& flow) {
  constexpr double next_to_molten = 1e-12;  // share of the trial's equivalent stress
  const auto [k_normal, k_shear] = rates;
  const T start = square_root(trial.normal + trial.shear);
  const auto yields = start > flow.at_rest;
  if (!any(yields)) return T(0);
  const T floor = select(yields, larger(find_floor(flow), T(next_to_molten) * start), T(1));
  const T high = select(yields, (start - floor) / (T(smaller(k_normal, k_shear)) * floor), T(1));
  return find_falling_root<halving_of<Flow>>(yields, high, start, [&, kn = k_normal, ks = k_shear](const T& l) {
    const T a = T(1) / (T(1) + T(kn) * l), b = T(1) / (T(1) + T(ks) * l);
    const T normal = trial.normal * a * a, shear = trial.shear * b * b;
    const T equivalent = larger(square_root(normal + shear), T(1e-300));
    const T slope = -(T(kn) * a * normal + T(ks) * b * shear) / equivalent;
    const FlowStress<T> now = flow(l * equivalent);
    return ValueAndSlope<T>{equivalent - now.value, slope - now.slope * (equivalent + l * slope)};
  });
}

/// Scalars that a layer of a law remembers.
template <class Law>
constexpr int count_plane_history() {
  if constexpr (requires { Law::plane_history_count; })
    return Law::plane_history_count;
  else
    return Law::history_count;
}

template <class Law>
struct IsFlowLaw : std::bool_constant<FlowLaw<Law>> {};

/// A layer of any of these laws, called through its number: one compiled shell serves them all. History: that of the
/// law, p first. Of a law whose yield surface moves, the back stress in the plane follows: b, whose deviator is the
/// solid's a, by xx, yy, xy. It moves by db = K l (s - b), which adds K, the kinematic modulus, to both rates at which
/// the trial about b falls (Simo and Hughes 1998, section 3.4). A law with several back stresses has its own return.
struct HardeningLayer {
  using Laws = FilterList<Materials, IsFlowLaw>::type;
  static constexpr int most_history = Chaboche::plane_history_count;
  static constexpr bool can_yield = true;
  PlaneElasticity elasticity;
  double density = 0;
  int law_history = 0;  // scalars
  AnyOf<4096> law;

  template <class Law>
  static HardeningLayer make(const Law& law, const PlaneElasticity& elasticity, double density) {
    static_assert(count_plane_history<Law>() <= most_history);
    HardeningLayer layer{elasticity, density, count_plane_history<Law>(), {}};
    set_any_of(layer.law, Laws(), law);
    return layer;
  }

  KOKKOS_INLINE_FUNCTION int count_history() const { return law_history; }

  /// The history at the start. history: out, [count_history()].
  void start(double* history) const {
    for (int k = 0; k < law_history; ++k) history[k] = 0;
    visit_any_of(law, Laws(), [&](const auto& one) {
      if constexpr (requires { one.start(history); }) one.start(history);
    });
  }

  template <class T>
  PERCUSS_FORCE_INLINE LayerResponse<T> update(T (&stress)[3], T* history, const T (&de)[3], const T& dt) const {
    LayerResponse<T> response{};
    visit_any_of(law, Laws(), [&](const auto& one) { response = update_by(one, stress, history, de, dt); });
    return response;
  }

 private:
  /// The function that each law is compiled as. Between the two branches `stress` is s - b.
  template <class T, class Law>
  PERCUSS_NO_INLINE LayerResponse<T> update_by(const Law& one, T (&stress)[3], T* history, const T (&de)[3],
                                               const T& dt) const {
    if constexpr (requires { one.back_stresses; }) return return_about_terms(elasticity, one, stress, history, de, dt);
    constexpr bool moves = requires { one.kinematic_modulus(); };
    PlaneReturnRates rates = find_return_rates(elasticity);
    [[maybe_unused]] T* const back = history + 1;
    if constexpr (moves) {
      static_assert(count_plane_history<Law>() == 4, "p and the back stress by xx, yy, xy");
      rates.normal += one.kinematic_modulus();
      rates.shear += one.kinematic_modulus();
      for (int k = 0; k < 3; ++k) stress[k] = stress[k] - back[k];
    }
    const T before = square_root(stress[0] * stress[0] - stress[0] * stress[1] + stress[1] * stress[1] +
                                 T(3) * stress[2] * stress[2]);
    const PlaneTrial<T> trial = find_plane_trial(elasticity, stress, de);
    const auto flow = one.start_flow(history, dt);
    const T multiplier = find_plane_multiplier(rates, trial, flow);
    const T secant = find_secant_share(elasticity, T(flow.at_rest), history[0]);
    const PlaneReturn<T> to = return_in_plane(elasticity, rates, trial, multiplier, stress);
    const T dp = multiplier * to.equivalent;
    history[0] = history[0] + dp;
    if constexpr (requires { one.heat(history, dp, dp, density); }) {
      one.heat(history, dp, T(0.5) * (larger(before, T(flow.at_rest)) + to.equivalent), density);
    }
    LayerResponse<T> response = to.response;
    response.secant = secant;
    if constexpr (moves) {
      const T move = T(one.kinematic_modulus()) * multiplier;
      // What the change of b adds to the elastic strain across.
      const T lateral = T(-elasticity.poissons_ratio / elasticity.youngs_modulus) * move;
      response.across = response.across + lateral * (stress[0] + stress[1]);
      response.share = response.share * (T(1) + move);
      for (int k = 0; k < 3; ++k) {
        back[k] = back[k] + move * stress[k];
        stress[k] = stress[k] + back[k];
      }
    }
    return response;
  }
};

}  // namespace percuss
