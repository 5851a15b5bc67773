#pragma once
// What changes in the loop. All of it is needed to continue a run; the rest can be derived.

#include <cstdint>
#include <string>

#include "src/step/model.hpp"

namespace percuss {

/// Sums that the audit needs, from the start of the run.
struct Books {
  double external_work = 0;              // pressure and driven conditions; gravity's follows from the positions
  double contact_work = 0;               // normal impulses; positive where contact adds energy
  double friction_work = 0;              // tangential impulses; negative where they dissipate
  double impulse[3] = {0, 0, 0};         // external: pressure, conditions, walls and gravity [force x time]
  double moment_impulse[3] = {0, 0, 0};  // about Model::mass_center
};

/// The controlling step bound and what failed, after the elements of a step.
struct StepBound {
  double step = 0;          // smallest bound of all elements, without the deck's scale
  int element = 0;          // that has it
  int failed_element = -1;  // lowest element without positive volume or step, -1: none
};

struct State {
  double time = 0;     // n
  long step = 0;       // n
  double dt = 0;       // between n-1 and n; 0 before the first step
  double next_dt = 0;  // between n and n+1
  StepBound bound;     // at n

  Rows3<double> x;           // position, at n
  Rows3<double> v;           // velocity, at n-1/2 (at n = 0: at 0)
  Rows3<double> v_before;    // velocity one step earlier; scratch of the step
  Rows3<double> force;       // assembled force, at n
  Rows3<double> impulse;     // contact impulse of the last step
  Array<double> elements;    // element records, at n
  Rows3<double> slot_force;  // internal force (negative) and pressure by slot, at n
  ChunkResults results;      // by chunk, at n; work since the start
  Books books;
};

/// The state at time 0: elements at rest in their first shape, held directions at their prescribed velocity.
State make_initial_state(const Model& model);

/// 64 bits of all positions, velocities and element records, by global id: independent of ranks, threads and order.
std::uint64_t hash_state(const Model& model, const State& state);

}  // namespace percuss
