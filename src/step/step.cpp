#include "src/step/step.hpp"

#include <algorithm>

#include "kernels/beam/beam_failure.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/element/failure/failure.hpp"
#include "kernels/shell/shell_failure.hpp"
#include "src/step/phases.hpp"
#include "src/step/sensors/held_directions.hpp"

namespace percuss {
namespace {

/// Of the speeds of nodes, whose velocities have components of at most this magnitude; negative: not known.
double bound_speed(double component) {
  constexpr double root_of_3 = 1.7320508076;  // rounded up
  return component < 0 ? component : root_of_3 * component;
}

TurningNodes find_turning(const State& state, double dt) {
  return {state.w_before, state.w, state.moment, state.step == 0 ? 0 : state.dt, dt};
}

}  // namespace

Stepper::Stepper(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact)
    : deck_(deck),
      chunked_(chunked),
      model_(model),
      contact_(contact),
      halo_(model.ranks, model.halo),
      rigid_(model),
      bookkeeper_(deck, model),
      forces_(deck, chunked, model, contact),
      accelerometers_(deck, chunked, model),
      pressures_("percuss::pressures", model.pressures.size()),
      nodal_values_("percuss::nodal_values", model.nodal_values.size()) {
  if (model.has_rotations) moment_halo_.emplace(model.ranks, model.halo);
  std::vector<int> is_displacement;
  for (const Motion& motion : model.motions) is_displacement.push_back(motion.is_displacement ? 1 : 0);
  motions_ = {Array<double>("percuss::motion_values", model.motions.size()),
              to_view("percuss::is_displacement", is_displacement)};
  if (deck.time.step_estimate == TimeDeck::StepEstimate::global) {
    global_ = std::make_unique<GlobalStep>(chunked, model, deck.time.end, deck.time.step_scale);
  }
  if (model.springs.any()) springs_ = std::make_unique<SpringStage>(model);
  if (model.welds.any()) welds_ = std::make_unique<WeldStage>(model);
  if (model.constraints.any()) constraints_ = std::make_unique<ConstraintStage>(model);
  if (model.stiffness_damping.extent(0) > 0) stiffness_damping_ = std::make_unique<StiffnessDampingStage>(model);
  if (!model.dampings.empty()) damping_ = std::make_unique<DampingStage>(model);
  if (model.has_small_solids) tets_ = std::make_unique<TetStage>(model);
  if (model.scales_in_run) scaler_ = std::make_unique<MassScaler>(deck, chunked, model);
}

void Stepper::start(State& state, StepWishes wishes) {
  set_switches(state);
  // Held directions begin at their prescribed velocity; a displacement curve begins at rest.
  hold_conditions(state, 0);
  hold_spins(state, 0);
  rigid_.start(state);
  compute_forces(state, 0);
  judge_elements(state, 0);
  agree_on_step(state, wishes);
  const double dt = std::min(deck_.time.step_scale * state.bound.step, deck_.time.end);  // rigid bodies have no bound
  if (contact_.is_active()) contact_.watch_start(state.x, state.v, dt);
  choose_step(state);
  bookkeeper_.start(state);
}

void Stepper::renew_loads(State& state) {
  if (springs_) springs_->drop_vanished(state);
  if (welds_) welds_->drop_vanished(state);
  apply_loads(state, state.time);
  halo_.begin(space_, state.slot_force);
  halo_.end();
  if (moment_halo_) {
    moment_halo_->begin(space_, state.slot_moment);
    moment_halo_->end();
  }
}

void Stepper::set_switches(State& state) {
  if (!model_.switches.switches_conditions) return;
  set_held_directions(model_, state);
  rigid_.set_switches(state);
  forces_.renew_supports(state);
}

/// The forces at n are new, and so is the half of their work that the last step has booked.
void Stepper::switch_now(State& state, const std::vector<char>& happened) {
  const auto book = [&](double dt) {
    bookkeeper_.book_new_forces(state, dt, true);
    rigid_.book_rest(state, dt, state.time, true);
  };
  book(-state.dt);
  state.happened = happened;
  set_switches(state);
  renew_loads(state);
  book(state.dt);
}

void Stepper::archive_masses(CheckpointArchive& archive) {
  if (scaler_) scaler_->archive(archive);
}

void Stepper::restore_masses(State& state) {
  if (scaler_) scaler_->restore(state);
}

void Stepper::resume(State& state) {
  forces_.resume(state.time);
  accelerometers_.resume(state);
  renew_loads(state);
  choose_step(state);
}

void Stepper::archive(CheckpointArchive& archive) {
  bookkeeper_.archive(archive);
  forces_.archive(archive);
  accelerometers_.archive(archive);
  if (global_) global_->archive(archive);
  if (!contact_.is_active()) return;
  archive.integer("contact/report/interactions", report_.interactions);
  archive.number("contact/report/candidates", report_.candidates);
  archive.integer("contact/report/iterations", report_.iterations);
  archive.number_or_infinity("contact/report/residual", report_.residual);
  archive.integer("contact/report/converged", report_.converged);
  if (deck_.contact.enforcement == ContactDeck::Enforcement::penalty)
    archive.number("contact/report/stored", report_.stored);
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
  const double dt = state.next_dt;
  const double dt_mean = 0.5 * (state.dt + dt);
  const bool is_free = are_nodes_free();
  accelerometers_.begin_step(state);
  if (is_free)
    integrate_free_motion(state, dt, dt_mean);  // (1.2) with the positions at n+1
  else
    predict_motion(state, dt, dt_mean);  // (1.2), (1.6) velocities without contact; contact forms x + dt v
  integrate_spins(state, dt, dt_mean);
  resolve_contact(state, dt);  // (1.7) search, (1.8) detailed check, (1.9) enforcement
  rigid_.set_spins(state);
  join_nodes(state, dt, dt_mean);
  book_motion(state, dt, dt_mean);
  if (!is_free) accept_motion(state, dt);  // (1.2) positions at n+1
  accelerometers_.end_step(state, dt_mean);
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

/// Whether only elements, springs and gravity act on the nodes: then nothing comes between their velocities and their
/// motion, and nothing asks for their forces, or for their places before they move.
bool Stepper::are_nodes_free() const {
  return !contact_.is_active() && !rigid_.any() && model_.held.count == 0 && model_.pressure_faces.count == 0 &&
         model_.nodal_loads.count == 0 && !damping_ && !welds_ && !constraints_ && !forces_.has_sections();
}

/// Velocities at n+1/2 as they are without contact, conditions included.
void Stepper::predict_motion(State& state, double dt, double dt_mean) {
  integrate_motion(state, dt, dt_mean);
  hold_conditions(state, dt);
  if (contact_.is_active() && contact_.wants_speeds()) measure_predicted(state);
}

/// The nodal update has measured what it predicts; what changes velocities after it is measured again.
void Stepper::measure_predicted(const State& state) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  if (rigid_.any() || damping_)
    predicted_component_ = find_largest_component(space_, state.v);
  else if (state.held.count > 0)
    predicted_component_ =
        std::max(predicted_component_, find_largest_component(space_, state.held.node, state.held.count, state.v));
}

void Stepper::accept_motion(State& state, double dt) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  if (contact_.is_active() && contact_.wants_speeds())
    moved_component_ = move_and_measure(space_, state.v, dt, state.x);
  else
    move_nodes(space_, state.v, dt, state.x);
  rigid_.place(state);
}

