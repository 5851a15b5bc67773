#include "src/step/relaxation/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Least share of the largest kinetic energy that translations must have had for spins to be taken as idle.
constexpr double least_moving = 0.1;
/// Shortest period of spins that count as idle, as a share of the steps so far.
constexpr double idle_periods = 10;
/// Steps between two checks of the motion.
constexpr long look_steps = 10;
/// Weight of an earlier check relative to the next.
constexpr double fading = 0.8;
/// Least steps for which the motion must stay below its tolerance.
constexpr long least_quiet_steps = 100;
/// A body of a joint that has moved this many half diagonals of the scene is not supported. Much farther away the
/// round-off of its place is more than what a joint keeps, and the joint would be torn apart.
constexpr double falls_beyond = 100;
/// Largest lack of a preload, relative to it, in a scene at rest.
constexpr double tolerated_preload_error = 1e-3;
/// A preload is stuck if its least lack falls by less than this share within progress_steps (or a share of the most
/// steps), and its layer gets shorter by less than this share of what it has got shorter so far.
constexpr double least_progress = 0.01;
constexpr long progress_steps = 5000, progress_checks = 20;
/// Shares of the length of a layer: what is less is no motion; what has lost more closes no gap.
constexpr double least_shortening = 1e-6, largest_shortening = 0.5;

bool has_contact_springs(const Deck& deck) { return deck.contact.enforcement == ContactDeck::Enforcement::penalty; }

Deck make_relaxed_deck(const Deck& deck) {
  if (!deck.start.relaxation) throw std::logic_error("a relaxation that the deck does not ask for");
  Deck relaxed = deck;
  relaxed.time.end = std::numeric_limits<double>::infinity();
  relaxed.time.step_estimate = TimeDeck::StepEstimate::element;
  relaxed.output.forces.clear();
  return relaxed;
}

Rows3<double> copy_to_zero(const Rows3<double>& from, const std::vector<int>& nodes) {
  const Rows3<double> to("percuss::relaxed_inverse", from.extent(0));
  const auto host = Kokkos::create_mirror_view(to);
  copy_values(host, from);
  for (const int n : nodes)
    for (std::size_t k = 0; k < 3; ++k) host(at(n), k) = 0;
  copy_values(to, host);
  return to;
}

}  // namespace

Relaxation::Relaxation(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact,
                       State& state)
    : rules_(*deck.start.relaxation),
      relaxed_deck_(make_relaxed_deck(deck)),
      chunked_(chunked),
      model_(model),
      relaxed_(model),
      contact_(contact),
      state_(state),
      inverse_mass_(state.inverse_mass),
      inverse_inertia_(state.inverse_inertia),
      masses_(chunked, model),
      sums_(model, has_contact_springs(deck) ? ContactForce::spring : ContactForce::constraint),
      preloads_(deck, chunked, model) {
  if (model.rigid.is_all)
    throw InputError(fmt::format("{}: error: start.relaxation has nothing to relax (all parts are rigid): leave it out",
                                 deck.where(deck.places.find("start.relaxation"))));
  make_model(deck);
  hold_nodes(deck);
  set_loads(0);
  stepper_ = std::make_unique<Stepper>(relaxed_deck_, chunked, relaxed_, contact);
  set_values(state.v, 0.0);
  if (model.has_rotations) set_values(state.w, 0.0);
  for (RigidState& body : state.bodies) body.velocity = body.spin = body.spin_momentum = {0, 0, 0};
  contact.begin_relaxation();
  give_masses();
  if (!preloads_.any()) return;
  start_lengths_ = preloads_.find_lengths(state);
  preloads_.measure_stiffness(state, [this] { stepper_->start(state_); });
  state.books = {};  // each start adds what springs hold
  stepper_->start(state);
}

/// Sets fictitious masses that give every element the same stable step. time.max_step is scaled accordingly. Damping
/// given in the deck acts with the physical masses.
void Relaxation::give_masses() {
  if (rules_.damping) return stepper_->start(state_);
  stepper_->act_first(masses_);
  stepper_->start(state_);
  const double growth = masses_.give(state_);
  if (relaxed_deck_.time.max_step) *relaxed_deck_.time.max_step *= growth;
  state_.books = {};  // each start adds what springs hold
  stepper_->start(state_);
}

