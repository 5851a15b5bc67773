#pragma once
// A law of the user: compiled code with the published VUMAT interface of Abaqus/Explicit, called for the points of a
// pack. It runs on the host alone.

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

#include "kernels/material/elastic.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// Input and output of the user's code for W points. What the code may write ends with numbers that it must not change.
template <int W, int MostStates>
struct VumatBlock {
  static constexpr int guard = 2 * W;
  static constexpr double mark = -7.0539e212;  // no law gives it

  double places[3 * W] = {}, length[W], density[W], strain[6 * W], spin[3 * W] = {}, none[W] = {};
  double stretch_old[6 * W], stretch_new[6 * W], gradient_old[9 * W] = {}, gradient_new[9 * W] = {};
  double stress_old[6 * W], energy_old[W], dissipated_old[W], state_old[MostStates * W] = {};
  double stress_new[6 * W + guard], energy_new[W + guard], dissipated_new[W + guard], state_new[MostStates * W + guard];

  void mark_ends(int states) {
    for (int i = 0; i < guard; ++i)
      stress_new[6 * W + i] = energy_new[W + i] = dissipated_new[W + i] = state_new[states * W + i] = mark;
  }
  bool has_kept_ends(int states) const {
    bool kept = true;
    for (int i = 0; i < guard; ++i)
      kept = kept && stress_new[6 * W + i] == mark && energy_new[W + i] == mark && dissipated_new[W + i] == mark &&
             state_new[states * W + i] == mark;
    return kept;
  }
};

/// Stress from the user's code. The frame is the one that turns with the material (Green and Naghdi), in which the
/// gradient of the deformation is the stretch U. History: U, internal and dissipated energy by mass, the user's states.
struct UserLaw {
  static constexpr const char* name = "user";
  using Constants = UserLaw;
  static constexpr int most_states = 64;

  UserCode code;
  MaterialNumbers constants;
  MaterialText called;
  int states = 0;
  int deletes = 0;  // which of the states; 0: none

  static constexpr auto keys() {
    using M = UserLaw;
    return std::array{
        need("vumat", &M::code, "The shared library with the compiled VUMAT; --allow-library must name it too."),
        may("constants", &M::constants, "PROPS of the VUMAT, in their order."),
        may("state_variables", &M::states, most_states, "NSTATEV of the VUMAT; they begin with 0."),
        may("delete_variable", &M::deletes, most_states,
            "The state variable, counted from 1, that the VUMAT sets to 0 to delete a point; it begins with 1."),
        may("vumat_name", &M::called, "CMNAME of the VUMAT, in capitals: for code with several laws.")};
  }

  static constexpr int own_history = StretchHistory::count + 2;
  static constexpr int history_count = own_history + most_states;
  static constexpr bool changes_at_rest = true;  // the code gets the time
  int count_history() const { return own_history + states; }
  void start(double* history) const {
    StretchHistory::start(history);
    if (deletes > 0) history[find_deletion()] = 1;
  }
  int first_state() const { return own_history; }
  int count_states() const { return states; }
  /// Place of the state that deletes a point, in the history of the law; -1: none.
  int find_deletion() const { return deletes > 0 ? own_history + deletes - 1 : -1; }

  /// Moduli at the start, from the answer to a small strain at time 0.
  LameConstants moduli() const {
#ifdef PERCUSS_ON_DEVICE
    return {0, 0};
#else
    constexpr double strain = 1e-6;
    double history[history_count] = {};
    start(history);
    PointStep<double> step{};
    step.motion.de = {strain, 0, 0, 0, 0, 0};
    step.motion.dt = 1e-6;
    step.motion.volume_ratio = 1 + strain;
    step.motion.length = 1;
    step.motion.change = {0, 1};  // the density is that at the end: of half the strain it would tell half the modulus
    step.stress = {0, 0, 0, 0, 0, 0};
    step.density = code.density;
    step.history = history;
    call(step);
    const double lambda = 0.5 * (step.stress.yy + step.stress.zz) / strain;
    return {lambda, 0.5 * (step.stress.xx / strain - lambda)};
#endif
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
#ifndef PERCUSS_ON_DEVICE
    if (!(sum_lanes(step.motion.dt) > 0)) return;  // the forces at the start: the code may divide by the step
    const Symmetric3<T> old = step.stress, de = step.motion.de;
    call(step);
    set_moduli(old, de, step);
#else
    (void)step;
#endif
  }

 private:
  template <class T>
  static constexpr int lanes = static_cast<int>(sizeof(T) / sizeof(double));

  template <class T>
  static void put(const T& value, double* to) {
    std::memcpy(to, static_cast<const void*>(&value), sizeof value);
  }
  template <class T>
  static T take(const double* from) {
    T value;
    std::memcpy(static_cast<void*>(&value), from, sizeof value);
    return value;
  }
  template <class T>
  static void put(const Symmetric3<T>& a, double* to) {
    const T component[6] = {a.xx, a.yy, a.zz, a.xy, a.yz, a.zx};
    for (int k = 0; k < 6; ++k) put(component[k], to + k * lanes<T>);
  }
  template <class T>
  static Symmetric3<T> take_tensor(const double* from) {
    T a[6];
    for (int k = 0; k < 6; ++k) a[k] = take<T>(from + k * lanes<T>);
    return {a[0], a[1], a[2], a[3], a[4], a[5]};
  }

