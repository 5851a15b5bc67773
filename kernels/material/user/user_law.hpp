#pragma once
// A law of the user: compiled code with the published VUMAT interface of Abaqus/Explicit, called for the points of a
// pack. It runs on the host alone.

#include <array>
#include <cstddef>
#include <limits>

#include "kernels/material/elastic.hpp"
#include "kernels/material/lane_copies.hpp"
#include "kernels/material/material_axes.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"
#include "kernels/material/user/user_element.hpp"
#include "kernels/material/user/user_fields.hpp"

namespace percuss {

/// Input and output of the user's code for W points. What the code may write ends with numbers that it must not change.
template <int W>
struct VumatBlock {
  static constexpr int guard = 2 * W;
  static constexpr double mark = -7.0539e212;  // no law gives it

  int header[4 + W] = {W, 1, 1, 1};  // jblock: points, point of the element, layer, point of the section; elements
  int flags[8] = {};                 // jInfoArray: no annealing, no effective moduli
  double dt[2 * W + 1] = {};         // the step; places for effective moduli, which are not taken
  double places[3 * W] = {}, length[most_user_lengths * W], density[W], strain[6 * W], spin[3 * W] = {}, none[W] = {},
                    temperature[W] = {};
  double stretch_old[6 * W], stretch_new[6 * W], gradient_old[9 * W] = {}, gradient_new[9 * W] = {};
  double stress_old[6 * W], energy_old[W], dissipated_old[W], state_old[most_user_states * W];
  double stress_new[6 * W + guard], energy_new[W + guard], dissipated_new[W + guard],
      state_new[most_user_states * W + guard];

  VumatBlock() { state_old[0] = 0; }
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

/// Stress from the user's code. The frame is the one that turns with the material (Green and Naghdi), by the material's
/// axes if it has any; in it the gradient of the deformation is the stretch U. History: U in the axes of space,
/// internal and dissipated energy by mass, the temperature if it is ever another than 0, its rise in the last step if
/// it expands, the number of the element, its characteristic lengths, the user's states, that of UserFields.
struct UserLaw : UserFields {
  static constexpr const char* name = "user";
  using Constants = UserLaw;

  UserCode code;
  MaterialNumbers constants, start_states;
  MaterialText called;
  int states = 0;
  int deletes = 0;      // which of the states; 0: none
  int own_lengths = 0;  // 0: that of its volume
  double start_temperature = 0, specific_heat = 0, heating_share = 0.9, thermal_expansion = 0;
  double first_axis[3] = {1, 0, 0}, second_axis[3] = {0, 0, 0};  // of the second zeros: find_second_direction()

  static constexpr auto keys() {
    using M = UserLaw;
    return std::array{
        need("vumat", &M::code, "The shared library with the compiled VUMAT; --allow-library must name it too."),
        may("constants", &M::constants, "PROPS of the VUMAT, in their order."),
        may("state_variables", &M::states, most_user_states, "NSTATEV of the VUMAT; they begin with 0."),
        may("start_states", &M::start_states, "State variables at the start, from the first; the others begin with 0."),
        may("delete_variable", &M::deletes, most_user_states,
            "The state variable, counted from 1, that the VUMAT sets to 0 to delete a point; it begins with 1."),
        may("vumat_name", &M::called, "CMNAME of the VUMAT, in capitals: for code with several laws."),
        may("characteristic_lengths", &M::own_lengths, most_user_lengths,
            "How many lengths of each element the VUCHARLENGTH of the same library tells; 0: the edge of a cube of its "
            "volume."),
        may<M>("field_variables", &M::fields, most_user_fields,
               "How many fields the VUSDFLD of the same library sets before the VUMAT is called; 0: it is not called."),
        may<M>("field_constants", &M::field_constants, "PROPS of the VUSDFLD, in their order."),
        may("first_axis", &M::first_axis, KeyRange::any, "-",
            "Axis 1 in space at the start, in whose components the code gets all tensors."),
        may("second_axis", &M::second_axis, KeyRange::any, "-",
            "A direction in the plane of the axes 1 and 2, on the side of axis 2."),
        may("start_temperature", &M::start_temperature, KeyRange::any, "temperature",
            "Temperature at the start, which the VUMAT gets."),
        may("specific_heat", &M::specific_heat, KeyRange::not_negative, "energy / mass / temperature",
            "Heat that a unit of mass takes for a degree; 0: inelastic energy does not heat."),
        may("heating_share", &M::heating_share, KeyRange::share, "-",
            "Share of the inelastic energy of the VUMAT that heats."),
        may("thermal_expansion", &M::thermal_expansion, KeyRange::not_negative, "1 / temperature",
            "Strain of a length by a degree, which the VUMAT does not get.")};
  }

