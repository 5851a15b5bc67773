#pragma once
// What conditions hold after sensors have switched some.

#include "src/step/model/state.hpp"

namespace percuss {

/// Sets the held directions to those of the conditions that hold after the events so far, and the inverse masses that
/// go with them. Does nothing where no sensor switches a condition.
void set_held_directions(const Model& model, State& state);

}  // namespace percuss