void Stepper::book_motion(State& state, double dt, double dt_mean) {
  const Phase phase("percuss::book", clocks_.reduce);
  rigid_.book(state, dt, dt_mean);  // before gravity, which follows the momentum of all
  if (damping_) damping_->book(state);
  bookkeeper_.book_impulses(state, dt, dt_mean, report_.walls);
  forces_.book(state, dt_mean);
}

void Stepper::book_forces(State& state, double dt) {
  const Phase phase("percuss::book", clocks_.reduce);
  bookkeeper_.book_new_forces(state, dt);
  rigid_.book_rest(state, dt, state.time + dt);
}

void Stepper::integrate_free_motion(State& state, double dt, double dt_mean) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  advance_free_nodes(space_, {model_.nodes_to_slots, state.slot_force, state.inverse_mass, state.gravity}, dt_mean, dt,
                     state.v, state.x);
}

void Stepper::integrate_motion(State& state, double dt, double dt_mean) {
  const Phase phase("percuss::integrate", clocks_.integrate);
  if (damping_) damping_->begin_step(state.time);
  const NodeForces forces{model_.nodes_to_slots, state.slot_force, state.inverse_mass,
                          fictitious_ != nullptr ? Gravity{} : state.gravity};
  if (contact_.is_active() && contact_.wants_speeds())
    predicted_component_ = predict_and_measure(space_, forces, dt_mean, state.force, state.v_before, state.v);
  else
    predict_velocities(space_, forces, dt_mean, state.force, state.v_before, state.v);
  if (fictitious_ != nullptr) fictitious_->pull(state, dt_mean);
  if (rigid_.any()) rigid_.predict(state, dt, dt_mean, damping_ ? damping_->coefficients() : std::vector<double>());
  if (state.step == 0) mirror_velocities(space_, state.v, state.v_before);
  if (damping_) damping_->damp(state, dt_mean);
}