  /// What is wrong between constants; empty: nothing.
  const char* find_fault() const {
    if (start_states.count > states) return "more start_states than state_variables";
    if (field_constants.count > 0 && fields == 0) return "field_constants and no field_variables";
    if (!are_axes(first_axis, second_axis)) return "first_axis and second_axis that are zero or parallel";
    return thermal_expansion > 0 && specific_heat == 0 ? "a thermal_expansion and no specific_heat, by which it heats"
                                                       : "";
  }

  static constexpr int history_count = most_law_history;
  static_assert(StretchHistory::count + 5 + most_user_lengths + most_user_states + most_user_fields + 3 <=
                    most_law_history ||
                most_law_history < most_user_states);  // which a device does not call
  static constexpr bool changes_at_rest = true;        // the code gets the time
  /// Where the temperature is kept, in the history of the law; -1: it is 0 for good.
  int find_temperature() const { return start_temperature != 0 || specific_heat > 0 ? StretchHistory::count + 2 : -1; }
  int find_scalar(HistoryScalar scalar) const { return scalar == HistoryScalar::temperature ? find_temperature() : -1; }
  /// Whether the rise of temperature of the last step, whose expansion the code has yet to get, is kept behind the
  /// temperature.
  bool keeps_rise() const { return thermal_expansion > 0; }
  /// Where the number of the element is kept, and behind it its lengths.
  int find_element() const {
    return StretchHistory::count + 2 + (find_temperature() >= 0 ? 1 : 0) + (keeps_rise() ? 1 : 0);
  }
  int count_lengths() const { return own_lengths > 0 ? own_lengths : 1; }
  int first_state() const { return find_element() + 1 + count_lengths(); }
  int count_states() const { return states; }
  int first_field() const { return first_state() + states; }
  /// Where the place of the point is kept, in the history of the law.
  int find_place() const { return first_field() + fields; }
  int count_history() const { return first_field() + count_field_history(); }
  void start(double* history) const {
    StretchHistory::start(history);
    if (find_temperature() >= 0) history[find_temperature()] = start_temperature;
    for (int i = 0; i < start_states.count; ++i) history[first_state() + i] = start_states.value[i];
    if (deletes > 0) history[find_deletion()] = 1;
    for (int i = 0; i < count_lengths(); ++i) history[find_element() + 1 + i] = 1;
  }
  static bool needs_elements() { return true; }
  void start_element(const UserElement& element, double* history) const {
    history[find_element()] = element.id;
    history[find_element() + 1] = element.length;
    for (int i = 0; i < own_lengths; ++i) history[find_element() + 1 + i] = element.lengths[i];
    start_place(element.place, history + first_field());
  }
  /// Place of the state that deletes a point, in the history of the law; -1: none.
  int find_deletion() const { return deletes > 0 ? first_state() + deletes - 1 : -1; }

