#pragma once
// Springs, dampers, friction and stops of the turn between two rigid bodies, and their state. Every rank has all of
// them, and the same bits.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/tensor.hpp"
#include "src/step/model/spring_model.hpp"

namespace percuss {

/// Resistance against one of the three angles; const after set-up.
struct TurnLaw {
  SpringLaw spring;           // angle, moment
  SpringLaw damper;           // rate, moment
  SpringLaw friction;         // angle, moment at which it slips
  double hold_stiffness = 0;  // of friction that sticks, and of stops; 0: neither
  std::optional<double> least, most;

  bool slips() const { return !friction.rows.empty(); }
};

/// Const after set-up.
struct TurnSpring {
  std::string name;
  std::array<int, 2> body{};                             // of the model
  std::array<std::array<Vector3<double>, 3>, 2> axes{};  // x, y, z on each body at time 0
  std::array<std::optional<TurnLaw>, 3> laws;            // of the angles about x, y and z; none: that turn is free
};

/// StepBound::spring of a turn spring, by its place in the model, and back; below 0: it is none.
inline std::int64_t number_turn_spring(std::size_t spring) { return -2 - static_cast<std::int64_t>(spring); }
inline std::int64_t find_turn_spring(std::int64_t number) { return -2 - number; }

/// A turn spring in the loop. Angles are those by which the second body is turned: about x of the first one, then about
/// the y that this has moved, then about the z of the second one. A positive moment acts against a positive angle.
struct TurnSpringState {
  std::array<double, 3> angle{};     // at n
  std::array<double, 3> elastic{};   // moment of the spring and of the stops, at n
  std::array<double, 3> damping{};   // at n, from the rates at n-1/2 (at n = 0: at 0)
  std::array<double, 3> friction{};  // at n
  Vector3<double> moment{};          // on the second body at n, on the first one the opposite
};

}  // namespace percuss