  /// In the frame that turns with the material the gradient is U: its nine components, xx to zx, then yx, zy, xz.
  template <int W>
  static void copy_gradient(const double* stretch, double* gradient) {
    for (int i = 0; i < 6 * W; ++i) gradient[i] = stretch[i];
    for (int i = 0; i < 3 * W; ++i) gradient[6 * W + i] = stretch[3 * W + i];
  }

  template <class T, class Block>
  void fill(const PointStep<T>& step, const Symmetric3<T>& stretch, Block& block) const {
    constexpr int w = lanes<T>;
    const T* const own = step.history + StretchHistory::count;
    const T half = step.motion.volume_ratio - T(0.5) * step.motion.change.growth;
    put(T(step.density) / half, block.density);
    put(step.motion.length, block.length);
    put(step.motion.de, block.strain);
    put(StretchHistory::load(step.history), block.stretch_old);
    put(stretch, block.stretch_new);
    copy_gradient<w>(block.stretch_old, block.gradient_old);
    copy_gradient<w>(block.stretch_new, block.gradient_new);
    put(step.stress, block.stress_old);
    put(own[0], block.energy_old);
    put(own[1], block.dissipated_old);
    for (int i = 0; i < states; ++i) put(own[2 + i], block.state_old + i * w);
    // Code that leaves an output as it is keeps the old value.
    put(step.stress, block.stress_new);
    for (int i = 0; i < w; ++i) block.energy_new[i] = block.energy_old[i];
    for (int i = 0; i < w; ++i) block.dissipated_new[i] = block.dissipated_old[i];
    for (int i = 0; i < states * w; ++i) block.state_new[i] = block.state_old[i];
    block.mark_ends(states);
  }

  template <class T>
  PERCUSS_NO_INLINE void call(PointStep<T>& step) const {
    constexpr int w = lanes<T>;
    const Symmetric3<T> stretch = advance_stretch(StretchHistory::load(step.history), step.motion);
    VumatBlock<w, most_states> block;
    fill(step, stretch, block);
    const int points = w, direct = 3, shear = 3, none = 0;
    double dt[w];
    put(step.motion.dt, dt);
    code.vumat(&points, &direct, &shear, &states, &none, &constants.count, &none, &step.motion.time, &step.motion.time,
               dt, called.text, block.places, block.length, constants.value, block.density, block.strain, block.spin,
               block.none, block.stretch_old, block.gradient_old, block.none, block.stress_old, block.state_old,
               block.energy_old, block.dissipated_old, block.none, block.stretch_new, block.gradient_new, block.none,
               block.stress_new, block.state_new, block.energy_new, block.dissipated_new, MaterialText::most);
    T* const own = step.history + StretchHistory::count;
    StretchHistory::store(stretch, step.history);
    step.stress = take_tensor<T>(block.stress_new);
    own[0] = take<T>(block.energy_new);
    own[1] = take<T>(block.dissipated_new);
    const T before = deletes > 0 ? own[1 + deletes] : T(1);
    for (int i = 0; i < states; ++i) own[2 + i] = take<T>(block.state_new + i * w);
    if (deletes > 0) end_deleted(before, own[1 + deletes], step.stress);
    if (block.has_kept_ends(states)) return;
    __atomic_store_n(code.has_written_outside, 1, __ATOMIC_RELAXED);
    step.stress.xx = T(std::numeric_limits<double>::quiet_NaN());  // ends the run
  }

  /// A deleted point stays so, and has no stress.
  template <class T>
  static void end_deleted(const T& before, T& remains, Symmetric3<T>& stress) {
    const auto is_left = (before > T(0)) & (remains > T(0));
    remains = select(is_left, remains, T(0));
    for (T* const component : {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.yz, &stress.zx})
      *component = select(is_left, *component, T(0));
  }

  /// Moduli of the answer to the strain of this step where it is large enough, and not below those at the start: bounds
  /// of the step, as those of a law that stiffens. A change of volume counts only beside a shear that is not much
  /// larger, and the other way round: what one part of the strain does to the stress of the other is no modulus.
  template <class T>
  static void set_moduli(const Symmetric3<T>& old, const Symmetric3<T>& de, PointStep<T>& step) {
    constexpr double least_strain = 1e-6, least_share = 0.1;
    const Symmetric3<T> ds = step.stress + T(-1) * old;
    const T volume = de.xx + de.yy + de.zz, pressure = T(1.0 / 3) * (ds.xx + ds.yy + ds.zz);
    const Symmetric3<T> shear = add_pressure(de, T(-1.0 / 3) * volume), stress = add_pressure(ds, -pressure);
    const T square = contract(shear, shear),
            least = larger(T(least_strain * least_strain), T(least_share * least_share) * contract(de, de));
    const T start_bulk = step.lambda + T(2.0 / 3) * step.mu;
    const T bulk =
        select(volume * volume > least, pressure / select(volume * volume > least, volume, T(1)), start_bulk);
    const T mu =
        select(square > least, T(0.5) * contract(shear, stress) / select(square > least, square, T(1)), step.mu);
    step.mu = larger(step.mu, mu);
    step.lambda = larger(start_bulk, bulk) - T(2.0 / 3) * step.mu;
  }
};

}  // namespace percuss
