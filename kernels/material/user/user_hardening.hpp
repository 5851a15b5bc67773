#pragma once
// The yield stress of the user: compiled code with the published VUHARD interface of Abaqus/Explicit, called for the
// points of a pack, and the radial return of percuss. It runs on the host alone.

#include <array>
#include <limits>

#include "kernels/material/lane_copies.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/radial_return.hpp"
#include "kernels/material/user/user_element.hpp"
#include "kernels/material/user/user_fields.hpp"

namespace percuss {

/// Input and output of the user's code for W points. What the code may write ends with numbers that it must not change.
template <int W>
struct VuhardBlock {
  static constexpr int guard = 2 * W;
  static constexpr double mark = -7.0539e212;  // no law gives it

  int elements[W] = {};
  double none[W] = {}, strain[W] = {}, rate[W] = {}, temperature_old[W] = {}, temperature_new[W] = {};
  double state_old[most_user_states * W], state_new[most_user_states * W + guard];
  double yield[W + guard], by_temperature[W + guard], by_strain[2 * W + guard];  // by_strain: by the rate from W on

  VuhardBlock() { state_old[0] = 0; }
  void begin(int states) {
    for (int i = 0; i < W; ++i) yield[i] = std::numeric_limits<double>::quiet_NaN();  // the code must set it
    for (int i = 0; i < W; ++i) by_temperature[i] = by_strain[i] = by_strain[W + i] = 0;
    for (int i = 0; i < states * W; ++i) state_new[i] = state_old[i];
    for (int i = 0; i < guard; ++i)
      yield[W + i] = by_temperature[W + i] = by_strain[2 * W + i] = state_new[states * W + i] = mark;
  }
  bool has_kept_ends(int states) const {
    bool kept = true;
    for (int i = 0; i < guard; ++i)
      kept = kept && yield[W + i] == mark && by_temperature[W + i] == mark && by_strain[2 * W + i] == mark &&
             state_new[states * W + i] == mark;
    return kept;
  }
};

/// Von Mises plasticity whose yield stress is the user's code. It is solved with the strain, the rate and the
/// temperature at the end of the step: rho0 cp dT = share J (mean stress of the step) dp. History: p, T, the user's
/// states; with fields also theirs, the stretch, the number of the element and the edge of a cube of its volume.
struct UserHardening : UserFields {
  static constexpr const char* name = "user_hardening";
  using Constants = UserHardening;

  double youngs_modulus = 0, poissons_ratio = 0;
  UserCode code;
  MaterialNumbers constants, start_states;
  MaterialText called;
  int states = 0;
  int deletes = 0;  // which of the states; 0: none
  double start_temperature = 0, specific_heat = 0, heating_share = 0.9;
  double thermal_expansion = 0;
  double room_temperature = 293.15, melt_temperature = 0;  // for criteria of failure alone

  static constexpr auto keys() {
    using M = UserHardening;
    return with_elastic_keys<M>(
        need("vuhard", &M::code, "The shared library with the compiled VUHARD; --allow-library must name it too."),
        may("constants", &M::constants, "PROPS of the VUHARD, in their order."),
        may("state_variables", &M::states, most_user_states, "NSTATEV of the VUHARD; they begin with 0."),
        may("start_states", &M::start_states, "State variables at the start, from the first; the others begin with 0."),
        may("delete_variable", &M::deletes, most_user_states,
            "The state variable, counted from 1, that the VUHARD sets to 0 to delete a point; it begins with 1."),
        may("vuhard_name", &M::called, "CMNAME of the VUHARD, in capitals: for code with several laws."),
        may<M>(
            "field_variables", &M::fields, most_user_fields,
            "How many fields the VUSDFLD of the same library sets before the VUHARD is called; 0: it is not called."),
        may<M>("field_constants", &M::field_constants, "PROPS of the VUSDFLD, in their order."),
        may("start_temperature", &M::start_temperature, KeyRange::any, "temperature", "Temperature at the start."),
        may("specific_heat", &M::specific_heat, KeyRange::not_negative, "energy / mass / temperature",
            "Heat that a unit of mass takes for a degree; 0: plastic work does not heat."),
        may("heating_share", &M::heating_share, KeyRange::share, "-", "Share of the plastic work that heats."),
        may("thermal_expansion", &M::thermal_expansion, KeyRange::not_negative, "1 / temperature",
            "Strain of a length by a degree."),
        may("room_temperature", &M::room_temperature, KeyRange::any, "temperature",
            "Where the temperature of d5 of failure.johnson_cook is 0."),
        may("melt_temperature", &M::melt_temperature, KeyRange::not_negative, "temperature",
            "Where it is 1; 0: none is given."));
  }