  /// Moduli at the start, from the answers to small strains along the material's axes at time 0: those of the first,
  /// raised to the stiffest.
  LameConstants moduli() const {
#ifdef PERCUSS_ON_DEVICE
    return {0, 0};
#else
    constexpr double round_off = 1e-6;
    const LameConstants first = find_answer(0);
    const double along = first.lambda + 2 * first.mu;
    double share = 1;
    for (int axis = 1; axis < 3; ++axis) {
      const LameConstants other = find_answer(axis);
      const double more = (other.lambda + 2 * other.mu) / along;
      if (!(more <= share * (1 + round_off))) share = more;  // so that NaN is found, too
    }
    return {share * first.lambda, share * first.mu};
#endif
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
#ifndef PERCUSS_ON_DEVICE
    if (!(sum_lanes(step.motion.dt) > 0)) return;  // the forces at the start: the code may divide by the step
    const Symmetric3<T> old = step.stress, de = find_mechanical_strain(step);
    call(step);
    require_finite(step.history, count_history(), step.stress);
    set_return(old, de, step);
    set_moduli(old, de, step);
#else
    (void)step;
#endif
  }

 private:
  /// Isotropic moduli that give the same stresses along an axis and across it.
  LameConstants find_answer(int axis) const {
    constexpr double strain = 1e-6;
    double history[history_count] = {};
    start(history);
    const Vector3<double>& a = find_axes().row[axis];
    PointStep<double> step{};
    step.motion.de = {strain * a.x * a.x, strain * a.y * a.y, strain * a.z * a.z,
                      strain * a.x * a.y, strain * a.y * a.z, strain * a.z * a.x};
    step.motion.dt = 1e-6;
    step.motion.volume_ratio = 1 + strain;
    step.motion.length = 1;
    step.motion.change = {0, 1};  // the density is that at the end: of half the strain it would tell half the modulus
    step.stress = {0, 0, 0, 0, 0, 0};
    step.density = code.density;
    step.history = history;
    call(step);
    const double along = dot(a, step.stress * a), lambda = 0.5 * (trace(step.stress) - along) / strain;
    return {lambda, 0.5 * (along / strain - lambda)};
  }

  /// Whether the code gets other components than those of space.
  bool has_axes() const {
    return !(first_axis[0] > 0 && first_axis[1] == 0 && first_axis[2] == 0 && second_axis[2] == 0 &&
             second_axis[1] >= 0);
  }
  Matrix3<double> find_axes() const {
    return has_axes() ? find_material_axes(first_axis, second_axis) : identity_matrix<double>();
  }
  template <class T>
  Matrix3<T> find_axes_of() const {
    const Matrix3<double> a = find_axes();
    Matrix3<T> axes;
    for (int i = 0; i < 3; ++i) axes.row[i] = {T(a.row[i].x), T(a.row[i].y), T(a.row[i].z)};
    return axes;
  }
  /// Rotates from the axes of space to those of the material, and back.
  template <class T>
  Symmetric3<T> to_material(const Symmetric3<T>& a) const {
    return has_axes() ? push_forward(find_axes_of<T>(), a) : a;
  }
  template <class T>
  Symmetric3<T> to_space(const Symmetric3<T>& a) const {
    return has_axes() ? pull_back(find_axes_of<T>(), a) : a;
  }

  /// Strain increment without the expansion by the heat of the step before.
  template <class T>
  Symmetric3<T> find_mechanical_strain(const PointStep<T>& step) const {
    if (!keeps_rise()) return step.motion.de;
    return add_pressure(step.motion.de, T(-thermal_expansion) * step.history[find_temperature() + 1]);
  }

  /// In the frame that turns with the material the gradient is U: its nine components, xx to zx, then yx, zy, xz.
  template <int W>
  static void copy_gradient(const double* stretch, double* gradient) {
    for (int i = 0; i < 6 * W; ++i) gradient[i] = stretch[i];
    for (int i = 0; i < 3 * W; ++i) gradient[6 * W + i] = stretch[3 * W + i];
  }

