#include "kernels/contact/enforcement/springs.hpp"

namespace percuss {
namespace {

/// Deeper nodes, as where the element behind a face is crushed, come back by this share of h a step: more may add
/// energy.
constexpr double recovery = 1e-3;

/// How far a row would go in deeper than its cushion, or than it is, if it ended the step at `gap`.
KOKKOS_INLINE_FUNCTION double find_excess(const ContactRow& row, double gap) {
  const double least = find_floor(row) - contact_limits::spring_cushion * row.size,
               reached = row.gap_start + recovery * row.size;
  return (reached < least ? reached : least) - gap;
}

/// The most by which a spring pushes less or more than by Hooke's law to settle its energy, share of that push.
constexpr double most_settled = 0.2;

/// The energy of a spring between two steps, k d d' / 2 with its depths at their ends.
KOKKOS_INLINE_FUNCTION double find_pair_energy(const ContactRow& row, double before, double after) {
  return before > 0 && after > 0 ? 0.5 * row.spring * before * after : 0;
}

/// Relative velocities of a row at n-1/2 and, without contact, at n+1/2.
struct RowVelocities {
  RowVelocity last, predicted;
  KOKKOS_INLINE_FUNCTION RowVelocities(const ContactRow& row, const RowNodes& at)
      : last(find_row_velocity(row, TouchedVelocity{at.v_before, row})),
        predicted(find_row_velocity(row, TouchedVelocity{at.v, row})) {}
};

/// Depths of a row at n and n-1, and the rates at which it grows deeper at n-1/2 and, without contact, at n+1/2.
struct SpringMotion {
  double depth = 0, before = 0, rate_before = 0, rate = 0;
};

KOKKOS_INLINE_FUNCTION SpringMotion find_motion(const ContactRow& row, const RowVelocities& v,
                                                const SpringTimes& times) {
  const Point3 &last = v.last.work, &predicted = v.predicted.work;
  // The motion of a wall moved it likewise.
  const double drift = (row.gap - row.gap_start) / times.dt - dot(row.gap_gradient, predicted);
  const double depth = find_floor(row) - row.gap_start, of_wall = row.kind == RowKind::wall ? drift : 0;
  return {depth, depth + times.before() * (dot(row.gap_gradient, last) + drift), -dot(row.normal, last) - of_wall,
          -dot(row.normal, predicted) - of_wall};
}

/// Whether the spring begins or ends in no step. Hooke's law then conserves the energy in even ones.
KOKKOS_INLINE_FUNCTION bool stays_pressed(double depth_before, double depth_after) {
  return depth_before >= 0 && depth_after >= 0;
}

/// The depth or stretch of a spring at n+1 and twice the mean of its rates, without its own push P; this takes dt D P
/// and D P.
struct FreeMotion {
  double depth = 0, speeds = 0;
};

/// Hooke's push k d(n) dt of a spring, and the most that it may push to settle its energy.
struct HookesPush {
  double pull = 0, impulse = 0, most = 0;  // pull: k d(n)
};

/// The push of a spring that begins: it takes from the sides what the spring then stores,
///     P (speeds - D P) / 2 = k d(n) d(n+1) / 2,    d(n+1) = depth - dt D P.
/// Hooke's where no push takes so much.
KOKKOS_INLINE_FUNCTION double find_first_push(const HookesPush& hooke, double stiffness, const FreeMotion& free,
                                              double dt) {
  if (!(free.depth > 0)) return 0;
  const double half = 0.5 * (free.speeds + dt * stiffness * hooke.pull);
  const double square = half * half - stiffness * hooke.pull * free.depth;
  const double sum = half + (square > 0 ? std::sqrt(square) : 0), most = square > 0 ? hooke.most : hooke.impulse;
  return hooke.pull * free.depth < most * sum ? hooke.pull * free.depth / sum : most;
}

/// The push that gives the sides all that the spring holds: P (speeds - D P) / 2 = -held.
KOKKOS_INLINE_FUNCTION double find_last_push(double held, double stiffness, double speeds) {
  const double square = speeds * speeds + 8 * stiffness * held;
  const double root = square > 0 ? std::sqrt(square) : 0;
  if (speeds > 0) return (speeds + root) / (2 * stiffness);
  return held > 0 ? 4 * held / (root - speeds) : 0;
}

/// Push of a spring besides Hooke's law, by which it takes what it owes and so holds k d(n) d(n+1) / 2. It waits for
/// that until the sides move: between bodies at rest the force is Hooke's.
KOKKOS_INLINE_FUNCTION double find_settlement(const ContactRow& row, const SpringMotion& motion, double hooke,
                                              double speeds) {
  constexpr double least_speed = 0.1;  // share of that which the push gives
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
  if (!(motion.before > 0)) return find_first_push({pull, hooke, hooke}, row.stiffness, free, times.dt);
  const double push = hooke + find_settlement(row, motion, hooke, free.speeds);
  const bool stays = free.depth >= times.dt * row.stiffness * push;
  return stays ? push : find_last_push(row.held, row.stiffness, free.speeds);
}

/// The stretch below which the energy of a spring of friction does not count, share of h: Hooke's law does for it,
/// which keeps bodies at rest that are.
constexpr double negligible_stretch = 1e-6;

KOKKOS_INLINE_FUNCTION double find_length(const double (&v)[2]) { return std::sqrt(v[0] * v[0] + v[1] * v[1]); }

/// The spring of friction along its stretch at n.
struct SlipMotion {
  double direction[2] = {0, 0};      // along the tangents
  double stretch = 0, before = 0;    // at n, and of n-1 after Coulomb's limit
  double predicted = 0, speeds = 0;  // stretch at n+1 and twice the mean of its rates, without contact
};

KOKKOS_INLINE_FUNCTION double find_along(const SlipMotion& slip, const ContactRow& row, const Point3& velocity) {
  return slip.direction[0] * dot(row.tangent[0], velocity) + slip.direction[1] * dot(row.tangent[1], velocity);
}

KOKKOS_INLINE_FUNCTION SlipMotion find_slip_motion(const ContactRow& row, const RowVelocities& v,
                                                   const SpringTimes& times) {
  SlipMotion slip;
  double stretch[2];
  for (int d = 0; d < 2; ++d)
    stretch[d] = row.slide[d] - times.dt * dot(find_slip_velocity(row, v.predicted), row.tangent[d]);
  slip.stretch = find_length(stretch);
  if (!(slip.stretch > 0)) return {};
  for (int d = 0; d < 2; ++d) slip.direction[d] = stretch[d] / slip.stretch;
  slip.before = slip.stretch - times.before() * find_along(slip, row, find_slip_velocity(row, v.last));
  slip.predicted = slip.direction[0] * row.slide[0] + slip.direction[1] * row.slide[1];
  slip.speeds = find_along(slip, row, v.last.work + v.predicted.work);
  return slip;
}

/// The push of the spring of friction against its stretch, before Coulomb's limit. Hooke's law takes from the sides
/// what the spring then stores, k s(n) s(n+1) / 2, as long as the stretch keeps its sign. Where it changes sign the
/// spring gives back what it holds and no more, and in the next step, as in its first one, takes what it then stores.
KOKKOS_INLINE_FUNCTION double find_slip_push(const ContactRow& row, const SlipMotion& slip, const FreeMotion& free,
                                             const SpringTimes& times) {
  constexpr double begins = 1e-3;  // share of the stretch: at n-1, in the first step, it differs from none by round-off
  const double pull = row.spring * slip.stretch, hooke = pull * times.dt_mean, stiffness = row.tangential_stiffness;
  if (slip.stretch < negligible_stretch * row.size || !(times.before() > 0)) return hooke;
  const double most = (1 + most_settled) * hooke;
  if (slip.before < begins * slip.stretch) return find_first_push({pull, hooke, most}, stiffness, free, times.dt);
  if (free.depth >= times.dt * stiffness * hooke) return hooke;
  const double last = find_last_push(find_pair_energy(row, slip.before, slip.stretch), stiffness, free.speeds);
  return last < most ? last : most;
}

KOKKOS_INLINE_FUNCTION void set_slip_push(const SlipMotion& slip, double push, RowImpulse& impulse) {
  for (int d = 0; d < 2; ++d) impulse.tangential[d] = -push * slip.direction[d];
}

/// Shortens the stretch at n to Coulomb's limit: to as much as pulls with the impulse of the step.
KOKKOS_INLINE_FUNCTION void shorten_stretch(const RowVelocities& v, const SpringTimes& times, ContactRow& row) {
  if (is_sticking(row)) return;
  const SlipMotion slip = find_slip_motion(row, v, times);
  const double lost = slip.stretch - find_length(row.impulse.tangential) / (row.spring * times.dt_mean);
  if (!(lost > 0)) return;
  for (int d = 0; d < 2; ++d) row.slide[d] -= lost * slip.direction[d];
}

KOKKOS_INLINE_FUNCTION void set_push(ContactRow& row, const RowImpulse& impulse) {
  row.impulse = row.previous = impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// The impulse of the springs of one row and, of the slip, what Coulomb's limit leaves.
KOKKOS_INLINE_FUNCTION RowImpulse push_row(ContactRow& row, const SpringMotion& motion, const SlipMotion& slip,
                                           const SpringTimes& times) {
  RowImpulse impulse;
  const FreeMotion free{find_floor(row) - row.gap, motion.rate_before + motion.rate};
  impulse.normal = find_spring_push(row, motion, free, times);
  if (slip.stretch > 0) set_slip_push(slip, find_slip_push(row, slip, {slip.predicted, slip.speeds}, times), impulse);
  limit_friction(row, impulse);
  // A node that enters by the end of the step is pushed in the next one: the contact must not be forgotten.
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

/// The stretch of a spring of friction that changes sign in this step or did in the last one [length].
KOKKOS_INLINE_FUNCTION double find_unsettled_slip(const ContactRow& row, const SlipMotion& slip,
                                                  const SpringTimes& times) {
  const double least = negligible_stretch * row.size;
  if (!(slip.stretch > least)) return 0;
  const double after = slip.predicted - times.dt * row.tangential_stiffness * find_length(row.impulse.tangential);
  return stays_pressed(slip.before + least, after + least) ? 0 : slip.stretch;
}

/// Pushes a row by its spring; returns by how much it is unsettled.
KOKKOS_INLINE_FUNCTION double start_row(ContactRow& row, const RowNodes& at, const SpringTimes& times) {
  const RowVelocities v(row, at);
  const SpringMotion motion = find_motion(row, v, times);
  const SlipMotion slip = row.friction > 0 ? find_slip_motion(row, v, times) : SlipMotion{};
  if (!(motion.depth > 0))
    row.held = 0;
  else if (!(row.held > 0))
    row.held = find_pair_energy(row, motion.before, motion.depth);
  set_push(row, push_row(row, motion, slip, times));
  const double pressed = find_unsettled(row, motion, times), rubbed = find_unsettled_slip(row, slip, times);
  return pressed > rubbed ? pressed : rubbed;
}

/// The push of the spring of friction with the pushes of all rows. pushed: velocity change by these.
KOKKOS_INLINE_FUNCTION void settle_slip(const ContactRow& row, const SlipMotion& slip, const RowVelocity& pushed,
                                        const SpringTimes& times, RowImpulse& impulse) {
  const double own = row.tangential_stiffness * find_length(row.impulse.tangential);
  const FreeMotion free{slip.predicted + times.dt * (find_along(slip, row, find_slip_velocity(row, pushed)) + own),
                        slip.speeds + find_along(slip, row, pushed.work) + own};
  set_slip_push(slip, find_slip_push(row, slip, free, times), impulse);
}

/// Change of the slip of a row by another impulse [length]; 0 where that does not count.
KOKKOS_INLINE_FUNCTION double find_slip_change(const ContactRow& row, const RowImpulse& impulse, double dt) {
  const double change[2] = {impulse.tangential[0] - row.impulse.tangential[0],
                            impulse.tangential[1] - row.impulse.tangential[1]};
  const double slip = dt * row.tangential_stiffness * find_length(change);
  return slip > negligible_stretch * row.size ? slip : 0;
}

/// Pushes a row anew after others have pushed; returns by how much its own depth or slip changes.
KOKKOS_INLINE_FUNCTION double settle_row(ContactRow& row, const RowNodes& at, const Rows3<const double>& dv,
                                         const SpringTimes& times) {
  const RowVelocities v(row, at);
  const SpringMotion motion = find_motion(row, v, times);
  const RowVelocity pushed = find_row_velocity(row, TouchedVelocity{dv, row});
  const double gap = row.gap + times.dt * dot(row.gap_gradient, pushed.work), own = row.stiffness * row.impulse.normal;
  const FreeMotion free{find_floor(row) - gap + times.dt * own,
                        motion.rate_before + motion.rate - dot(row.normal, pushed.work) + own};
  const double least = find_spring_push(row, motion, free, times);
  RowImpulse impulse = row.impulse;
  impulse.normal += find_excess(row, gap) / (times.dt * row.stiffness);
  if (impulse.normal < least) impulse.normal = least;
  const SlipMotion slip = row.friction > 0 ? find_slip_motion(row, v, times) : SlipMotion{};
  if (slip.stretch > 0) settle_slip(row, slip, pushed, times, impulse);
  limit_friction(row, impulse);
  const double moved = times.dt * row.stiffness * std::fabs(impulse.normal - row.impulse.normal);
  const double rubbed = find_slip_change(row, impulse, times.dt);
  set_push(row, impulse);
  return moved > rubbed ? moved : rubbed;
}

/// Least energy that a spring is said to hold, as a share of its energy by Hooke's law: a spring that has given all it
/// held has this. With 0 that would not be known.
constexpr double least_held = 1e-12;

/// Adds the energy that the sides have given the spring at n+1/2. A stop, which pushes more than a spring, keeps
/// nothing of it.
KOKKOS_INLINE_FUNCTION void book_row(ContactRow& row, const RowNodes& at, const Rows3<const double>& dv,
                                     const SpringTimes& times) {
  const RowVelocities v(row, at);
  const SpringMotion motion = find_motion(row, v, times);
  const Point3 pushed = find_work_velocity(row, TouchedVelocity{dv, row});
  const double gap = row.gap + times.dt * dot(row.gap_gradient, pushed);
  const double pair = find_pair_energy(row, motion.depth, find_floor(row) - gap);
  const double most = (1 + 1.001 * most_settled) * row.spring * motion.depth * times.dt_mean;
  const double taken = 0.5 * row.impulse.normal * (motion.rate_before + motion.rate - dot(row.normal, pushed));
  const bool is_spring = pair > 0 && row.impulse.normal <= most;
  const double held = is_spring ? row.held + taken : pair;
  row.held = held > least_held * pair ? held : least_held * pair;
  if (row.friction > 0) shorten_stretch(v, times, row);
}

}  // namespace

double push_springs(const WorkSpace& space, double scale, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  double unsettled = 0;
  parallel_reduce(
      "contact::push_springs", RangeOf(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        if (!row.has_spring || row.is_rigid) return;
        row.spring = row.is_held ? 0 : scale * find_spring(row, at.spring);
        if (!(row.spring > 0)) set_push(row, RowImpulse{});
        const double here = row.spring > 0 ? start_row(row, at, times) : 0;
        most = here > most ? here : most;
      },
      Kokkos::Max<double>(unsettled));
  return unsettled > 0 ? unsettled : 0;
}

double settle_springs(const WorkSpace& space, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  double change = 0;
  parallel_reduce(
      "contact::settle_springs", RangeOf(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        if (!(row.spring > 0 && row.stiffness > 0)) return;
        const double moved = settle_row(row, at, dv, times);
        most = moved > most ? moved : most;
      },
      Kokkos::Max<double>(change));
  return change > 0 ? change : 0;
}

void book_springs(const WorkSpace& space, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  parallel_for(
      "contact::book_springs", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        if (rows(r).spring > 0) book_row(rows(r), at, dv, times);
      });
}

}  // namespace percuss