/// Rotations of the nodes of shells and beams as they are without ties: elements' moments and conditions act on them.
void Stepper::integrate_spins(State& state, double dt, double dt_mean) {
  if (!model_.has_rotations) return;
  {
    const Phase phase("percuss::integrate_spins", clocks_.integrate);
    // Nodes of solids alone have no rotation. By the inertia of the start: nodes that erosion leaves empty go on.
    predict_velocities(space_, {model_.nodes_to_slots, state.slot_moment, state.inverse_inertia, {}, model_.inertia},
                       dt_mean, state.moment, state.w_before, state.w);
    if (state.spin_tensors.any()) predict_tensor_spins(space_, state.spin_inertia(), find_turning(state, dt));
    if (state.step == 0) mirror_velocities(space_, state.w, state.w_before);
    if (damping_) damping_->damp_spins(state, dt_mean);
  }
  hold_spins(state, dt);
  if (state.spin_tensors.any() && state.held_spins.count > 0)
    follow_held_spins(space_, state.spin_inertia(), find_turning(state, dt));
}

/// Their inertia turns with the nodes of beams, once elements and books have seen the spins of the step.
void Stepper::turn_inertia(State& state, double dt) {
  if (!state.spin_tensors.any()) return;
  const Phase phase("percuss::turn_inertia", clocks_.integrate);
  turn_tensors(space_, state.spin_inertia(), find_turning(state, dt));
}

void Stepper::hold_spins(State& state, double dt) {
  if (state.held_spins.count == 0) return;
  const Phase phase("percuss::conditions", clocks_.integrate);
  evaluate_motions(state, dt);
  hold_velocities(space_, state.held_spins, motions_, state.x, dt > 0 ? dt : 1, state.w);
}

void Stepper::hold_conditions(State& state, double dt) {
  if (state.held.count == 0) return;
  const Phase phase("percuss::conditions", clocks_.integrate);
  evaluate_motions(state, dt);
  hold_velocities(space_, state.held, motions_, state.x, dt > 0 ? dt : 1, state.v);
}

/// Values of the prescribed motions for the step from n to n+1.
void Stepper::evaluate_motions(const State& state, double dt) {
  const auto values = Kokkos::create_mirror_view(motions_.value);
  for (std::size_t m = 0; m < model_.motions.size(); ++m) {
    const Motion& motion = model_.motions[m];
    values(m) = motion.curve(motion.is_displacement ? state.time + dt : state.time + 0.5 * dt);
    if (motion.is_displacement && dt == 0) values(m) = 0;  // at the start: at rest where the mesh put it
  }
  Kokkos::deep_copy(motions_.value, values);
}

