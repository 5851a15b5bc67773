#pragma once
// Fields of a user: compiled code with the published VUSDFLD interface of Abaqus/Explicit, called for the points of a
// pack at the start of a step, before the law of the same library. It runs on the host alone.

#include <algorithm>
#include <cstring>
#include <string_view>

#include "kernels/material/lane_copies.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/stretch.hpp"
#include "kernels/material/user/user_call.hpp"

namespace percuss {

/// Fields that code of a user may set at a point.
inline constexpr int most_user_fields = 16;

/// Points of a VUSDFLD, of which VGETVRM tells it quantities at the start of the step.
class AskedPoints {
 public:
  virtual ~AskedPoints() = default;
  /// Writes a quantity, by its name in capitals, as [component][point]; false: there is none.
  virtual bool tell(std::string_view quantity, double* to) const = 0;
};

/// Points of the VUSDFLD call that this thread is in; null: it is in none. VGETVRM has no argument that would say so.
inline thread_local const AskedPoints* asked_points = nullptr;

/// The logarithmic strain of a stretch.
template <class T>
Symmetric3<T> find_logarithm(const Symmetric3<T>& stretch) {
  const PrincipalAxes<T> axes = find_principal_axes(stretch);
  Symmetric3<T> strain{T(0), T(0), T(0), T(0), T(0), T(0)};
  for (int i = 0; i < 3; ++i) {
    const Vector3<T>& n = axes.direction[i];
    const T e = logarithm(axes.value[i]);
    strain = strain + e * Symmetric3<T>{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
  }
  return strain;
}

/// What a law knows of its points at the start of a step: tensors by the axes of the material.
template <class T>
struct FieldPoints final : AskedPoints {
  Symmetric3<T> stress, stretch;
  T temperature, plastic_strain;
  bool has_plastic_strain = false;
  int states = 0;
  const double* state = nullptr;

  bool tell(std::string_view quantity, double* to) const override {
    if (quantity == "S")
      write_lanes(stress, to);
    else if (quantity == "LE")
      write_lanes(find_logarithm(stretch), to);
    else if (quantity == "TEMP")
      write_lanes(temperature, to);
    else if (quantity == "PEEQ" && has_plastic_strain)
      write_lanes(plastic_strain, to);
    else if (quantity == "SDV" && states > 0)
      std::copy_n(state, states * lane_count<T>, to);
    else
      return false;
    return true;
  }
};

/// Other arguments of the code for W points, as a law has them.
template <int W>
struct FieldCall {
  const UserCode& code;
  const MaterialText& called;
  double step_time, time;
  const double* dt;
  const double* length;
  Matrix3<double> axes;  // rows: those of the material in space at the start
  const int* elements;
  double *state_old, *state_new;  // in: the same; out: the old ones are those that the code has left
};

/// Input and output of the code for W points. What it may write ends with numbers that it must not change.
template <int W>
struct FieldBlock {
  static constexpr int guard = 2 * W;
  static constexpr double mark = -7.0539e212;  // no field has it

  double places[3 * W], axes[9 * W], turn[9 * W];
  double before[most_user_fields * W], now[most_user_fields * W + guard];

  void begin(int fields) {
    std::fill_n(now, fields * W, 0.0);
    std::fill_n(now + fields * W, guard, mark);
  }
  bool has_kept_ends(int fields) const {
    return std::all_of(now + fields * W, now + fields * W + guard, [](double value) { return value == mark; });
  }
  void set_axes(const Matrix3<double>& own) {
    for (int axis = 0; axis < 3; ++axis) {
      const double a[3] = {own.row[axis].x, own.row[axis].y, own.row[axis].z};
      for (int k = 0; k < 3; ++k) {
        std::fill_n(axes + (3 * axis + k) * W, W, a[k]);
        std::fill_n(turn + (3 * axis + k) * W, W, axis == k ? 1.0 : 0.0);
      }
    }
  }
};

/// The fields of a law of a user. History: those of the step before, the place of the point, which its element sets.
struct UserFields {
  int fields = 0;  // 0: the code is not called
  MaterialNumbers field_constants;

  int count_field_history() const { return fields + 3; }
  void start_place(const double (&place)[3], double* own) const { std::copy_n(place, 3, own + fields); }

  /// Calls the code. own: of the history; block: out, the fields before and now.
  template <class T>
  PERCUSS_NO_INLINE void find_fields(const FieldCall<lane_count<T>>& call, FieldPoints<T>& points, T* own,
                                     FieldBlock<lane_count<T>>& block) const {
    constexpr int w = lane_count<T>;
    const int width = w, one = 1, direct = 3, shear = 3;
    for (int i = 0; i < fields; ++i) write_lanes(own[i], block.before + i * w);
    for (int k = 0; k < 3; ++k) write_lanes(own[fields + k], block.places + k * w);
    block.set_axes(call.axes);
    block.begin(fields);
    points.state = call.state_old;
    asked_points = &points;
    call_library(call.code.file, [&] {
      call.code.vusdfld(&width, &points.states, &fields, &field_constants.count, &direct, &shear, call.elements, &one,
                        &one, &one, &call.step_time, &call.time, call.dt, call.called.text, block.places, block.axes,
                        block.turn, call.length, field_constants.value, call.state_old, call.state_new, block.now,
                        MaterialText::most);
    });
    asked_points = nullptr;
    std::copy_n(call.state_new, points.states * w, call.state_old);
    for (int i = 0; i < fields; ++i) own[i] = read_lanes<T>(block.now + i * w);
  }
};

}  // namespace percuss
