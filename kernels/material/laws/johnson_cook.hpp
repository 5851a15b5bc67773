#pragma once
// Johnson-Cook plasticity (Johnson and Cook, 7th Int. Symp. Ballistics, 1983), heated by its own plastic work.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// Flow stress (A + B p^n) (1 + C ln r) (1 - t^m), r = max(rate of p / reference_rate, 1), t = (T - T_room) / (T_melt -
/// T_room) between 0 and 1; at t = 1 nothing of it is left. No heat is conducted: rho0 cp dT = beta J sigma dp. The
/// flow stress of a step takes the temperature of its beginning, its heat the mean flow stress. With an equation of
/// state p(J, e) compression heats it too: dT = -T_abs dp/de dJ without heat (Maxwell's relation), and rho0 cp dT = -q
/// dJ by the viscous pressure, which stands for the shock. History: p, T.
struct JohnsonCook {
  static constexpr const char* name = "johnson_cook";
  using Constants = JohnsonCook;
  double youngs_modulus = 0, poissons_ratio = 0;
  double a = 0, b = 0, n = 1, c = 0, m = 1;
  double reference_rate = 1;
  double start_temperature = 293.15, room_temperature = 293.15, melt_temperature = 0;
  double specific_heat = 0, heating_share = 0.9;
  double absolute_zero = 0;
  double thermal_expansion = 0;

  static constexpr auto keys() {
    using M = JohnsonCook;
    return with_elastic_keys<M>(
        need("a", &M::a, KeyRange::positive, "pressure", "A of the flow stress (A + B p^n) (1 + C ln r) (1 - t^m)."),
        need("b", &M::b, KeyRange::not_negative, "pressure", "B of the flow stress; see a."),
        need("n", &M::n, KeyRange::positive, "-", "n of the flow stress; see a."),
        may("c", &M::c, KeyRange::not_negative, "-", "C of the flow stress; see a."),
        may("reference_rate", &M::reference_rate, KeyRange::positive, "1 / time",
            "Rate of plastic strain that r is counted in; r is at least 1."),
        may("m", &M::m, KeyRange::positive, "-", "m of the flow stress; see a."),
        need("melt_temperature", &M::melt_temperature, KeyRange::positive, "temperature",
             "Where t = 1: the flow stress is gone."),
        may("room_temperature", &M::room_temperature, KeyRange::any, "temperature", "Where t = 0."),
        may("start_temperature", &M::start_temperature, KeyRange::any, "temperature", "Temperature at the start."),
        need("specific_heat", &M::specific_heat, KeyRange::positive, "energy / mass / temperature",
             "Heat that a unit of mass takes for a degree."),
        may("heating_share", &M::heating_share, KeyRange::share, "-", "Share of the plastic work that heats."),
        may("absolute_zero", &M::absolute_zero, KeyRange::any, "temperature",
            "Absolute zero, -273.15 where temperatures are in degrees Celsius; compression under an equation of state "
            "heats from there."),
        may("thermal_expansion", &M::thermal_expansion, KeyRange::not_negative, "1 / temperature",
            "Strain of a length by a degree."));
  }

  /// What is wrong between constants; empty: nothing.
  const char* find_fault() const {
    if (melt_temperature <= room_temperature) return "a melt_temperature that is not above its room_temperature";
    return melt_temperature > start_temperature ? "" : "a melt_temperature that is not above its start_temperature";
  }

  /// Likewise with an equation of state. The limit is below what anyone cools to, and above Celsius' rooms.
  const char* find_fault_with_state() const {
    constexpr double coldest = 70;
    if (thermal_expansion > 0) return "a thermal_expansion beside an equation_of_state, which expands by itself";
    return start_temperature - absolute_zero > coldest
               ? ""
               : "a start_temperature less than 70 above its absolute_zero, from which an equation_of_state heats by "
                 "compression: absolute_zero is -273.15 for degrees Celsius";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain,
                                                    HistoryScalar::temperature};
  static constexpr int history_count = 2;
  static constexpr bool takes_equation_of_state = true;

  void start(double* history) const { history[1] = start_temperature; }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// 1 - t^m.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_softening(const T& temperature) const {
    const T t =
        smaller(larger((temperature - T(room_temperature)) * T(1 / (melt_temperature - room_temperature)), T(0)), T(1));
    return T(1) - power(t, m);
  }

  /// Flow stress over a step as a function of dp.
  template <class T>
  struct Flow {
    const JohnsonCook& law;
    T p, softening, over_rate;
    T at_rest;

    KOKKOS_INLINE_FUNCTION FlowStress<T> operator()(const T& dp) const {
      const T hardening = T(law.b) * power(p + dp, law.n), strain = larger(dp, T(1e-300));
      const T yield = (T(law.a) + hardening) * softening;
      const T slope = T(law.n) * hardening / larger(p + dp, T(1e-300)) * softening;
      const T rate = strain * over_rate;
      const T faster = T(1) + T(law.c) * logarithm(larger(rate, T(1)));
      return FlowStress<T>{yield * faster, slope * faster + select(rate > T(1), yield * T(law.c) / strain, T(0))};
    }
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION Flow<T> start_flow(const T* history, const T& dt) const {
    const T p = history[0], softening = find_softening(history[1]);
    const T at_rest = (T(a) + T(b) * power(p, n)) * softening;
    return {*this, p, softening, T(1) / larger(T(reference_rate) * dt, T(1e-300)), at_rest};
  }

  /// Heats by the plastic work of dp. stress: Kirchhoff stress J sigma, the mean of the step; density: at the start.
  template <class T>
  KOKKOS_INLINE_FUNCTION void heat(T* history, const T& dp, const T& stress, double density) const {
    history[1] = history[1] + T(heating_share / (density * specific_heat)) * stress * dp;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const T before = step.history[1];
    return_by_isotropic_hardening(*this, step);
    expand(moduli(), thermal_expansion, step.history[1] - before, step.stress);
  }

  /// The temperature after a change of volume under an equation of state: that of the isentrope, exactly where dp/de is
  /// constant, and the heat of the viscous pressure.
  template <class T>
  KOKKOS_INLINE_FUNCTION void compress(const StateChange<T>& change, PointStep<T>& step) const {
    const T zero(absolute_zero), at_rest = exponential(-change.by_energy * change.volume);
    step.history[1] = zero + (step.history[1] - zero) * at_rest -
                      T(1 / (step.density * specific_heat)) * step.motion.viscosity * change.volume;
  }
};

}  // namespace percuss
