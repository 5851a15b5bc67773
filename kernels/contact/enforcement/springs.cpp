#include "kernels/contact/enforcement/springs.hpp"

namespace percuss {
namespace {

/// What is deeper, as the element behind a face is crushed, comes back by this share of h a step: more may add energy.
constexpr double recovery = 1e-3;

/// How far a row would go in deeper than its cushion, or than it is, if it ended the step at `gap`.
KOKKOS_INLINE_FUNCTION double find_excess(const ContactRow& row, double gap) {
  const double least = find_floor(row) - contact_limits::spring_cushion * row.size,
               reached = row.gap_start + recovery * row.size;
  return (reached < least ? reached : least) - gap;
}

/// The most by which a spring gives less or more than by Hooke's law to settle what it owes, share of that push.
constexpr double most_settled = 0.2;

/// The energy of a spring between two steps, k d d' / 2 with its depths at their ends.
KOKKOS_INLINE_FUNCTION double find_pair_energy(const ContactRow& row, double before, double after) {
  return before > 0 && after > 0 ? 0.5 * row.spring * before * after : 0;
}

/// Depths of a row at n and n-1, and the rates at which it grows deeper at n-1/2 and, without contact, at n+1/2.
struct SpringMotion {
  double depth = 0, before = 0, rate_before = 0, rate = 0;
};

KOKKOS_INLINE_FUNCTION SpringMotion find_motion(const ContactRow& row, const RowNodes& at, const SpringTimes& times) {
  const Point3 last = find_work_velocity(row, TouchedVelocity{at.v_before, row});
  const Point3 predicted = find_work_velocity(row, TouchedVelocity{at.v, row});
  // What moves a wall moved it likewise.
  const double drift = (row.gap - row.gap_start) / times.dt - dot(row.gap_gradient, predicted);
  const double depth = find_floor(row) - row.gap_start, of_wall = row.kind == RowKind::wall ? drift : 0;
  return {depth, depth + times.before() * (dot(row.gap_gradient, last) + drift), -dot(row.normal, last) - of_wall,
          -dot(row.normal, predicted) - of_wall};
}

/// Whether the spring begins or ends in no step. Hooke's law then conserves the energy in even ones.
KOKKOS_INLINE_FUNCTION bool stays_pressed(double depth_before, double depth_after) {
  return depth_before >= 0 && depth_after >= 0;
}

/// The depth of a row at n+1 and twice the mean of its rates, without its own push P; this takes dt D P and D P.
struct FreeMotion {
  double depth = 0, speeds = 0;
};

/// The push of a spring that begins: it takes from the sides what the spring then stores,
///     P (speeds - D P) / 2 = k d(n) d(n+1) / 2,    d(n+1) = depth - dt D P.
/// pull: k d(n).
KOKKOS_INLINE_FUNCTION double find_first_push(double pull, double stiffness, const FreeMotion& free,
                                              const SpringTimes& times) {
  if (!(free.depth > 0)) return 0;
  const double half = 0.5 * (free.speeds + times.dt * stiffness * pull);
  const double square = half * half - stiffness * pull * free.depth;
  const double hooke = pull * times.dt_mean, sum = half + (square > 0 ? std::sqrt(square) : 0);
  return pull * free.depth < hooke * sum ? pull * free.depth / sum : hooke;
}

/// The push that gives the sides all that the spring holds: P (speeds - D P) / 2 = -held.
KOKKOS_INLINE_FUNCTION double find_last_push(double held, double stiffness, double speeds) {
  const double square = speeds * speeds + 8 * stiffness * held;
  const double root = square > 0 ? std::sqrt(square) : 0;
  if (speeds > 0) return (speeds + root) / (2 * stiffness);
  return held > 0 ? 4 * held / (root - speeds) : 0;
}

/// What a spring pushes besides Hooke's law to take what it owes, and so to hold k d(n) d(n+1) / 2. It waits for that
/// until the sides move: of bodies at rest the force is Hooke's.
KOKKOS_INLINE_FUNCTION double find_settlement(const ContactRow& row, const SpringMotion& motion, double hooke,
                                              double speeds) {
  constexpr double least_speed = 0.1;  // of that which the push gives
  const double owed = row.held - find_pair_energy(row, motion.before, motion.depth);
  const double given = row.stiffness * hooke, both = speeds - given, slow = least_speed * given;
  if (motion.rate_before * motion.rate_before < slow * slow) return 0;
  const double most = most_settled * hooke, settled = -2 * owed * both / (both * both + slow * slow);
  return settled < -most ? -most : (settled < most ? settled : most);
}

/// The push of a spring. It takes from the sides what the spring then stores, k d(n) d(n+1) / 2 where both are pressed
/// and else nothing. What a change of the step leaves of that it takes in the next one (ContactRow::held).
KOKKOS_INLINE_FUNCTION double find_spring_push(const ContactRow& row, const SpringMotion& motion,
                                               const FreeMotion& free, const SpringTimes& times) {
  if (!(motion.depth > 0)) return 0;
  const double pull = row.spring * motion.depth, hooke = pull * times.dt_mean;
  if (!(row.stiffness > 0)) return hooke;
  if (!(motion.before > 0)) return find_first_push(pull, row.stiffness, free, times);
  const double push = hooke + find_settlement(row, motion, hooke, free.speeds);
  const bool stays = free.depth >= times.dt * row.stiffness * push;
  return stays ? push : find_last_push(row.held, row.stiffness, free.speeds);
}

KOKKOS_INLINE_FUNCTION void set_push(ContactRow& row, const RowImpulse& impulse) {
  row.impulse = row.previous = impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// The impulse of the springs of one row and, of the slip, what Coulomb's limit leaves.
KOKKOS_INLINE_FUNCTION RowImpulse push_row(ContactRow& row, const RowNodes& at, const SpringMotion& motion,
                                           const SpringTimes& times) {
  const double dt = times.dt, dt_mean = times.dt_mean;
  RowImpulse impulse;
  const FreeMotion free{find_floor(row) - row.gap, motion.rate_before + motion.rate};
  impulse.normal = find_spring_push(row, motion, free, times);
  if (row.friction > 0) {
    double step[2];
    for (int d = 0; d < 2; ++d) {
      step[d] = find_predicted_slide(row, at, d, dt);
      impulse.tangential[d] = -row.spring * dt_mean * (row.slide[d] - step[d]);
    }
    limit_friction(row, impulse);
    for (int d = 0; d < 2; ++d) row.slide[d] = step[d] - impulse.tangential[d] / (row.spring * dt_mean);
  }
  // What goes in by the end of the step is pushed in the next one: the contact must not be forgotten.
  if (row.gap < find_floor(row)) row.is_caught = true;
  return impulse;
}

/// How far a row would go beyond its cushion without other pushes, or beyond what its spring bears whole [length].
KOKKOS_INLINE_FUNCTION double find_unsettled(const ContactRow& row, const SpringMotion& motion,
                                             const SpringTimes& times) {
  const double excess = find_excess(row, row.gap), depth = motion.depth;
  if (!(depth > 0)) return excess;
  const double after = find_floor(row) - row.gap - times.dt * row.stiffness * row.spring * depth * times.dt_mean;
  const double most = excess > 0 ? excess : 0;
  return stays_pressed(motion.before, after) ? most : most + depth;
}

/// Pushes a row by its spring; returns by how much it is unsettled.
KOKKOS_INLINE_FUNCTION double start_row(ContactRow& row, const RowNodes& at, const SpringTimes& times) {
  const SpringMotion motion = find_motion(row, at, times);
  if (!(motion.depth > 0))
    row.held = 0;
  else if (!(row.held > 0))
    row.held = find_pair_energy(row, motion.before, motion.depth);
  set_push(row, push_row(row, at, motion, times));
  return find_unsettled(row, motion, times);
}

/// Pushes a row anew after others have pushed; returns by how much its own depth changes.
KOKKOS_INLINE_FUNCTION double settle_row(ContactRow& row, const RowNodes& at, const Rows3<const double>& dv,
                                         const SpringTimes& times) {
  const SpringMotion motion = find_motion(row, at, times);
  const Point3 pushed = find_work_velocity(row, TouchedVelocity{dv, row});
  const double gap = row.gap + times.dt * dot(row.gap_gradient, pushed), own = row.stiffness * row.impulse.normal;
  const FreeMotion free{find_floor(row) - gap + times.dt * own,
                        motion.rate_before + motion.rate - dot(row.normal, pushed) + own};
  const double least = find_spring_push(row, motion, free, times);
  RowImpulse impulse = row.impulse;
  impulse.normal += find_excess(row, gap) / (times.dt * row.stiffness);
  if (impulse.normal < least) impulse.normal = least;
  const double moved = times.dt * row.stiffness * std::fabs(impulse.normal - row.impulse.normal);
  limit_friction(row, impulse);
  set_push(row, impulse);
  return moved;
}

/// Of the energy by Hooke's law: what a spring has that has given all it held. With 0 that would not be known.
constexpr double least_held = 1e-12;

/// What the sides have given the spring at n+1/2. A stop, which pushes more than a spring, keeps nothing of it.
KOKKOS_INLINE_FUNCTION void book_row(ContactRow& row, const RowNodes& at, const Rows3<const double>& dv,
                                     const SpringTimes& times) {
  const SpringMotion motion = find_motion(row, at, times);
  const Point3 pushed = find_work_velocity(row, TouchedVelocity{dv, row});
  const double gap = row.gap + times.dt * dot(row.gap_gradient, pushed);
  const double pair = find_pair_energy(row, motion.depth, find_floor(row) - gap);
  const double most = (1 + 1.001 * most_settled) * row.spring * motion.depth * times.dt_mean;
  const double taken = 0.5 * row.impulse.normal * (motion.rate_before + motion.rate - dot(row.normal, pushed));
  const bool is_spring = pair > 0 && row.impulse.normal <= most;
  const double held = is_spring ? row.held + taken : pair;
  row.held = held > least_held * pair ? held : least_held * pair;
}

}  // namespace

template <class Space>
double push_springs(const Space& space, double scale, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  double unsettled = 0;
  Kokkos::parallel_reduce(
      "contact::push_springs", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        if (row.is_rigid) return;
        row.spring = row.is_held ? 0 : scale * find_spring(row, at.spring);
        if (!(row.spring > 0)) set_push(row, RowImpulse{});
        const double here = row.spring > 0 ? start_row(row, at, times) : 0;
        most = here > most ? here : most;
      },
      Kokkos::Max<double>(unsettled));
  return unsettled > 0 ? unsettled : 0;
}

template <class Space>
double settle_springs(const Space& space, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  double change = 0;
  Kokkos::parallel_reduce(
      "contact::settle_springs", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        if (!(row.spring > 0 && row.stiffness > 0)) return;
        const double moved = settle_row(row, at, dv, times);
        most = moved > most ? moved : most;
      },
      Kokkos::Max<double>(change));
  return change > 0 ? change : 0;
}

template <class Space>
void book_springs(const Space& space, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  Kokkos::parallel_for(
      "contact::book_springs", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        if (rows(r).spring > 0) book_row(rows(r), at, dv, times);
      });
}

#define PERCUSS_INSTANTIATE(Space)                                                          \
  template double push_springs(const Space&, double, const SpringTimes&, const RowSystem&); \
  template double settle_springs(const Space&, const SpringTimes&, const RowSystem&);       \
  template void book_springs(const Space&, const SpringTimes&, const RowSystem&);
PERCUSS_IN_EACH_SPACE(PERCUSS_INSTANTIATE)
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
