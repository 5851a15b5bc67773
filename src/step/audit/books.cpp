#include "src/step/audit/books.hpp"

#include "comm/exact_reduction.hpp"
#include "src/step/model/impulses.hpp"

namespace percuss {

namespace {

Vec3 round_total(const Communicator& ranks, std::array<ExactSum, 3> sums) {
  sum_over_ranks(ranks, sums);
  return {sums[0].round(), sums[1].round(), sums[2].round()};
}

/// The work of what holds a direction is what the kinetic energy gains and the other forces take over the step; this is
/// the part of it that is known before the elements are computed.
void book_conditions(const Model& model, ExactSums<7>& held_sums, State& state, double dt, double dt_mean) {
  if (state.owned_held.extent(0) == 0) return;
  const auto held = state.held;
  const auto owned = state.owned_held;
  const auto mass = state.mass;
  const Gravity gravity = state.gravity;
  const double share = model.gravity_varies ? 0.5 : 1;  // of the step: the other half is of that at n+1
  const auto x = state.x, v = state.v, v_before = state.v_before, force = state.force, impulse = state.impulse,
             welded = state.weld_impulse;
  const MomentCenter center(model.mass_center);
  const HeldReactions reactions = find_reactions(state, dt_mean);
  const auto sums = held_sums(
      ExecSpace(), static_cast<int>(owned.extent(0)), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        const int n = held.node(owned(i));
        const int k = held.direction(owned(i));
        const double m = mass(n), v_mean = 0.5 * (v(n, k) + v_before(n, k));
        double j[3] = {0, 0, 0};
        j[k] = reactions(owned(i));
        add(0, (m * (v(n, k) - v_before(n, k)) - impulse(n, k) - find_joined(welded, n, k)) * v_mean -
                   dt * v(n, k) * (0.5 * force(n, k) + share * m * gravity.g[k]));
        const double r[3] = {x(n, 0) - center.at[0], x(n, 1) - center.at[1], x(n, 2) - center.at[2]};
        add_impulse(r, j, 1, add);
      });
  add_work(sums[0], state.books);
  add_to_books(sums, 1, state.books);
}

/// Books held rotations: moment impulses without a lever.
void book_spin_conditions(ExactSums<7>& held_sums, State& state, double dt, double dt_mean) {
  if (state.owned_held_spins.extent(0) == 0) return;
  const auto owned = state.owned_held_spins;
  const HeldMoments moments = find_held_moments(state, dt_mean);
  const auto sums = held_sums(
      ExecSpace(), static_cast<int>(owned.extent(0)), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        const int n = moments.held.node(owned(i));
        const int k = moments.held.direction(owned(i));
        const double w = moments.w(n, k), moment = moments.moment(n, k);
        const double change = moments.find_gain(owned(i)) - moments.find_others(owned(i));
        add(0, 0.5 * change * (w + moments.w_before(n, k)) - 0.5 * dt * w * moment);
        add(4 + k, change - dt_mean * moment);
      });
  add_work(sums[0], state.books);
  add_to_books(sums, 1, state.books);
}

/// Held directions of velocities or of spins: those of this rank's own nodes, their motion at n+1/2, and the forces or
/// moments at n+1, in the slots and of gravity, if it varies.
struct HeldMotion {
  HeldDirections held;
  Array<int> owned;
  Rows3<double> velocity, slots;
  Array<double> inertia;
  Gravity gravity;
};

/// The rest of the work of held directions: half a step of what the forces, or moments, at n+1 take.
void book_rest_of_work(const Model& model, ExactSums<1>& held_force_sum, const HeldMotion& motion, double dt,
                       Books& books) {
  const HeldDirections held = motion.held;
  const Array<int> owned = motion.owned;
  if (!model.is_driven || owned.extent(0) == 0) return;
  const Rows3<double> velocity = motion.velocity, slots = motion.slots;
  const Array<double> inertia = motion.inertia;
  const Gravity gravity = motion.gravity;
  const auto nodes_to_slots = model.nodes_to_slots;
  const auto work = held_force_sum(
      ExecSpace(), static_cast<int>(owned.extent(0)), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        const int n = held.node(owned(i));
        const int k = held.direction(owned(i));
        double sum = inertia(n) * gravity.g[k];
        for (int s = nodes_to_slots.first(n); s < nodes_to_slots.first(n + 1); ++s) {
          sum += slots(nodes_to_slots.slots(s), k);
        }
        add(0, -0.5 * dt * velocity(n, k) * sum);
      });
  add_work(work[0], books);
}