/// Makes the model of the scene, but damped, at rest where it is driven, and without failure.
void Relaxation::make_model(const Deck& deck) {
  relaxed_.failing = {};
  relaxed_.can_erode = relaxed_.scales_in_run = relaxed_.is_driven = false;
  relaxed_.switches.switches_conditions = false;  // the state holds what is held at time 0
  for (SpringLaw& law : relaxed_.springs.laws) law.largest_force = law.largest_elongation = SpringLaw::unbreakable;
  for (WeldLaw& law : relaxed_.welds.laws) {
    law.strength = {};
    law.time = WeldLaw::unbreakable;
  }
  for (CohesiveLaw& law : relaxed_.glue.laws) law.normal_strength = law.shear_strength = CohesiveLaw::unbreakable;
  for (Motion& motion : relaxed_.motions) motion = {Curve::constant(0), false, {}};
  relaxed_.dampings = {Curve::constant(rules_.damping.value_or(0))};
  relaxed_.damped_nodes.entry = Array<int>("percuss::relaxed_nodes", at(model_.node_count));
  relaxed_.damped_bodies.assign(model_.rigid.bodies.size(), 0);
  relaxed_.gravity_varies = rules_.ramp > 0 && deck.gravity.any();
}

/// Nodes that stand still, and whole bodies of which one does.
void Relaxation::hold_nodes(const Deck& deck) {
  if (rules_.hold.empty()) return;
  const auto hold_at_rest = [](RigidBody& body) {
    body.motion.fill(0);  // row of the motions
    body.switched_by.fill(RigidBody::free);
  };
  std::vector<int> nodes, is_held(model_.rigid.bodies.size(), 0);
  const auto body_of_node = to_host(model_.rigid.body_of_node);
  for (const Selector& where : rules_.hold) {
    for (const int n : select_nodes(chunked_.mesh, deck, where)) {
      nodes.push_back(n);
      if (body_of_node.extent(0) > 0 && body_of_node(at(n)) >= 0) is_held[at(body_of_node(at(n)))] = 1;
    }
  }
  if (!is_held.empty()) all_reduce(model_.ranks, Reduce::largest, is_held);
  for (std::size_t b = 0; b < is_held.size(); ++b)
    if (is_held[b] != 0) hold_at_rest(relaxed_.rigid.bodies[b]);
  state_.inverse_mass = copy_to_zero(inverse_mass_, nodes);
  if (model_.has_rotations) state_.inverse_inertia = copy_to_zero(inverse_inertia_, nodes);
}

/// Fraction of the loads and preloads applied in this step.
double Relaxation::find_share(long step) const {
  return step >= rules_.ramp ? 1 : static_cast<double>(step) / static_cast<double>(rules_.ramp);
}

/// Sets that fraction of the loads of the run at time 0.
void Relaxation::set_loads(long step) {
  const double share = find_share(step);
  const auto scale = [&](const Curve& curve) { return Curve::constant(share * curve(0)); };
  for (std::size_t k = 0; k < 3; ++k) relaxed_.gravity[k] = scale(model_.gravity[k]);
  for (std::size_t i = 0; i < model_.pressures.size(); ++i) relaxed_.pressures[i] = scale(model_.pressures[i]);
  for (std::size_t i = 0; i < model_.nodal_values.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k) relaxed_.nodal_values[i][k] = scale(model_.nodal_values[i][k]);
}

void Relaxation::advance() {
  const double dt = state_.dt;
  if (state_.step < rules_.ramp) set_loads(state_.step + 1);
  stepper_->advance(state_);
  elapsed_ += state_.dt;
  state_.time = 0;
  if (state_.bound.failed_element >= 0 || state_.bound.broken_chunk >= 0) return;
  if (preloads_.any()) preloads_.tighten(state_, find_share(state_.step));
  const double dt_mean = 0.5 * (dt + state_.dt);
  if (state_.step % look_steps == look_steps - 1) sums_.keep(state_, dt_mean);
  if (state_.step % look_steps == 0) look(dt, dt_mean);
  if (preloads_.any() && state_.step > rules_.ramp) watch_preloads();
  report_.steps = state_.step;
}