  /// What is wrong between constants; empty: nothing.
  const char* find_fault() const {
    if (start_states.count > states) return "more start_states than state_variables";
    if (field_constants.count > 0 && fields == 0) return "field_constants and no field_variables";
    if (thermal_expansion > 0 && specific_heat == 0)
      return "a thermal_expansion and no specific_heat, by which it heats";
    return melt_temperature == 0 || melt_temperature > room_temperature
               ? ""
               : "a melt_temperature that is not above its room_temperature";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain,
                                                    HistoryScalar::temperature};
  static constexpr int own_history = 2;
  static constexpr int history_count = most_law_history;
  static constexpr bool grows_in_increments = true;
  static constexpr bool changes_at_rest = true;  // the code gets the time
  int first_field() const { return own_history + states; }
  /// Where the place of the point is kept, in the history of the law; -1: nowhere.
  int find_place() const { return fields > 0 ? first_field() + fields : -1; }
  int find_stretch() const { return first_field() + (fields > 0 ? count_field_history() : 0); }
  int count_history() const { return find_stretch() + (fields > 0 ? StretchHistory::count + 2 : 0); }
  void start(double* history) const {
    history[1] = start_temperature;
    if (fields > 0) StretchHistory::start(history + find_stretch());
    for (int i = 0; i < start_states.count; ++i) history[own_history + i] = start_states.value[i];
    if (deletes > 0) history[find_deletion()] = 1;
  }
  bool needs_elements() const { return fields > 0; }
  void start_element(const UserElement& element, double* history) const {
    double* const own = history + find_stretch() + StretchHistory::count;
    start_place(element.place, history + first_field());
    own[0] = element.id;
    own[1] = element.length;
  }
  static int first_state() { return own_history; }
  int count_states() const { return states; }
  /// Place of the state that deletes a point, in the history of the law; -1: none.
  int find_deletion() const { return deletes > 0 ? own_history + deletes - 1 : -1; }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Yield stress at a plastic strain and rate, at time 0 and the temperature at the start.
  double find_first_yield(double strain, double rate) const {
#ifdef PERCUSS_ON_DEVICE
    return strain + rate;
#else
    double history[most_law_history] = {};
    start(history);
    PointStep<double> step{};
    step.motion.dt = rate > 0 ? strain / rate : 1e-6;
    step.motion.volume_ratio = 1;
    step.history = history;
    Code<double> asked(*this, step);
    return asked.ask(strain, start_temperature).yield;
#endif
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
#ifndef PERCUSS_ON_DEVICE
    if (!(sum_lanes(step.motion.dt) > 0)) return;  // the forces at the start: there is no rate
    return_by_code(step);
#else
    (void)step;
#endif
  }

 private:
  /// Answer of the code.
  template <class T>
  struct Answer {
    T yield, by_strain, by_rate, by_temperature;
  };

  /// The code in a step of some points.
  template <class T>
  struct Code {
    static constexpr int w = lane_count<T>;
    const UserHardening& law;
    const double time;
    const T strain, dt;
    VuhardBlock<w> block;
    FieldBlock<w> field;
    bool has_kept_ends = true;  // of what the VUSDFLD may write

    Code(const UserHardening& of, const PointStep<T>& step)
        : law(of), time(step.motion.time), strain(step.history[0]), dt(step.motion.dt) {
      write_lanes(step.history[1], block.temperature_old);
      for (int i = 0; i < law.states; ++i) write_lanes(step.history[own_history + i], block.state_old + i * w);
      if (law.fields > 0) set_fields(step);
    }

    /// Sets the fields by the VUSDFLD, which also changes state variables before the VUHARD gets them.
    void set_fields(const PointStep<T>& step) {
      T* const stretch = step.history + law.find_stretch();
      const T* const element = stretch + StretchHistory::count;
      FieldPoints<T> points;
      points.stress = step.stress;
      points.stretch = StretchHistory::load(stretch);
      points.temperature = step.history[1];
      points.plastic_strain = strain;
      points.has_plastic_strain = true;
      points.states = law.states;
      double id[w], length[w], steps[w];
      write_lanes(element[0], id);
      for (int i = 0; i < w; ++i) block.elements[i] = static_cast<int>(id[i]);
      write_lanes(T(element[1] * power(step.motion.volume_ratio, 1.0 / 3.0)), length);
      write_lanes(dt, steps);
      block.begin(law.states);
      law.find_fields({law.code, law.called, law.code.find_step_time(time), time, steps, length,
                       identity_matrix<double>(), block.elements, block.state_old, block.state_new},
                      points, step.history + law.first_field(), field);
      has_kept_ends = block.has_kept_ends(law.states) && field.has_kept_ends(law.fields);
      StretchHistory::store(advance_stretch(points.stretch, step.motion), stretch);
    }

