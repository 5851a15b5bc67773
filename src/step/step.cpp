#include "src/step/step.hpp"

#include <algorithm>

#include "kernels/core/contract.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/deck/contact_springs.hpp"
#include "src/step/phases.hpp"

namespace percuss {
namespace {

/// Bound of the speeds of nodes whose velocities have components of at most this magnitude; negative: not known.
double bound_speed(double component) {
  constexpr double root_of_3 = 1.7320508076;  // rounded up
  return component < 0 ? component : root_of_3 * component;
}

/// Nodes with a tensor that are held in some directions follow what is held in the others: their w(-1/2) in those, of
/// the spins w(0) of the start.
void mirror_followers(const State& state, const Rows3<double>& start) {
  const SpinInertia inertia = state.spin_inertia();
  const auto w = state.w, w_before = state.w_before;
  parallel_for(
      "percuss::mirror_followers", RangeOf(ExecSpace(), 0, static_cast<int>(inertia.tensors.node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int n = inertia.tensors.node(i);
        bool is_held = false;
        for (int k = 0; k < 3; ++k) is_held = is_held || !(inertia.inverse(n, k) > 0);
        for (int k = 0; k < 3 && is_held; ++k)
          if (inertia.inverse(n, k) > 0) w_before(n, k) = 2 * start(n, k) - w(n, k);
      });
}

/// Joins the lists of all actions, as list() gives them.
template <class Item, class List>
std::vector<Item> join_lists(const std::vector<Action*>& actions, const List& list) {
  std::vector<Item> all;
  for (Action* const action : actions) {
    const std::vector<Item> more = list(action);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace

Stepper::Stepper(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact)
    : deck_(deck),
      chunked_(chunked),
      model_(model),
      contact_(contact),
      halo_(model.ranks, model.halo),
      actions_(make_actions(deck, chunked, model, contact)),
      elements_(model),
      bookkeeper_(deck, model) {
  if (model.has_rotations) moment_halo_.emplace(model.ranks, model.halo);
  if (deck.time.step_estimate == TimeDeck::StepEstimate::global) {
    global_ = std::make_unique<GlobalStep>(chunked, model, deck.time.end, deck.time.step_scale);
  }
  for (const auto& action : actions_.all) order_.push_back(action.get());
}

void Stepper::start(State& state, StepWishes wishes) {
  set_switches(state);
  for (Action* const action : order_) action->start(state);
  compute_forces(state, 0);
  judge_elements(state, 0);
  agree_on_step(state, wishes);
  const double dt = std::min(deck_.time.step_scale * state.bound.step, deck_.time.end);  // rigid bodies have no bound
  if (contact_.is_active()) contact_.watch_start(state.x, state.v, dt);
  choose_step(state);
  bookkeeper_.start(state);
}

void Stepper::drop_vanished(State& state) {
  for (Action* const action : order_) action->drop_vanished(state);
  if (std::any_of(order_.begin(), order_.end(), [](const Action* action) { return action->adds_forces(); }))
    share_forces(state);
}

/// The forces at n into the slots of this rank and of others.
void Stepper::share_forces(State& state) {
  add_forces(state, state.time);
  halo_.begin(space_, state.slot_force);
  halo_.end();
  if (!moment_halo_) return;
  moment_halo_->begin(space_, state.slot_moment);
  moment_halo_->end();
}

void Stepper::set_switches(State& state) {
  if (!model_.switches.switches_conditions) return;
  for (Action* const action : order_) action->set_switches(state);
}

/// The forces at n are new, and so is the half of their work that the last step has booked.
void Stepper::switch_now(State& state, const std::vector<char>& happened) {
  const auto book = [&](double dt) {
    bookkeeper_.book_new_forces(state, dt, true);
    for (Action* const action : order_) action->book_forces(state, dt, state.time, true);
  };
  book(-state.dt);
  state.happened = happened;
  set_switches(state);
  for (Action* const action : order_) action->drop_vanished(state);
  share_forces(state);
  book(state.dt);
}

void Stepper::archive_actions(CheckpointArchive& archive, State& state) {
  for (Action* const action : order_) action->archive(archive, state);
}

void Stepper::resume(State& state) {
  for (Action* const action : order_) {
    action->resume(state);
    action->drop_vanished(state);
  }
  share_forces(state);
  choose_step(state);
}

void Stepper::archive(CheckpointArchive& archive) {
  bookkeeper_.archive(archive);
  if (global_) global_->archive(archive);
  if (!contact_.is_active()) return;
  archive.integer("contact/report/interactions", report_.interactions);
  archive.number("contact/report/candidates", report_.candidates);
  archive.integer("contact/report/iterations", report_.iterations);
  archive.number_or_infinity("contact/report/residual", report_.residual);
  archive.integer("contact/report/converged", report_.converged);
  if (may_have_contact_springs(deck_)) archive.number("contact/report/stored", report_.stored);
  if (deck_.contact.enforcement == ContactDeck::Enforcement::lagrange)
    archive.number_or_infinity("contact/report/complementarity", report_.complementarity);
  if (deck_.contact.has_failing_ties()) archive.number("contact/report/failed_ties", report_.failed_ties);
  archive.number("contact/report/deepest", report_.deepest);
  archive.number("contact/report/deepest_node", report_.deepest_node);
  contact_.archive(archive);
}

// Figure 1 of the paper. The explicit midpoint rule begins a step with the motion that the forces at n cause, and ends
// it with the forces at n+1, so that (1.6) to (1.9) come before (1.3) to (1.5). (1.1) comes after the step, where
// elements have died in it: Run::erode().
void Stepper::advance(State& state, StepWishes wishes) {
  PERCUSS_EXPECT(state.next_dt > 0 && state.bound.failed_element < 0);
  const double dt = state.next_dt;
  const StepTimes times{state.time, dt, 0.5 * (state.dt + dt)};
  const bool is_free = are_nodes_free();
  state.damped = {};
  for (Action* const action : order_) action->begin_step(state, times);
  if (is_free)
    integrate_free_motion(state, times);  // (1.2) with the positions at n+1
  else
    predict_motion(state, times);  // (1.2), (1.6) velocities without contact; contact forms x + dt v
  integrate_spins(state, times);
  resolve_contact(state, dt);  // (1.7) search, (1.8) detailed check, (1.9) enforcement
  follow_contact(state, times);
  book_motion(state, times);
  if (!is_free) accept_motion(state, dt);  // (1.2) positions at n+1
  for (Action* const action : order_) action->move(state, times);
  compute_forces(state, dt);  // (1.3) strain rate, (1.4) stress, (1.5) internal forces
  book_forces(state, dt);
  turn_inertia(state, dt);
  judge_elements(state, dt);
  state.time += dt;
  state.step += 1;
  state.dt = dt;
  agree_on_step(state, wishes);
  scale_masses(state);
  choose_step(state);
}

/// Whether nothing comes between the velocities of the nodes and their motion, and nothing requests their forces, or
/// for their places before they move: only elements, springs and gravity act on them.
bool Stepper::are_nodes_free() const {
  return !contact_.is_active() &&
         std::none_of(order_.begin(), order_.end(), [](const Action* action) { return action->comes_between(); });
}

/// Velocities at n+1/2 as they are without contact, conditions included. Contact requests the largest component: the
/// nodal update measures what it predicts, what changes velocities after it is measured again.
void Stepper::predict_motion(State& state, const StepTimes& times) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  const bool gives_gravity =
      std::any_of(order_.begin(), order_.end(), [](const Action* action) { return action->gives_gravity(); });
  const bool is_measured = contact_.is_active() && contact_.wants_speeds();
  const NodeForces forces{model_.nodes_to_slots, state.slot_force, state.inverse_mass,
                          gives_gravity ? Gravity{} : state.gravity};
  if (is_measured)
    predicted_component_ = predict_and_measure(space_, forces, times.dt_mean, state.force, state.v_before, state.v);
  else
    predict_velocities(space_, forces, times.dt_mean, state.force, state.v_before, state.v);
  for (Action* const action : order_) action->predict(state, times);
  if (state.step == 0) mirror_velocities(space_, state.v, state.v_before);
  for (Action* const action : order_) action->change_velocities(state, times);
  if (!is_measured) return;
  for (const Action* const action : order_) predicted_component_ = action->bound_component(state, predicted_component_);
}

void Stepper::accept_motion(State& state, double dt) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  if (contact_.is_active() && contact_.wants_speeds())
    moved_component_ = move_and_measure(space_, state.v, dt, state.x);
  else
    move_nodes(space_, state.v, dt, state.x);
}

void Stepper::book_motion(State& state, const StepTimes& times) {
  const Phase phase("percuss::book", clocks_.reduce);
  for (Action* const action : order_) action->book_motion(state, times);
  bookkeeper_.book_impulses(state, times.dt, times.dt_mean, report_.walls);  // gravity follows the momentum of all
}

void Stepper::book_forces(State& state, double dt) {
  const Phase phase("percuss::book", clocks_.reduce);
  bookkeeper_.book_new_forces(state, dt);
  for (Action* const action : order_) action->book_forces(state, dt, state.time + dt, false);
}

void Stepper::integrate_free_motion(State& state, const StepTimes& times) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  advance_free_nodes(space_, {model_.nodes_to_slots, state.slot_force, state.inverse_mass, state.gravity},
                     times.dt_mean, times.dt, state.v, state.x);
}

/// Rotations of the nodes of shells and beams as they are without ties: elements' moments and conditions act on them.
void Stepper::integrate_spins(State& state, const StepTimes& times) {
  if (!model_.has_rotations) return;
  const Phase phase("percuss::integrate_spins", clocks_.integrate);
  // Nodes of solids alone have no rotation. By the inertia of the start: nodes that erosion leaves empty move on.
  predict_velocities(space_, {model_.nodes_to_slots, state.slot_moment, state.inverse_inertia, {}, model_.inertia},
                     times.dt_mean, state.moment, state.w_before, state.w);
  if (state.spin_tensors.any()) predict_tensor_spins(space_, state.spin_inertia(), state.turning_nodes(times.dt));
  const bool are_followed = state.step == 0 && state.spin_tensors.any() && state.held_spins.count > 0;
  Rows3<double> start("percuss::first_spins", are_followed ? state.w.extent(0) : 0);
  if (are_followed) copy_values(start, state.w_before);
  if (state.step == 0) mirror_velocities(space_, state.w, state.w_before);
  for (Action* const action : order_) action->change_spins(state, times);
  if (are_followed) mirror_followers(state, start);
}

/// Their inertia turns with the nodes of beams, once elements and books have seen the spins of the step.
void Stepper::turn_inertia(State& state, double dt) {
  if (!state.spin_tensors.any()) return;
  const Phase phase("percuss::turn_inertia", clocks_.integrate);
  turn_tensors(space_, state.spin_inertia(), state.turning_nodes(dt));
}

void Stepper::resolve_contact(State& state, double dt) {
  if (!contact_.is_active()) return;
  const Vec3& center = model_.mass_center;
  const ContactMotion motion{
      state.x,
      state.v_before,
      state.v,
      state.answering_inverse_mass(),
      state.impulse,
      dt,
      {center[0], center[1], center[2]},
      actions_.rigid != nullptr ? actions_.rigid->inputs() : BodyInputs{},
      state.time,
      {state.w, state.w_before, state.answering_inverse_inertia(), state.inertia, state.tie_moment},
      bound_speed(predicted_component_),
      bound_speed(moved_component_),
      state.damped.growth};
  report_ = contact_.apply(motion);
  state.books.contact_work += report_.normal_work;
  state.books.friction_work += report_.friction_work;
}

PhaseClocks Stepper::read_clocks() const {
  PhaseClocks all = clocks_;
  if (!contact_.is_active()) return all;
  const ContactClocks spent = contact_.clocks();
  all.contact_rcb = spent.decomposition;
  all.contact_search = spent.search;
  all.contact_check = spent.check;
  all.contact_enforce = spent.enforce;
  return all;
}

/// Rigid bodies get the impulses of contact; welded nodes move as one, and constrained ones equally, whatever else acts
/// on them.
void Stepper::follow_contact(State& state, const StepTimes& times) {
  const Phase phase("percuss::follow_contact", clocks_.integrate);
  for (Action* const action : order_) action->follow_contact(state, times, contact_.is_active() ? &report_ : nullptr);
}

std::vector<Warning> Stepper::take_warnings() {
  return join_lists<Warning>(order_, [](Action* action) { return action->take_warnings(); });
}

std::vector<Warning> Stepper::list_start_warnings() const {
  return join_lists<Warning>(order_, [](const Action* action) { return action->list_start_warnings(); });
}

std::vector<std::string> Stepper::list_notes() const {
  return join_lists<std::string>(order_, [](const Action* action) { return action->list_notes(); });
}

std::vector<HistoryColumn> Stepper::list_columns() const {
  return join_lists<HistoryColumn>(order_, [](const Action* action) { return action->list_columns(); });
}

void Stepper::append_values(const State& state, std::vector<double>& row) {
  for (Action* const action : order_) action->append_values(state, row);
}

/// The next step keeps to the bounds of the lighter elements.
void Stepper::scale_masses(State& state) {
  if (!is_mass_wanted_ || state.bound.failed_element >= 0) return;
  const Phase phase("percuss::scale_masses", clocks_.reduce);
  for (Action* const action : order_) action->change_masses(state, bookkeeper_);
}

/// (1.3) to (1.5): all forces at n+1, in the slots. What other ranks wait for comes first, what needs no other rank
/// continues meanwhile.
void Stepper::compute_forces(State& state, double dt) {
  {
    const Phase phase("percuss::internal_force", clocks_.internal_force);
    const ElementMotion motion = find_motion(state, dt);
    elements_.prepare(state, motion);
    elements_.advance(state, *model_.sending, motion);
    for (Action* const action : order_) action->advance(state, dt);
    add_forces(state, state.time + dt);
    halo_.begin(space_, state.slot_force);
    if (moment_halo_) moment_halo_->begin(space_, state.slot_moment);
    elements_.advance(state, *model_.others, motion);
  }
  const Phase phase("percuss::halo", clocks_.halo);
  halo_.end();
  if (moment_halo_) moment_halo_->end();
}

/// At the start, where dt is 0, all elements are evaluated and none counts as settled: what other steppers have left
/// (those of a relaxation) is not what this one keeps, and laws that relax with time do not change yet.
ElementMotion Stepper::find_motion(const State& state, double dt) const {
  const Action* const asker = find_asker();
  const ElementBounds* const asked = asker != nullptr ? asker->asked_bounds() : nullptr;
  const StepWatch watch = global_ ? global_->watch() : asked != nullptr ? asked->watch : StepWatch{};
  const Array<double> others = asked != nullptr ? asked->others : Array<double>();
  const bool skips_rest = deck_.elements.skip_resting && dt > 0;
  return {state.x, state.v, dt, skips_rest, state.time + dt, watch, model_.failing, state.lives, state.w, others};
}

/// The action that requests the bounds of all elements; null: none.
const Action* Stepper::find_asker() const {
  const auto asker = std::find_if(order_.begin(), order_.end(),
                                  [](const Action* action) { return action->asked_bounds() != nullptr; });
  return asker == order_.end() ? nullptr : *asker;
}

Traffic Stepper::traffic() const {
  const Traffic of_forces = halo_.traffic(), of_elements = elements_.traffic();
  const Traffic of_moments = moment_halo_ ? moment_halo_->traffic() : Traffic{};
  return {of_forces.messages + of_moments.messages + of_elements.messages,
          of_forces.bytes + of_moments.bytes + of_elements.bytes};
}

void Stepper::judge_elements(State& state, double dt) {
  const Phase phase("percuss::failure", clocks_.internal_force);
  some_died_ = elements_.judge(state, dt, state.time + dt).died > 0;
}

void Stepper::add_forces(State& state, double time) {
  for (Action* const action : order_) action->add_forces(state, time);
}

}  // namespace percuss