/// Impulses of the pressure forces at n.
void book_pressure(ExactSums<6>& pressure_sums, State& state, double dt_mean) {
  if (state.pressure_faces.count == 0) return;
  const PressureSums of_runs = state.pressure_sums;
  const auto sums = pressure_sums(
      ExecSpace(), state.pressure_faces.run_count, KOKKOS_LAMBDA(const int r, const ExactAdder& add) {
        for (int k = 0; k < 6; ++k) add(k, dt_mean * of_runs(r, PressureSum::force + k));
      });
  add_to_books(sums, 0, state.books);
}

/// Half a step's work of the pressure forces at n+1, and of those at n, which were there before.
void book_pressure_work(ExactSums<1>& work_sum, State& state, double dt, bool counts_old) {
  if (state.pressure_faces.count == 0) return;
  const PressureSums of_runs = state.pressure_sums;
  const double half = 0.5 * dt, half_of_old = counts_old ? half : 0;
  const auto work = work_sum(
      ExecSpace(), state.pressure_faces.run_count, KOKKOS_LAMBDA(const int r, const ExactAdder& add) {
        add(0, half * of_runs(r, PressureSum::power) + half_of_old * of_runs(r, PressureSum::old_power));
      });
  add_work(work[0], state.books);
}

/// Work of the loads on node i of the list: that of its force and of its moment. w: only with shells.
KOKKOS_INLINE_FUNCTION double find_nodal_power(const NodalLoads& loads, int i, const Rows3<double>& slot_force,
                                               const Rows3<double>& slot_moment, const Rows3<double>& v,
                                               const Rows3<double>& w) {
  const int s = loads.first_slot + i, n = loads.node(i);
  double power = 0;
  for (int k = 0; k < 3; ++k) power += slot_force(s, k) * v(n, k);
  for (int k = 0; slot_moment.extent(0) > 0 && k < 3; ++k) power += slot_moment(s, k) * w(n, k);
  return power;
}

/// Impulses and the first half of the work of the loads on nodes at n.
void book_nodal_loads(const Model& model, ExactSums<7>& nodal_sums, State& state, double dt, double dt_mean) {
  const NodalLoads loads = state.nodal_loads;
  if (loads.count == 0) return;
  const auto x = state.x, v = state.v, w = state.w, slot_force = state.slot_force, slot_moment = state.slot_moment;
  const auto inertia = model.inertia;
  const MomentCenter center(model.mass_center);
  const auto sums = nodal_sums(
      ExecSpace(), loads.count, KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        const int s = loads.first_slot + i, n = loads.node(i);
        add(0, 0.5 * dt * find_nodal_power(loads, i, slot_force, slot_moment, v, w));
        const double j[3] = {dt_mean * slot_force(s, 0), dt_mean * slot_force(s, 1), dt_mean * slot_force(s, 2)};
        const double r[3] = {x(n, 0) - center.at[0], x(n, 1) - center.at[1], x(n, 2) - center.at[2]};
        add_impulse(r, j, 1, add);
        const bool turns = slot_moment.extent(0) > 0 && inertia(n) > 0;  // others do not feel a moment
        for (int k = 0; turns && k < 3; ++k) add(4 + k, dt_mean * slot_moment(s, k));
      });
  add_work(sums[0], state.books);
  add_to_books(sums, 1, state.books);
}

void book_nodal_power(ExactSums<1>& power_sum, State& state, double dt) {
  const NodalLoads loads = state.nodal_loads;
  if (loads.count == 0) return;
  const auto v = state.v, w = state.w, slot_force = state.slot_force, slot_moment = state.slot_moment;
  const auto work = power_sum(
      ExecSpace(), loads.count, KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        add(0, 0.5 * dt * find_nodal_power(loads, i, slot_force, slot_moment, v, w));
      });
  add_work(work[0], state.books);
}

}  // namespace

Bookkeeper::Bookkeeper(const Deck& deck, const Model& model) : deck_(deck), model_(model) {}

void Bookkeeper::start(const State& state) {
  const auto v = state.v;
  const auto mass = model_.mass;
  const Array<const int> body_of_node = model_.rigid.body_of_node;
  auto sums = OwnedNodeSums<3>("percuss::start_momentum")(
      ExecSpace(), model_.owned_nodes, KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 3>& sum) {
        if (RigidModel::holds(body_of_node, n)) return;
        for (int k = 0; k < 3; ++k) sum[k] += mass(n) * v(n, k);
      });
  for (std::size_t b = 0; model_.ranks.rank() == 0 && b < state.bodies.size(); ++b)
    for (int k = 0; k < 3; ++k)
      sums[static_cast<std::size_t>(k)].add(model_.rigid.bodies[b].mass * get(state.bodies[b].velocity, k));
  start_momentum_ = round_total(model_.ranks, sums);
  if (deck_.start.relaxation) note_center(state);
}