  /// Its number, and its lengths: that of its volume grows with it.
  template <class T, class Block>
  void fill_element(const PointStep<T>& step, Block& block) const {
    constexpr int w = lane_count<T>;
    const T* const kept = step.history + find_element();
    double id[w];
    write_lanes(kept[0], id);
    for (int i = 0; i < w; ++i) block.header[4 + i] = static_cast<int>(id[i]);
    write_lanes(step.motion.dt, block.dt);
    for (int i = 0; i < own_lengths; ++i) write_lanes(kept[1 + i], block.length + i * w);
    if (own_lengths == 0) write_lanes(T(kept[1] * power(step.motion.volume_ratio, 1.0 / 3.0)), block.length);
  }

  template <class T, class Block>
  void fill(const PointStep<T>& step, const Symmetric3<T>& stretch, Block& block) const {
    constexpr int w = lane_count<T>;
    const T* const own = step.history + StretchHistory::count;
    write_lanes(T(step.density) / step.motion.middle_volume_ratio(), block.density);
    fill_element(step, block);
    for (int k = 0; k < 3; ++k) write_lanes(step.history[find_place() + k], block.places + k * w);
    write_lanes(to_material(find_mechanical_strain(step)), block.strain);
    write_lanes(to_material(StretchHistory::load(step.history)), block.stretch_old);
    write_lanes(to_material(stretch), block.stretch_new);
    fill_spin(T(0.5) * (StretchHistory::load(step.history) + stretch), step.motion.de, block);
    copy_gradient<w>(block.stretch_old, block.gradient_old);
    copy_gradient<w>(block.stretch_new, block.gradient_new);
    write_lanes(to_material(step.stress), block.stress_old);
    write_lanes(own[0], block.energy_old);
    write_lanes(own[1], block.dissipated_old);
    if (find_temperature() >= 0) write_lanes(step.history[find_temperature()], block.temperature);
    for (int i = 0; i < states; ++i) write_lanes(step.history[first_state() + i], block.state_old + i * w);
    // Code that leaves an output as it is keeps the old value.
    for (int i = 0; i < 6 * w; ++i) block.stress_new[i] = block.stress_old[i];
    for (int i = 0; i < w; ++i) block.energy_new[i] = block.energy_old[i];
    for (int i = 0; i < w; ++i) block.dissipated_new[i] = block.dissipated_old[i];
    for (int i = 0; i < states * w; ++i) block.state_new[i] = block.state_old[i];
    block.mark_ends(states);
  }

  /// How far the material spins in the step beyond the frame (advance_stretch()), as an axial vector. u: at the middle.
  template <class T, class Block>
  void fill_spin(const Symmetric3<T>& u, const Symmetric3<T>& de, Block& block) const {
    const Vector3<T> in_space = T(-1) * solve(find_turn_resistance(u), find_turn_drive(de, u));
    const Vector3<T> spin = has_axes() ? find_axes_of<T>() * in_space : in_space;
    write_lanes(spin.x, block.spin);
    write_lanes(spin.y, block.spin + lane_count<T>);
    write_lanes(spin.z, block.spin + 2 * lane_count<T>);
  }

  /// Sets the fields by the VUSDFLD, which also changes state variables before the VUMAT gets them.
  template <class T, class Block>
  void set_fields(const PointStep<T>& step, Block& block, FieldBlock<lane_count<T>>& field) const {
    FieldPoints<T> points;
    points.stress = read_tensor_lanes<T>(block.stress_old);
    points.stretch = read_tensor_lanes<T>(block.stretch_old);
    points.temperature = read_lanes<T>(block.temperature);
    points.states = states;
    find_fields({code, called, code.find_step_time(step.motion.time), step.motion.time, block.dt, block.length,
                 find_axes(), block.header + 4, block.state_old, block.state_new},
                points, step.history + first_field(), field);
  }