void Stepper::resolve_contact(State& state, double dt) {
  if (!contact_.is_active()) return;
  const Vec3& center = model_.mass_center;
  const ContactMotion motion{state.x,
                             state.v_before,
                             state.v,
                             state.inverse_mass,
                             state.impulse,
                             dt,
                             {center[0], center[1], center[2]},
                             rigid_.inputs(),
                             state.time,
                             {state.w, state.w_before, state.inverse_inertia, state.inertia, state.tie_moment},
                             bound_speed(predicted_component_),
                             bound_speed(moved_component_)};
  report_ = contact_.apply(motion);
  if (rigid_.any()) rigid_.correct(state, report_.bodies, dt);
  state.books.contact_work += report_.normal_work;
  state.books.friction_work += report_.friction_work;
  const ContactClocks spent = contact_.clocks();
  clocks_.contact_rcb = spent.decomposition;
  clocks_.contact_search = spent.search;
  clocks_.contact_check = spent.check;
  clocks_.contact_enforce = spent.enforce;
}

/// Welded nodes move as one, and constrained ones equally, whatever else acts on them.
void Stepper::join_nodes(State& state, double dt, double dt_mean) {
  if (!welds_ && !constraints_) return;
  const Phase phase("percuss::welds", clocks_.integrate);
  if (welds_) welds_->join(state, dt, dt_mean);
  if (constraints_) constraints_->join(state, dt_mean);
}

std::vector<Warning> Stepper::take_warnings() {
  std::vector<Warning> taken = scaler_ ? scaler_->take_warnings() : std::vector<Warning>();
  if (!welds_) return taken;
  const std::vector<Warning> of_welds = welds_->take_warnings();
  taken.insert(taken.end(), of_welds.begin(), of_welds.end());
  return taken;
}

/// The next step keeps to the bounds of the lighter elements.
void Stepper::scale_masses(State& state) {
  if (!is_mass_wanted_ || state.bound.failed_element >= 0) return;
  const Phase phase("percuss::scale_masses", clocks_.reduce);
  scaler_->add(state, bookkeeper_);
}

/// (1.3) to (1.5): all forces at n+1, in the slots. What other ranks wait for comes first, what needs nobody goes on
/// meanwhile.
void Stepper::compute_forces(State& state, double dt) {
  {
    const Phase phase("percuss::internal_force", clocks_.internal_force);
    const ElementMotion motion = find_motion(state, dt);
    if (tets_) tets_->prepare(state, motion);
    advance_sending(state, motion);
    if (springs_) springs_->advance(state, dt);
    apply_loads(state, state.time + dt);
    halo_.begin(space_, state.slot_force);
    if (moment_halo_) moment_halo_->begin(space_, state.slot_moment);
    advance_others(state, motion);
  }
  const Phase phase("percuss::halo", clocks_.halo);
  halo_.end();
  if (moment_halo_) moment_halo_->end();
}

ElementMotion Stepper::find_motion(const State& state, double dt) const {
  const ElementBounds* const asked = find_asked_bounds();
  const StepWatch watch = global_ ? global_->watch() : asked != nullptr ? asked->watch : StepWatch{};
  return {state.x, state.v, dt, deck_.elements.skip_resting, state.time + dt, watch, model_.failing, state.lives};
}

void Stepper::advance_sending(State& state, const ElementMotion& motion) {
  advance_elements(space_, model_.chunks, model_.sending_blocks, motion, state.chunk_fields());
  if (tets_) tets_->advance(state, model_.sending_tet_blocks, model_.sending_one_point_blocks, motion);
  advance_shells_of(state, model_.sending_shell_blocks, motion);
  advance_beams_of(state, model_.sending_beam_block, motion);
  if (stiffness_damping_) stiffness_damping_->damp_sending(state, find_damped_motions(state, motion));
}

void Stepper::advance_others(State& state, const ElementMotion& motion) {
  advance_elements(space_, model_.chunks, model_.blocks, motion, state.chunk_fields());
  if (tets_) tets_->advance(state, model_.tet_blocks, model_.one_point_blocks, motion);
  advance_shells_of(state, model_.shell_blocks, motion);
  advance_beams_of(state, model_.beam_block, motion);
  if (stiffness_damping_) stiffness_damping_->damp_others(state, find_damped_motions(state, motion));
}

