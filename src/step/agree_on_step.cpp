// Agreement of the ranks after a step, and the step that follows from it.

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/step/phases.hpp"
#include "src/step/step.hpp"

namespace percuss {

namespace {

/// The step may grow by this factor at most, so that central differences stay second order.
constexpr double largest_step_growth = 1.1;
/// A step is kept until the bound allows one that is longer by this share: a step that follows the bound up and down
/// with every vibration is changed in phase with it, and feeds it energy.
constexpr double least_step_growth = 0.02;
/// From this many steps before the end, the remaining time is divided equally.
constexpr double landing_steps = 128;
/// If at least this many steps remain, one extra step is added, so that none has to be longer than its bound.
constexpr double steps_with_room = 8;

/// A step, dt at most, from which the end is hit exactly. left: time to the end; last: the step before, 0 at first.
///
/// What central differences conserve depends on the square of the step, so that a step cut in half would change the
/// energy of the shortest waves: the last steps are equal, and short enough that the bound, which follows every
/// vibration, does not request others.
double land(double left, double dt, double last) {
  const double count = std::ceil(left / dt * (1 - 1e-12));
  if (!(left > 0) || count > landing_steps) return dt;
  for (const double step : {last, dt}) {
    const double whole = step > 0 && step <= dt ? std::round(left / step) : 0;
    if (whole >= 1 && std::abs(left / step - whole) < 1e-7) return left / whole;
  }
  return left / (count < steps_with_room ? count : count + 1);
}

}  // namespace

void StepNotice::merge(const StepNotice& other) {
  if (other.step < step || (other.step == step && other.element < element)) {
    step = other.step;
    element = other.element;
    element_id = other.element_id;
  }
  failed_element = std::min(failed_element, other.failed_element);
  broken_chunk = std::min(broken_chunk, other.broken_chunk);
  stop = std::max(stop, other.stop);
  checkpoint = std::max(checkpoint, other.checkpoint);
  frame = std::max(frame, other.frame);
  contact_rate = std::max(contact_rate, other.contact_rate);
  growth = std::max(growth, other.growth);
  died = std::max(died, other.died);
  wants_mass = std::max(wants_mass, other.wants_mass);
}

StepNotice Stepper::find_notice(const State& state) const {
  const Action* const asker = find_asker();
  const auto step = to_host(asker != nullptr ? asker->find_bounds(state.results) : state.results.stable_step);
  const auto element = to_host(state.results.controlling_element);
  const auto failed = to_host(state.results.failed_element);
  const auto work = to_host(state.results.work);
  const auto is_finite_work = [&](std::size_t c) {
    double sum = 0;
    for (std::size_t k = 0; k < work_kinds; ++k) sum += work(c, k);
    return std::isfinite(sum);
  };
  StepNotice notice;
  for (std::size_t c = 0; c < step.extent(0); ++c) {
    const Chunk& chunk = chunked_.chunks[c];
    const std::int64_t shift =
        chunked_.numbering.first_element[static_cast<std::size_t>(chunk.number)] - chunk.first_element;
    const double bound = elements_.find_step(c, step(c));
    notice.merge({bound, element(c) + shift, chunked_.mesh.element_ids[static_cast<std::size_t>(element(c))],
                  failed(c) < 0 ? StepNotice::none : failed(c) + shift,
                  is_finite_work(c) ? StepNotice::none : chunk.number});
  }
  for (const Action* const action : order_)
    if (action->wants_masses(state, step)) notice.wants_mass = 1;
  if (global_) {
    const auto growth = to_host(global_->watch().growth);
    for (std::size_t c = 0; c < growth.extent(0); ++c) notice.growth = std::max(notice.growth, growth(c));
  }
  return notice;
}

/// The one reduction of a step.
void Stepper::agree_on_step(State& state, StepWishes wishes) {
  StepNotice notice;
  {
    const Phase phase("percuss::reduce", clocks_.reduce);
    notice = find_notice(state);
    notice.stop = wishes.stop ? 1 : 0;
    notice.checkpoint = wishes.checkpoint ? 1 : 0;
    notice.frame = wishes.frame ? 1 : 0;
    notice.contact_rate = report_.rate;
    notice.died = some_died_ ? 1 : 0;
    reduction_(model_.ranks, notice);
  }
  agreed_ = {notice.stop != 0, notice.checkpoint != 0, notice.frame != 0};
  is_mass_wanted_ = notice.wants_mass != 0;
  const auto or_none = [](std::int64_t number) { return number == StepNotice::none ? -1 : number; };
  const double mesh_step = find_mesh_step(state, notice);
  // The square of the largest frequency of elements and springs together is at most the sum of the squares of both.
  // Without springs the bound of the elements keeps its bits.
  const double step =
      notice.contact_rate > 0 ? 1 / std::sqrt(1 / (mesh_step * mesh_step) + 0.25 * notice.contact_rate) : mesh_step;
  state.bound = {step,
                 notice.element,
                 notice.element_id,
                 or_none(notice.failed_element),
                 or_none(notice.broken_chunk),
                 notice.died != 0};
  for (const Action* const action : order_) action->limit_step(state, state.bound);
}

/// The bound of the elements, or what the whole mesh allows; an element that has failed ends the run anyhow.
double Stepper::find_mesh_step(const State& state, const StepNotice& notice) {
  if (!global_ || notice.failed_element != StepNotice::none) return notice.step;
  const Phase phase("percuss::estimate", clocks_.estimate);
  return global_->find_bound(state, notice.step, notice.growth);
}

const Approach* Stepper::find_limiting_approach(const State& state) const {
  const Approach& approach = contact_.approach();
  return approach.limits(deck_.time.step_scale * state.bound.step) ? &approach : nullptr;
}

double Stepper::find_undamped_bound(const State& state) const {
  const auto step = to_host(state.results.stable_step);
  double bounds[2] = {StepNotice{}.step, StepNotice{}.step};  // without and with it
  for (std::size_t c = 0; c < step.extent(0); ++c) {
    bounds[0] = std::min(bounds[0], step(c));
    bounds[1] = std::min(bounds[1], elements_.find_step(c, step(c)));
  }
  all_reduce(model_.ranks, Reduce::least, bounds);
  return bounds[1] < bounds[0] ? bounds[0] : 0;
}

void Stepper::choose_step(State& state) const {
  double dt = deck_.time.step_scale * state.bound.step;
  for (const Action* const action : order_) dt = std::min(dt, action->largest_step(state));
  if (state.step > 0 && dt > state.dt) {
    dt = dt > (1 + least_step_growth) * state.dt ? std::min(dt, largest_step_growth * state.dt) : state.dt;
  }
  dt = std::min(dt, contact_.approach().step);
  if (deck_.time.max_step) dt = std::min(dt, *deck_.time.max_step);
  state.next_dt = land(deck_.time.end - state.time, dt, state.dt);
}

}  // namespace percuss