/// Since the last check: whether a layer still gets shorter, as that of a bolt does which closes a gap and has no force
/// until then. One that nothing stops gets shorter for ever. Collective.
bool Relaxation::has_moving_layers() {
  const std::vector<double> before = std::exchange(lengths_, preloads_.find_lengths(state_));
  bool moves = false;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double start = start_lengths_[i], lost = std::abs(start - lengths_[i]);
    if (lost > largest_shortening * start) return false;
    moves = moves || std::abs(before[i] - lengths_[i]) > std::max(least_progress * lost, least_shortening * start);
  }
  return moves;
}

/// What is held and does not yield comes nearer in every period, or its layer gets shorter.
void Relaxation::watch_preloads() {
  const long every = std::max(progress_steps, rules_.max_steps / progress_checks), since = state_.step - rules_.ramp;
  const double lack = preloads_.largest_lack();
  lack_since_ = since == 1 ? lack : std::min(lack_since_, lack);
  if (since % every != 0) return;
  const bool moves = has_moving_layers(), is_first = since == every;
  const bool stagnates = !is_first && lack_since_ > (1 - least_progress) * least_lack_;
  is_stuck_ = stagnates && lack_since_ > tolerated_preload_error && !moves;
  least_lack_ = lack_since_;
  lack_since_ = lack;
}

/// dt: between the forces of the last two steps; dt_mean: what the last of them acted.
void Relaxation::look(double dt, double dt_mean) {
  MotionTotals totals = sums_.find(state_, dt_mean);
  totals.stored += find_contact_stored();
  power_ = fading * power_ + std::max(totals.power, 0.0) / dt;
  inertia_ = fading * inertia_ + totals.inertia;
  moving_power_ = fading * moving_power_ + std::max(totals.moving_power, 0.0) / dt;
  moving_inertia_ = fading * moving_inertia_ + totals.moving_inertia;
  frequency_ = inertia_ > 0 ? std::sqrt(power_ / inertia_) : 0;
  // Spins that nothing brings back would hide the frequency of the rest, and nothing would be damped.
  const bool is_drift = std::min(frequency_, find_spin_frequency()) * elapsed_ < 2 * std::numbers::pi;
  if (is_drift && moving_inertia_ > 0) frequency_ = std::max(frequency_, std::sqrt(moving_power_ / moving_inertia_));
  // What nothing brings back has no frequency; it is damped as what moves once in the whole time so far.
  if (!rules_.damping) relaxed_.dampings.front() = Curve::constant(2 * std::max(frequency_, 1 / elapsed_));
  judge(totals);
  refuse_falling_joints();
}

/// In free fall nothing comes to rest.
void Relaxation::refuse_falling_joints() const {
  for (const Joint& joint : model_.rigid.joints) {
    for (const JointEnd& end : joint.ends) {
      if (end.body == Joint::ground) continue;
      const RigidBody& body = model_.rigid.bodies[at(end.body)];
      const double way = norm(state_.bodies[at(end.body)].center - body.center);
      if (!(way > falls_beyond * model_.half_extent)) continue;
      throw RunError(
          fmt::format("body '{}' of joint '{}' has moved by {:.3g} after {} steps, more than {:g} times half "
                      "the diagonal of the scene (nothing supports it): support it, or name it in "
                      "start.relaxation.hold",
                      body.name, joint.name, way, state_.step, falls_beyond));
    }
  }
}

/// The Rayleigh quotient of the spins alone; without spins endless.
double Relaxation::find_spin_frequency() const {
  constexpr double round_off = 1e-12;
  const double inertia = inertia_ - moving_inertia_;
  if (!(inertia > round_off * inertia_)) return std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(power_ - moving_power_, 0.0) / inertia);
}

/// Whether the spins that are left are such as nothing brings back: no force changes by them. They keep a steady speed
/// for ever, where a moment of round-off or of warped elements drives them.
bool Relaxation::has_idle_spins() const {
  const bool is_of_nodes = largest_moving_ >= least_moving * largest_kinetic_ && moving_inertia_ > 0;
  return is_of_nodes && find_spin_frequency() * elapsed_ * idle_periods < 2 * std::numbers::pi;
}

