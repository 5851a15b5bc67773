#pragma once
// One row of a ConeProblem: its correction with all others held, and how far it is from its conditions.

#include <cmath>

#include "kernels/contact/enforcement/cone_problem.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"

namespace percuss {

/// Whether a row has friction of its own: not if its twin has that of both.
KOKKOS_INLINE_FUNCTION bool has_friction(const ConeProblem& problem, int row) {
  return problem.first(row + 1) - problem.first(row) > 1 && problem.leader(row) < 0;
}

/// Whether a row holds its three directions both ways: its friction tells.
KOKKOS_INLINE_FUNCTION bool is_tied(const ConeProblem& problem, int row) {
  return problem.friction(row) >= contact_limits::no_friction_limit;
}

/// Coulomb's limit of a row's friction, that of its follower added.
KOKKOS_INLINE_FUNCTION double find_limit(const ConeProblem& problem, int row, const Array<double>& z) {
  const double own = problem.friction(row) * z(problem.first(row));
  const int other = problem.follower(row);
  return other < 0 ? own : own + problem.friction(other) * z(problem.first(other));
}

/// Diagonal block of a row.
struct ConeBlock {
  double normal = 0;                          // A of the push; 0: nothing moves the row
  double tangential = 0;                      // larger eigenvalue of the block of the tangents
  double t11 = 0, t12 = 0, t21 = 0, t22 = 0;  // that block
};

/// One row, or two that push the same nodes almost the same way, like a corner on a corner seen from both sides: the
/// block that is corrected at once.
struct RowTwins {
  int row = -1, twin = -1;                    // twin -1: none
  double a11 = 0, a12 = 0, a21 = 0, a22 = 0;  // A of the two pushes
};

KOKKOS_INLINE_FUNCTION double find_entry(const SparseMatrix& a, int row, int column) {
  for (int i = a.offset(row); i < a.offset(row + 1); ++i)
    if (a.column(i) == column) return a.value(i);
  return 0;
}

KOKKOS_INLINE_FUNCTION ConeBlock find_block(const ConeProblem& problem, int row) {
  const int f = problem.first(row);
  ConeBlock block;
  block.normal = find_entry(problem.a, f, f);
  if (problem.first(row + 1) - f == 1) return block;
  block.t11 = find_entry(problem.a, f + 1, f + 1);
  block.t12 = find_entry(problem.a, f + 1, f + 2);
  block.t21 = find_entry(problem.a, f + 2, f + 1);
  block.t22 = find_entry(problem.a, f + 2, f + 2);
  const double half = 0.5 * (block.t11 - block.t22), off = 0.5 * (block.t12 + block.t21);
  block.tangential = 0.5 * (block.t11 + block.t22) + std::sqrt(half * half + off * off);
  return block;
}

/// w of one unknown.
KOKKOS_INLINE_FUNCTION double find_velocity(const ConeProblem& problem, const Array<double>& z, int unknown) {
  double w = problem.b(unknown);
  for (int i = problem.a.offset(unknown); i < problem.a.offset(unknown + 1); ++i)
    w += problem.a.value(i) * z(problem.a.column(i));
  return w;
}

/// Shortens (t1, t2) to `limit`.
KOKKOS_INLINE_FUNCTION void project_on_disc(double limit, double& t1, double& t2) {
  const double length = std::sqrt(t1 * t1 + t2 * t2);
  if (!(length > limit)) return;
  t1 *= limit / length;
  t2 *= limit / length;
}

/// Back into the cone: the push, and when all rows have theirs, the friction, whose limit reads the push of the
/// follower too.
KOKKOS_INLINE_FUNCTION void project_push(const ConeProblem& problem, int row, const Array<double>& z) {
  const int f = problem.first(row);
  if (!(z(f) > 0) && !is_tied(problem, row)) z(f) = 0;
}
KOKKOS_INLINE_FUNCTION void project_friction(const ConeProblem& problem, int row, const Array<double>& z) {
  const int f = problem.first(row);
  if (has_friction(problem, row) && !is_tied(problem, row))
    project_on_disc(find_limit(problem, row, z), z(f + 1), z(f + 2));
}

/// State of a row in an iterate.
enum RowStatus : int { is_apart, sticks, slides };

KOKKOS_INLINE_FUNCTION int find_status(const ConeProblem& problem, int row, const Array<double>& z) {
  constexpr double inside = 1 - 1e-9;  // share of Coulomb's limit below which friction was not shortened
  if (is_tied(problem, row)) return sticks;
  const int f = problem.first(row);
  const bool pushes = z(f) > 0 || find_limit(problem, row, z) > 0;
  if (!pushes) return is_apart;
  if (!has_friction(problem, row)) return sticks;
  const double limit = inside * find_limit(problem, row, z);
  return z(f + 1) * z(f + 1) + z(f + 2) * z(f + 2) < limit * limit ? sticks : slides;
}

/// Longest share, at most 1, of the way from z to `to` on which the row keeps what it does: it pushes, it sticks.
KOKKOS_INLINE_FUNCTION double find_open_way(const ConeProblem& problem, int row, const Array<double>& z,
                                            const Array<double>& to) {
  if (is_tied(problem, row)) return 1;
  const int status = find_status(problem, row, z), f = problem.first(row);
  if (status == is_apart) return 1;
  double way = to(f) < 0 && z(f) > 0 ? z(f) / (z(f) - to(f)) : 1;
  if (status != sticks || !has_friction(problem, row)) return way;
  // |t + s dt|^2 = (p + s dp)^2, p the limit, for the least s > 0
  const double p = find_limit(problem, row, z), dp = find_limit(problem, row, to) - p;
  const double d1 = to(f + 1) - z(f + 1), d2 = to(f + 2) - z(f + 2);
  const double a = d1 * d1 + d2 * d2 - dp * dp, b = z(f + 1) * d1 + z(f + 2) * d2 - p * dp;
  const double c = z(f + 1) * z(f + 1) + z(f + 2) * z(f + 2) - p * p;  // < 0
  const double root = b * b - a * c;
  if (root < 0) return way;
  const double reach = -c / (b + std::sqrt(root));
  return reach > 0 && reach < way ? reach : way;
}

/// The friction that stops sliding, if Coulomb's limit allows; else the projected step, whose fixed points slide
/// against w.
KOKKOS_INLINE_FUNCTION void correct_friction(const ConeProblem& problem, const ConeBlock& block, int row,
                                             const Array<double>& z) {
  const int f = problem.first(row);
  const double limit = find_limit(problem, row, z);
  if (!(limit > 0) || !(block.tangential > 0)) {
    z(f + 1) = z(f + 2) = 0;
    return;
  }
  const double w1 = find_velocity(problem, z, f + 1), w2 = find_velocity(problem, z, f + 2);
  const double determinant = block.t11 * block.t22 - block.t12 * block.t21;
  constexpr double singular = 1e-10;  // share of the square of the eigenvalue: one direction is held
  if (determinant > singular * block.tangential * block.tangential) {
    const double t1 = z(f + 1) - (block.t22 * w1 - block.t12 * w2) / determinant;
    const double t2 = z(f + 2) - (block.t11 * w2 - block.t21 * w1) / determinant;
    if (t1 * t1 + t2 * t2 <= limit * limit) {
      z(f + 1) = t1;
      z(f + 2) = t2;
      return;
    }
  }
  z(f + 1) -= w1 / block.tangential;
  z(f + 2) -= w2 / block.tangential;
  project_on_disc(limit, z(f + 1), z(f + 2));
}

/// Meets the condition of one push with all else as it is.
KOKKOS_INLINE_FUNCTION void correct_push(const ConeProblem& problem, const ConeBlock& block, int row,
                                         const Array<double>& z) {
  const int f = problem.first(row);
  const double push = z(f) - find_velocity(problem, z, f) / block.normal;
  z(f) = push > 0 ? push : 0;
}

/// Scales the pushes of two twins so that both rows are met within `slack`, if their shares allow it: who pushes how
/// much is settled no finer than that.
KOKKOS_INLINE_FUNCTION bool keep_shares(const RowTwins& twins, double r, double s, double slack, double& p, double& q) {
  const double total = p + q;
  if (!(total > 0)) return false;
  const double share = p / total, rest = q / total;
  const double of_p = twins.a11 * share + twins.a12 * rest, of_q = twins.a21 * share + twins.a22 * rest;
  const double fresh = -(r + s) / (of_p + of_q), left_p = r + fresh * of_p, left_q = s + fresh * of_q;
  if (!(fresh > 0) || std::fabs(left_p) > slack || std::fabs(left_q) > slack) return false;
  p = fresh * share;
  q = fresh * rest;
  return true;
}

/// The pushes of two twins together, their 2 x 2 complementarity problem solved case by case: one after the other would
/// take the inverse square of the angle between them to settle who pushes.
KOKKOS_INLINE_FUNCTION void correct_twin_pushes(const ConeProblem& problem, const RowTwins& twins, double slack,
                                                const Array<double>& z) {
  constexpr double singular = 1e-13;  // share of the product of the diagonals: twins to round-off
  const int f = problem.first(twins.row), g = problem.first(twins.twin);
  const double a = twins.a11, b = twins.a12, c = twins.a21, d = twins.a22;
  const double r = find_velocity(problem, z, f) - (a * z(f) + b * z(g));
  const double s = find_velocity(problem, z, g) - (c * z(f) + d * z(g));
  if (keep_shares(twins, r, s, slack, z(f), z(g))) return;
  const double p = -r / a, q = -s / d;                  // if one pushes alone
  const double left_f = r + b * q, left_g = s + c * p;  // w of the other one then
  z(f) = z(g) = 0;
  if (p <= 0 && q <= 0) return;
  if (p > 0 && left_g >= 0) {
    z(f) = p;
    return;
  }
  if (q > 0 && left_f >= 0) {
    z(g) = q;
    return;
  }
  const double determinant = a * d - b * c;
  const double both_f = (b * s - d * r) / determinant, both_g = (c * r - a * s) / determinant;
  if (determinant > singular * a * d && both_f >= 0 && both_g >= 0) {
    z(f) = both_f;
    z(g) = both_g;
  } else if (q <= 0 || left_g >= left_f) {
    z(f) = p > 0 ? p : 0;
  } else {
    z(g) = q;
  }
}

/// Meets the conditions of a tie, one direction after the other; one that nothing moves stays.
KOKKOS_INLINE_FUNCTION void correct_tie(const ConeProblem& problem, int row, const Array<double>& z) {
  for (int i = problem.first(row); i < problem.first(row + 1); ++i) {
    const double diagonal = find_entry(problem.a, i, i);
    if (diagonal > 0) z(i) -= find_velocity(problem, z, i) / diagonal;
  }
}

/// Meets the conditions of one row, or of two twins, with all others as they are: pushes before friction.
KOKKOS_INLINE_FUNCTION void correct_twins(const ConeProblem& problem, const Array<const ConeBlock>& blocks,
                                          const RowTwins& twins, double slack, const Array<double>& z) {
  if (is_tied(problem, twins.row)) {
    correct_tie(problem, twins.row, z);
    return;
  }
  if (!(blocks(twins.row).normal > 0)) return;
  if (twins.twin < 0)
    correct_push(problem, blocks(twins.row), twins.row, z);
  else
    correct_twin_pushes(problem, twins, slack, z);
  if (has_friction(problem, twins.row)) correct_friction(problem, blocks(twins.row), twins.row, z);
}

/// Deviation from the conditions: the natural map z - P(z - w / D), as a velocity. Not a number where z is none.
KOKKOS_INLINE_FUNCTION double find_deviation(const ConeProblem& problem, const ConeBlock& block, int row,
                                             const Array<double>& z) {
  if (is_tied(problem, row)) {
    double most = 0;
    for (int i = problem.first(row); i < problem.first(row + 1); ++i) {
      const double w = find_entry(problem.a, i, i) > 0 ? std::fabs(find_velocity(problem, z, i)) : 0;
      if (!(w >= 0)) return w;
      most = w > most ? w : most;
    }
    return most;
  }
  if (!(block.normal > 0)) return 0;
  const int f = problem.first(row);
  const double w = find_velocity(problem, z, f), force = block.normal * z(f);
  const double of_push = std::fabs(w > force ? force : w);
  if (!(of_push >= 0) || !has_friction(problem, row) || !(block.tangential > 0)) return of_push;
  double t1 = z(f + 1) - find_velocity(problem, z, f + 1) / block.tangential;
  double t2 = z(f + 2) - find_velocity(problem, z, f + 2) / block.tangential;
  project_on_disc(find_limit(problem, row, z), t1, t2);
  t1 -= z(f + 1);
  t2 -= z(f + 2);
  const double of_friction = block.tangential * std::sqrt(t1 * t1 + t2 * t2);
  return of_friction < of_push ? of_push : of_friction;
}

}  // namespace percuss
