#pragma once
// What conditions hold after sensors have switched some.

#include "src/step/model/state.hpp"

namespace percuss {

/// Sets the held directions to those of the conditions that hold after the events so far, and the inverse masses that
/// go with them. Nodes that have vanished are held no more. Does nothing where no sensor switches a condition.
void set_held_directions(const Model& model, State& state);

/// Leaves out the held directions of nodes that have vanished. Supports list theirs anew then.
void drop_vanished_directions(State& state);

}  // namespace percuss