  template <class T>
  PERCUSS_NO_INLINE void call(PointStep<T>& step) const {
    constexpr int w = lane_count<T>;
    const Symmetric3<T> stretch = advance_stretch(StretchHistory::load(step.history), step.motion);
    VumatBlock<w> block;
    FieldBlock<w> field;
    fill(step, stretch, block);
    if (fields > 0) set_fields(step, block, field);
    const int direct = 3, shear = 3;
    const double step_time = code.find_step_time(step.motion.time);
    call_library(code.file, [&] {
      code.vumat(block.header, &direct, &shear, &states, &fields, &constants.count, block.flags, &step_time,
                 &step.motion.time, block.dt, called.text, block.places, block.length, constants.value, block.density,
                 block.strain, block.spin, block.temperature, block.stretch_old, block.gradient_old,
                 fields > 0 ? field.before : block.none, block.stress_old, block.state_old, block.energy_old,
                 block.dissipated_old, block.temperature, block.stretch_new, block.gradient_new,
                 fields > 0 ? field.now : block.none, block.stress_new, block.state_new, block.energy_new,
                 block.dissipated_new, MaterialText::most);
    });
    T* const own = step.history + StretchHistory::count;
    StretchHistory::store(stretch, step.history);
    step.stress = to_space(read_tensor_lanes<T>(block.stress_new));
    own[0] = read_lanes<T>(block.energy_new);
    own[1] = read_lanes<T>(block.dissipated_new);
    heat(block, step);
    T* const state = step.history + first_state();
    T before = deletes > 0 ? state[deletes - 1] : T(1);
    if (deletes > 0 && fields > 0) before = smaller(before, read_lanes<T>(block.state_old + (deletes - 1) * w));
    for (int i = 0; i < states; ++i) state[i] = read_lanes<T>(block.state_new + i * w);
    if (deletes > 0) end_deleted(before, state[deletes - 1], step.stress);
    if (block.has_kept_ends(states) && (fields == 0 || field.has_kept_ends(fields))) return;
    __atomic_store_n(code.has_written_outside, 1, __ATOMIC_RELAXED);
    step.stress.xx = T(std::numeric_limits<double>::quiet_NaN());  // ends the run
  }

  /// Heats by the inelastic energy of a unit of mass that the code reports.
  template <class T, class Block>
  void heat(const Block& block, PointStep<T>& step) const {
    if (!(specific_heat > 0)) return;
    T& temperature = step.history[find_temperature()];
    const T rise =
        T(heating_share / specific_heat) * (read_lanes<T>(block.dissipated_new) - read_lanes<T>(block.dissipated_old));
    temperature = temperature + rise;
    if (keeps_rise()) step.history[find_temperature() + 1] = rise;
  }

  /// The code flows where its answer to the strain of the step is less than half of that of the moduli at the start, or
  /// where its stress falls at rest. Stored hourglass forces relax by the same share; otherwise they resist the flow.
  template <class T>
  static void set_return(const Symmetric3<T>& old, const Symmetric3<T>& de, PointStep<T>& step) {
    constexpr double least_loss = 0.5, nothing = 1e-9;
    const Symmetric3<T> shear = add_pressure(de, T(-1.0 / 3) * trace(de));
    const Symmetric3<T> trial = add_pressure(old, T(-1.0 / 3) * trace(old)) + T(2) * step.mu * shear;
    const Symmetric3<T> stress = add_pressure(step.stress, T(-1.0 / 3) * trace(step.stress));
    const T from = square_root(contract(trial, trial)), to = square_root(contract(stress, stress));
    const T elastic = T(2) * step.mu * square_root(contract(shear, shear));
    const auto flows = from - to > T(least_loss) * elastic + T(nothing) * from;
    PlasticReturn<T>& plastic = step.plastic;
    plastic.share = select(flows, to / select(flows, from, T(1)), plastic.share);
    plastic.flow_stress = select(flows, T(1.2247448713915890) * to, plastic.flow_stress);
    plastic.loading = select(flows, T(1), plastic.loading);
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
