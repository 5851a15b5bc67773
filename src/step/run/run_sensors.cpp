// The sensors of a run: what they see, and what acts from then on.

#include <fmt/format.h>

#include "src/step/run/run_scene.hpp"
#include "src/step/sensors/held_directions.hpp"

namespace percuss {

/// Events at time 0 act from the start.
void Run::start_sensors() {
  if (!stepper_.sensors().any()) return;
  const std::vector<char> happened = stepper_.sensors().find_happened(state_.time);
  report_events(happened);
  state_.happened = happened;
  set_held_directions(model_, state_);
  contact_.set_switches(happened);
}

/// Sensors see rows of the history that are due, and no other: whoever requests a frame does not change the run.
void Run::look_by_sensors(bool has_new_row) {
  if (!stepper_.sensors().any()) return;
  if (has_new_row && output_.has_rows()) stepper_.sensors().look(state_.time, output_.last_row());
  const std::vector<char> happened = stepper_.sensors().find_happened(state_.time);
  if (happened == state_.happened) return;
  report_events(happened);
  stepper_.switch_now(state_, happened);
  switch_contact();
}

/// Also after a restart with other times than those of the checkpoint.
void Run::switch_contact() {
  if (contact_.is_active()) say(contact_.switch_now(state_.happened, state_.x, state_.v));
}

void Run::report_events(const std::vector<char>& happened) {
  for (std::size_t s = 0; s < happened.size(); ++s)
    if (happened[s] != state_.happened[s])
      say({fmt::format("sensor '{}' acts at t = {:.6g}", deck_.sensors[s].name, state_.time)});
}

}  // namespace percuss
