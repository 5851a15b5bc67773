#include "src/step/books.hpp"

namespace percuss {

namespace {

/// Adds the impulse j at position r (relative to the point of moments) to three sums of impulse and three of moment.
KOKKOS_INLINE_FUNCTION void add_impulse(const double (&r)[3], const double (&j)[3], double* sums) {
  for (int k = 0; k < 3; ++k) sums[k] += j[k];
  sums[3] += r[1] * j[2] - r[2] * j[1];
  sums[4] += r[2] * j[0] - r[0] * j[2];
  sums[5] += r[0] * j[1] - r[1] * j[0];
}

/// Adds K booked values, impulse first, to the books.
template <std::size_t K>
void add_to_books(const std::array<double, K>& sums, std::size_t first, double scale, Books& books) {
  for (std::size_t k = 0; k < 3; ++k) {
    books.impulse[k] += scale * sums[first + k];
    books.moment_impulse[k] += scale * sums[first + 3 + k];
  }
}

/// Whatever holds a direction gives J = m (v+ - v-) - dt_mean (f + m g) - P. Its work is what the kinetic energy gains
/// and the other forces take over the step; this is the part of it that is known before the elements are computed.
void book_conditions(const Model& model, const OrderedSum<7>& held_sum, State& state, double dt, double dt_mean) {
  if (model.held.count == 0) return;
  const auto held = model.held;
  const auto mass = model.mass;
  const auto gravity = model.gravity;
  const auto x = state.x, v = state.v, v_before = state.v_before, force = state.force, impulse = state.impulse;
  const Kokkos::Array<double, 3> center{{model.mass_center[0], model.mass_center[1], model.mass_center[2]}};
  const auto sums = held_sum(
      ExecSpace(), KOKKOS_LAMBDA(const int i, Kokkos::Array<double, 7>& sum) {
        const int n = held.node(i);
        const int k = held.direction(i);
        const double m = mass(n), v_mean = 0.5 * (v(n, k) + v_before(n, k));
        double j[3] = {0, 0, 0};
        j[k] = m * (v(n, k) - v_before(n, k)) - dt_mean * (force(n, k) + m * gravity.g[k]) - impulse(n, k);
        sum[0] += (m * (v(n, k) - v_before(n, k)) - impulse(n, k)) * v_mean -
                  dt * v(n, k) * (0.5 * force(n, k) + m * gravity.g[k]);
        const double r[3] = {x(n, 0) - center[0], x(n, 1) - center[1], x(n, 2) - center[2]};
        add_impulse(r, j, &sum[1]);
      });
  state.books.external_work += sums[0];
  add_to_books(sums, 1, 1.0, state.books);
}

/// The rest of the conditions' work: half a step of what the forces at n+1 take, which stand in the slots.
void book_condition_forces(const Model& model, const OrderedSum<1>& held_force_sum, State& state, double dt) {
  if (!model.is_driven) return;
  const auto held = model.held;
  const auto nodes_to_slots = model.nodes_to_slots;
  const auto v = state.v, slot_force = state.slot_force;
  const auto power = held_force_sum(
      ExecSpace(), KOKKOS_LAMBDA(const int i, Kokkos::Array<double, 1>& sum) {
        const int n = held.node(i);
        const int k = held.direction(i);
        double force = 0;
        for (int s = nodes_to_slots.first(n); s < nodes_to_slots.first(n + 1); ++s) {
          force += slot_force(nodes_to_slots.slots(s), k);
        }
        sum[0] += v(n, k) * force;
      });
  state.books.external_work -= 0.5 * dt * power[0];
}

Vec3 book_walls(const Model& model, const OrderedSum<6>& wall_sum, State& state, double dt) {
  const auto x = state.x, impulse = state.impulse;
  const Kokkos::Array<double, 3> center{{model.mass_center[0], model.mass_center[1], model.mass_center[2]}};
  const auto sums = wall_sum(
      ExecSpace(), KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 6>& sum) {
        const double j[3] = {impulse(n, 0), impulse(n, 1), impulse(n, 2)};
        const double r[3] = {x(n, 0) - center[0], x(n, 1) - center[1], x(n, 2) - center[2]};
        add_impulse(r, j, &sum[0]);
      });
  add_to_books(sums, 0, 1.0, state.books);
  return {sums[0] / dt, sums[1] / dt, sums[2] / dt};
}

/// Power, force and moment of the pressure forces that stand in the slots.
std::array<double, 7> sum_pressure(const Model& model, const OrderedSum<7>& pressure_sum, const State& state) {
  const PressureFaces faces = model.pressure_faces;
  const auto x = state.x, v = state.v, slot_force = state.slot_force;
  const Kokkos::Array<double, 3> center{{model.mass_center[0], model.mass_center[1], model.mass_center[2]}};
  return pressure_sum(
      ExecSpace(), KOKKOS_LAMBDA(const int f, Kokkos::Array<double, 7>& sum) {
        for (int i = 0; i < 4; ++i) {
          const int s = faces.first_slot + 4 * f + i;
          const int n = faces.nodes(f, i);
          const double share[3] = {slot_force(s, 0), slot_force(s, 1), slot_force(s, 2)};
          sum[0] += share[0] * v(n, 0) + share[1] * v(n, 1) + share[2] * v(n, 2);
          const double r[3] = {x(n, 0) - center[0], x(n, 1) - center[1], x(n, 2) - center[2]};
          add_impulse(r, share, &sum[1]);
        }
      });
}

/// Gravity acts on the mass centre, which moves with the momentum: no sum over nodes.
void book_gravity(const Model& model, const Vec3& start_momentum, double dt, double dt_mean, Vec3& center,
                  Books& books) {
  const double* g = model.gravity.g;
  if (g[0] == 0 && g[1] == 0 && g[2] == 0) return;
  const double weight = dt_mean * model.total_mass;
  books.moment_impulse[0] += weight * (center[1] * g[2] - center[2] * g[1]);
  books.moment_impulse[1] += weight * (center[2] * g[0] - center[0] * g[2]);
  books.moment_impulse[2] += weight * (center[0] * g[1] - center[1] * g[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    books.impulse[k] += weight * g[k];
    center[k] += dt * (start_momentum[k] + books.impulse[k]) / model.total_mass;
  }
}

}  // namespace

Bookkeeper::Bookkeeper(const Deck& deck, const Model& model)
    : deck_(deck),
      model_(model),
      held_sum_("percuss::held_sum", model.held.count),
      held_force_sum_("percuss::held_force_sum", model.is_driven ? model.held.count : 0),
      wall_sum_("percuss::wall_sum", deck.walls.empty() ? 0 : model.node_count),
      pressure_sum_("percuss::pressure_sum", model.pressure_faces.count) {}

void Bookkeeper::start(const State& state) {
  const auto v = state.v;
  const auto mass = model_.mass;
  momentum_ = OrderedSum<3>("percuss::start_momentum", model_.node_count)(
      ExecSpace(), KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 3>& sum) {
        for (int k = 0; k < 3; ++k) sum[k] += mass(n) * v(n, k);
      });
}

void Bookkeeper::book_impulses(State& state, double dt, double dt_mean, bool has_contact) {
  book_conditions(model_, held_sum_, state, dt, dt_mean);
  wall_force_ = {};
  if (has_contact && !deck_.walls.empty()) wall_force_ = book_walls(model_, wall_sum_, state, dt);
  if (model_.pressure_faces.count > 0) {
    const auto sums = sum_pressure(model_, pressure_sum_, state);
    state.books.external_work += 0.5 * dt * sums[0];
    add_to_books(sums, 1, dt_mean, state.books);
  }
  book_gravity(model_, momentum_, dt, dt_mean, center_shift_, state.books);
}

void Bookkeeper::book_new_forces(State& state, double dt) {
  book_condition_forces(model_, held_force_sum_, state, dt);
  if (model_.pressure_faces.count == 0) return;
  state.books.external_work += 0.5 * dt * sum_pressure(model_, pressure_sum_, state)[0];
}

}  // namespace percuss