    /// The yield stress after dp, and its slopes.
    Answer<T> ask(const T& dp, const T& temperature) {
      write_lanes(strain + dp, block.strain);
      write_lanes(dp / dt, block.rate);
      write_lanes(temperature, block.temperature_new);
      block.begin(law.states);
      const int points = w, first = 1, none = 0;
      const double *const before = law.fields > 0 ? field.before : block.none, *const now = law.fields > 0 ? field.now
                                                                                                           : block.none;
      double length[w];
      write_lanes(dt, length);
      const double step_time = law.code.find_step_time(time);
      call_library(law.code.file, [&] {
        law.code.vuhard(&points, block.elements, &first, &first, &first, &none, &step_time, &time, length,
                        law.called.text, &law.states, &law.fields, &law.constants.count, law.constants.value,
                        block.temperature_old, block.temperature_new, before, now, block.state_old, block.strain,
                        block.rate, block.yield, block.by_temperature, block.by_strain, block.state_new,
                        MaterialText::most);
      });
      return {read_lanes<T>(block.yield), read_lanes<T>(block.by_strain), read_lanes<T>(block.by_strain + w),
              read_lanes<T>(block.by_temperature)};
    }
  };

  template <class T>
  PERCUSS_NO_INLINE void return_by_code(PointStep<T>& step) const {
    const LameConstants c = moduli();
    const double resistance = 3 * c.mu;
    const T degrees =
        T(specific_heat > 0 ? heating_share / (step.density * specific_heat) : 0) * step.motion.middle_volume_ratio();
    const Symmetric3<T> start = add_pressure(step.stress, T(-1.0 / 3.0) * trace(step.stress));
    const T temperature = step.history[1];
    const ElasticTrial<T> trial = find_trial(c, step.stress, step.motion.de);
    Code<T> asked(*this, step);
    Answer<T> answer = asked.ask(T(0), temperature);
    // Where the point begins to yield within the step, plastic strain begins at the yield stress.
    const T before = larger(square_root(T(1.5) * contract(start, start)), answer.yield);
    const auto yields = trial.von_mises > answer.yield;
    T dp(0), flow_stress = answer.yield;
    const auto heat = [&](const T& strain) {
      return T(0.5) * degrees * (before + trial.von_mises - T(resistance) * strain) * strain;
    };
    if (any(yields)) {
      const T high = select(yields, trial.von_mises * T(1 / resistance), T(1));
      dp = find_falling_root<3>(yields, high, trial.von_mises, [&](const T& strain) {
        const T stress = trial.von_mises - T(resistance) * strain;
        const Answer<T> now = asked.ask(strain, temperature + heat(strain));
        const T hotter = T(0.5) * degrees * (before + stress - T(resistance) * strain);
        return ValueAndSlope<T>{stress - now.yield, T(-resistance) - now.by_strain - now.by_rate / step.motion.dt -
                                                        now.by_temperature * hotter};
      });
      answer = asked.ask(dp, temperature + heat(dp));
      flow_stress = select(yields, trial.von_mises - T(resistance) * dp, flow_stress);
    }
    return_stress(trial, resistance, dp, flow_stress, step);
    expand(c, thermal_expansion, heat(dp), step.stress);
    keep(asked, answer.yield, dp, temperature + heat(dp), step);
  }

  /// Stores what a step has left. A yield stress that is no number ends the run, as does code that writes elsewhere.
  template <class T>
  void keep(const Code<T>& asked, const T& yield, const T& dp, const T& temperature, PointStep<T>& step) const {
    const auto& block = asked.block;
    T* const own = step.history;
    own[0] = own[0] + dp;
    own[1] = temperature;
    T remained = deletes > 0 ? own[find_deletion()] : T(1);
    if (deletes > 0 && fields > 0)
      remained = smaller(remained, read_lanes<T>(block.state_old + (deletes - 1) * lane_count<T>));
    for (int i = 0; i < states; ++i) own[own_history + i] = read_lanes<T>(block.state_new + i * lane_count<T>);
    if (deletes > 0) end_deleted(remained, own[find_deletion()], step.stress);
    const bool kept = block.has_kept_ends(states) && asked.has_kept_ends;
    if (!kept) __atomic_store_n(code.has_written_outside, 1, __ATOMIC_RELAXED);
    require_finite(own, count_history(), step.stress);
    const auto is_number = (yield > T(-1e300)) & (yield < T(1e300)) & (T(kept ? 1.0 : 0.0) > T(0));
    step.stress.xx = select(is_number, step.stress.xx, T(std::numeric_limits<double>::quiet_NaN()));
  }
};

}  // namespace percuss