/// Where the launchers write the bounds of all elements; null: nobody asks.
const ElementBounds* Stepper::find_asked_bounds() const {
  if (scaler_) return &scaler_->bounds();
  return fictitious_ != nullptr ? &fictitious_->bounds() : nullptr;
}

Array<double> Stepper::find_other_bounds() const {
  const ElementBounds* const asked = find_asked_bounds();
  return asked != nullptr ? asked->others : Array<double>();
}

ShellMotion Stepper::find_shell_motion(const State& state, const ElementMotion& motion) const {
  return {state.x, state.v, state.w, motion.dt, motion.skips_rest, model_.failing, state.lives, find_other_bounds()};
}

void Stepper::advance_shells_of(State& state, const ShellBlocks& shells, const ElementMotion& motion) {
  if (!model_.has_rotations) return;
  advance_shells(space_, model_.chunks, shells, find_shell_motion(state, motion), state.chunk_fields());
}

BeamStep Stepper::find_beam_step(const State& state, const ElementMotion& motion) const {
  return {state.x, state.v, state.w, motion.dt, motion.skips_rest, find_other_bounds(), model_.failing, state.lives};
}

void Stepper::advance_beams_of(State& state, const BeamBlock& beams, const ElementMotion& motion) {
  if (!model_.has_beams) return;
  advance_beams(space_, model_.chunks, beams, find_beam_step(state, motion), state.chunk_fields());
}

DampedMotions Stepper::find_damped_motions(const State& state, const ElementMotion& motion) const {
  return {motion, find_shell_motion(state, motion), find_beam_step(state, motion)};
}

Traffic Stepper::traffic() const {
  Traffic sum = halo_.traffic();
  if (!tets_) return sum;
  const Traffic of_tets = tets_->traffic();
  return {sum.messages + of_tets.messages, sum.bytes + of_tets.bytes};
}

/// Which elements fail, which die.
void Stepper::judge_elements(State& state, double dt) {
  if (model_.failing.pack_count == 0) return;
  const Phase phase("percuss::failure", clocks_.internal_force);
  const FailingElements elements = state.failing_elements(model_.failing);
  const FailureCounts counts = find_failures(space_, model_.chunks, elements, dt, state.results);
  const FailureCounts of_shells =
      find_shell_failures(space_, model_.chunks, elements, model_.thickness_rules, dt, state.results);
  if (model_.has_beams)
    find_beam_failures(space_, model_.chunks, {model_.is_beam_chunk, model_.beam_block.parameters, state.time + dt},
                       elements, state.results);
  some_died_ = counts.died + of_shells.died > 0;
}

void Stepper::apply_loads(State& state, double time) {
  state.gravity = find_gravity(model_, time);
  apply_forces(state, time);
  if (springs_) springs_->apply(state);
  if (model_.pressure_faces.count == 0) return;
  const auto values = Kokkos::create_mirror_view(pressures_);
  for (std::size_t i = 0; i < model_.pressures.size(); ++i) {
    const auto entry = static_cast<std::size_t>(model_.pressure_entries[i]);
    values(i) = model_.switches.pressures[entry].is_on(state.happened) ? model_.pressures[i](time) : 0;
  }
  Kokkos::deep_copy(pressures_, values);
  apply_pressure(space_, state.pressure_faces, pressures_, state.x, state.slot_force);
}

void Stepper::apply_forces(State& state, double time) {
  if (model_.nodal_loads.count == 0) return;
  const auto values = Kokkos::create_mirror_view(nodal_values_);
  for (std::size_t i = 0; i < model_.nodal_values.size(); ++i) {
    const bool is_on = model_.switches.nodal_loads[i].is_on(state.happened);
    for (std::size_t k = 0; k < 6; ++k) values(i, k) = is_on ? model_.nodal_values[i][k](time) : 0;
  }
  Kokkos::deep_copy(nodal_values_, values);
  apply_nodal_loads(space_, state.nodal_loads, nodal_values_, state.slot_force, state.slot_moment);
}

}  // namespace percuss