/// At rest is what stays below the tolerance for half a period: a motion that turns back stands still for a moment.
void Relaxation::judge(const MotionTotals& totals) {
  const double moving = 0.5 * totals.moving_inertia;
  largest_kinetic_ = std::max(largest_kinetic_, totals.kinetic);
  largest_moving_ = std::max(largest_moving_, moving);
  report_.scale = std::max(largest_kinetic_, totals.stored);
  const double kinetic = has_idle_spins() ? std::min(moving, totals.kinetic) : totals.kinetic;
  report_.kinetic_ratio = report_.scale > 0 ? kinetic / report_.scale : 0;
  report_.frequency = frequency_ / (2 * std::numbers::pi);
  report_.preload_error = preloads_.largest_lack();
  const bool is_quiet = state_.step >= rules_.ramp && report_.kinetic_ratio <= rules_.tolerance;
  quiet_steps_ = is_quiet ? quiet_steps_ + look_steps : 0;
  const double half_period = frequency_ > 0 ? std::numbers::pi / (frequency_ * state_.dt) : 0;
  const double wanted =
      std::clamp(half_period, static_cast<double>(least_quiet_steps),
                 std::max(static_cast<double>(least_quiet_steps), 0.5 * static_cast<double>(state_.step)));
  const bool is_settled =
      static_cast<double>(quiet_steps_) >= wanted && report_.preload_error <= tolerated_preload_error;
  report_.state = is_settled ? "settled" : "unsettled";
}

void Relaxation::finish() {
  state_.time = 0;
  state_.step = 0;
  state_.dt = state_.next_dt = 0;
  masses_.take(state_);
  state_.inverse_mass = inverse_mass_;
  state_.inverse_inertia = inverse_inertia_;
  copy_values(state_.v, model_.start_velocity);
  if (model_.has_rotations) copy_values(state_.w, model_.start_spin);
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    state_.bodies[b].velocity = body.velocity;
    state_.bodies[b].spin = body.spin;
  }
  state_.books = {};
  constexpr int gone = WorkKind::viscous;
  Kokkos::deep_copy(Kokkos::subview(state_.results.work, Kokkos::ALL, gone), 0.0);
  set_values(state_.results.skipped, std::int64_t{0});
  if (contact_.is_active()) contact_.end_relaxation(state_.x);
}

Warning Relaxation::warn_unreached(std::size_t preload) const {
  const PreloadDeck& of = relaxed_deck_.start.preloads[preload];
  const std::string what = fmt::format("start.preload.{}.force", of.name);
  const std::string carries = of.point ? "its section carries" : fmt::format("a beam of '{}' carries", of.part);
  const std::string remedy =
      is_stuck_
          ? "lower the force below what the part can carry, or let conditions, contact or ties keep its ends apart"
          : "give start.relaxation.max_steps more; if the force does not grow, lower it, or keep the ends of the "
            "part apart";
  return {"unsettled_relaxation",
          fmt::format("preload '{}' is not reached in {} steps ({} {:.6g}, {} is {:g}; {}kinetic energy {:.2g} of the "
                      "scale): {}",
                      of.name, report_.steps, carries, preloads_.forces()[preload], what, of.force,
                      is_stuck_ ? "the force comes no nearer; " : "", report_.kinetic_ratio, remedy),
          relaxed_deck_.where(of.place), 0, 1};
}

Warning Relaxation::warn_unsettled() const {
  if (preloads_.any() && report_.preload_error > tolerated_preload_error && state_.step > rules_.ramp)
    return warn_unreached(preloads_.largest_lacking());
  return {"unsettled_relaxation",
          fmt::format("the relaxation is not at rest after {} steps (start.relaxation.tolerance is {:g}; {}): give "
                      "start.relaxation.max_steps more, a larger tolerance, or hold what nothing supports",
                      report_.steps, rules_.tolerance, describe()),
          "", 0, 1};
}

std::string Relaxation::describe() const {
  std::string text = fmt::format("kinetic energy {:.2g} of the scale", report_.kinetic_ratio);
  for (std::size_t i = 0; i < preloads_.forces().size(); ++i)
    text += fmt::format(", {} '{}' {:.6g}", relaxed_deck_.start.preloads[i].point ? "section" : "beams of",
                        relaxed_deck_.start.preloads[i].name, preloads_.forces()[i]);
  return text;
}

}  // namespace percuss