/// The mass centre of a scene that a relaxation has moved.
void Bookkeeper::note_center(const State& state) {
  const auto x = state.x, start = model_.start;
  const auto mass = state.mass;
  const Array<const int> body_of_node = model_.rigid.body_of_node;
  auto sums = OwnedNodeSums<3>("percuss::moved_center")(
      ExecSpace(), model_.owned_nodes, KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 3>& sum) {
        if (RigidModel::holds(body_of_node, n)) return;
        for (int k = 0; k < 3; ++k) sum[k] += mass(n) * (x(n, k) - start(n, k));
      });
  for (std::size_t b = 0; model_.ranks.rank() == 0 && b < state.bodies.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    for (int k = 0; k < 3; ++k)
      sums[static_cast<std::size_t>(k)].add(body.mass * (get(state.bodies[b].center, k) - get(body.center, k)));
  }
  center_shift_ = round_total(model_.ranks, sums);
  for (double& shift : center_shift_) shift /= state.total_mass;
}

void Bookkeeper::archive(CheckpointArchive& archive) {
  archive.numbers("books/start_momentum", start_momentum_);
  archive.numbers("books/center_shift", center_shift_);
  archive.number("books/wall_dt", wall_dt_);
  archive.sums("books/wall_impulse", wall_impulse_);
}

void Bookkeeper::book_impulses(State& state, double dt, double dt_mean, const WallSums& walls) {
  book_conditions(model_, held_sums_, state, dt, dt_mean);
  book_spin_conditions(held_sums_, state, dt, dt_mean);
  wall_dt_ = 0;
  if (!deck_.walls.empty()) {
    add_to_books(walls.impulse, walls.moment, state.books);
    wall_impulse_ = std::to_array(walls.impulse);
    wall_dt_ = dt;
    add_work(walls.work, state.books);
  }
  book_pressure(pressure_sums_, state, dt_mean);
  book_nodal_loads(model_, nodal_sums_, state, dt, dt_mean);
  book_gravity(state, dt, dt_mean);
}

/// Gravity acts on the mass centre, which moves with the momentum of all ranks: no sum over nodes. Rank 0 books it.
void Bookkeeper::book_gravity(State& state, double dt, double dt_mean) {
  const double* g = state.gravity.g;
  if (!model_.gravity_varies && g[0] == 0 && g[1] == 0 && g[2] == 0) return;
  const double weight = dt_mean * state.total_mass;
  const double r[3] = {center_shift_[0], center_shift_[1], center_shift_[2]};
  const double j[3] = {weight * g[0], weight * g[1], weight * g[2]};
  std::array<ExactSum, 6> sums{};
  if (model_.ranks.rank() == 0)
    add_impulse(r, j, 0, [&](int k, double v) { sums[static_cast<std::size_t>(k)].add(v); });
  add_to_books(sums, 0, state.books);
  const Vec3 impulse = round_total(model_.ranks, std::to_array(state.books.impulse));
  for (std::size_t k = 0; k < 3; ++k) momentum_now_[k] = start_momentum_[k] + impulse[k];
  book_gravity_work(state, dt);
  if (!(state.total_mass > 0)) return;
  for (std::size_t k = 0; k < 3; ++k) center_shift_[k] += dt * momentum_now_[k] / state.total_mass;
}

/// Half a step's work of gravity that varies, at n or at n+1, with the momentum at n+1/2.
void Bookkeeper::book_gravity_work(State& state, double dt) const {
  if (!model_.gravity_varies || model_.ranks.rank() != 0) return;
  for (std::size_t k = 0; k < 3; ++k) state.books.external_work.add(0.5 * dt * state.gravity.g[k] * momentum_now_[k]);
  state.books.external_work.normalize();
}

void Bookkeeper::book_new_forces(State& state, double dt, bool is_switch) {
  const Gravity gravity = model_.gravity_varies || is_switch ? state.gravity : Gravity{};
  book_rest_of_work(model_, held_force_sum_,
                    {state.held, state.owned_held, state.v, state.slot_force, state.mass, gravity}, dt, state.books);
  book_rest_of_work(model_, held_force_sum_,
                    {state.held_spins, state.owned_held_spins, state.w, state.slot_moment, state.inertia, {}}, dt,
                    state.books);
  book_gravity_work(state, dt);
  book_pressure_work(pressure_work_, state, dt, !is_switch);
  book_nodal_power(power_sum_, state, dt);
}

Vec3 Bookkeeper::find_wall_force() const {
  if (wall_dt_ == 0) return {};
  const Vec3 impulse = round_total(model_.ranks, wall_impulse_);
  return {impulse[0] / wall_dt_, impulse[1] / wall_dt_, impulse[2] / wall_dt_};
}

}  // namespace percuss
