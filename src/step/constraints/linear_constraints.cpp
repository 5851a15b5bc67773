#include "src/step/constraints/linear_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "src/index.hpp"

namespace percuss {
namespace {

double dot_all(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Whether the factors have the sum 0 but for round-off.
bool is_balanced(const std::vector<ConstraintTerm>& terms) {
  double sum = 0, size = 0;
  for (const ConstraintTerm& term : terms) {
    sum += term.factor;
    size += std::abs(term.factor);
  }
  return std::abs(sum) <= 1e-14 * size;
}

}  // namespace

double find_largest_amount(const std::vector<double>& all) {
  double most = 0;
  for (const double one : all) most = std::max(most, std::abs(one));
  return most;
}

void LinearConstraints::add_row(const std::vector<ConstraintTerm>& terms) {
  terms_.insert(terms_.end(), terms.begin(), terms.end());
  first_.push_back(terms_.size());
  is_loose_.push_back(0);
  is_balanced_.push_back(is_balanced(terms) ? 1 : 0);
  for (std::vector<double>* const of_rows : {&diagonal_, &missing_, &search_, &applied_, &found_})
    of_rows->push_back(0);
}

double LinearConstraints::sum(std::size_t row, const std::vector<double>& of_unknowns) const {
  const double base = is_balanced_[row] != 0 ? of_unknowns[at(begin(row)->unknown)] : 0;
  double all = 0;
  for (const ConstraintTerm* term = begin(row); term < end(row); ++term)
    all += term->factor * (of_unknowns[at(term->unknown)] - base);
  return all;
}

void LinearConstraints::push(std::size_t row, double impulse, std::vector<double>& of_unknowns) const {
  for (const ConstraintTerm* term = begin(row); term < end(row); ++term)
    of_unknowns[at(term->unknown)] += term->factor * impulse;
}

/// Residuals without impulses, and the diagonal of the system; 0: nothing can move.
void LinearConstraints::start(const std::vector<double>& velocities, const std::vector<double>& inverse_masses,
                              const std::vector<double>& rates) {
  impulse_.assign(velocities.size(), 0);
  moved_.assign(velocities.size(), 0);
  std::fill(search_.begin(), search_.end(), 0);
  for (std::size_t i = 0; i < count(); ++i) {
    diagonal_[i] = missing_[i] = found_[i] = 0;
    if (is_loose(i)) continue;
    for (const ConstraintTerm* term = begin(i); term < end(i); ++term)
      diagonal_[i] += term->factor * term->factor * inverse_masses[at(term->unknown)];
    if (diagonal_[i] > 0) missing_[i] = (rates.empty() ? 0 : rates[i]) - sum(i, velocities);
  }
}

/// A turn of conjugate gradients. before: of the turn before, the product of what is missing with itself, scaled.
void LinearConstraints::turn(const std::vector<double>& inverse_masses, double& before) {
  const auto scale = [&](std::size_t i) { return diagonal_[i] > 0 ? missing_[i] / diagonal_[i] : 0; };
  double now = 0;
  for (std::size_t i = 0; i < count(); ++i) now += missing_[i] * scale(i);
  for (std::size_t i = 0; i < count(); ++i) search_[i] = scale(i) + (before > 0 ? now / before : 0) * search_[i];
  before = now;
  std::fill(moved_.begin(), moved_.end(), 0);
  for (std::size_t i = 0; i < count(); ++i) push(i, search_[i], moved_);
  for (std::size_t n = 0; n < moved_.size(); ++n) moved_[n] *= inverse_masses[n];
  for (std::size_t i = 0; i < count(); ++i) applied_[i] = diagonal_[i] > 0 ? sum(i, moved_) : 0;
  const double curvature = dot_all(search_, applied_);
  const double step = curvature > 0 ? now / curvature : 0;
  if (step == 0) before = -1;
  for (std::size_t i = 0; i < count(); ++i) {
    found_[i] += step * search_[i];
    missing_[i] -= step * applied_[i];
  }
}

/// Conjugate gradients on B M^-1 B^T, scaled by its diagonal (Saad, Iterative Methods for Sparse Linear Systems, 2003,
/// algorithm 9.1).
void LinearConstraints::solve(const std::vector<double>& velocities, const std::vector<double>& inverse_masses,
                              const std::vector<double>& rates) {
  start(velocities, inverse_masses, rates);
  const double speed = std::max(find_largest_amount(velocities), find_largest_amount(rates));
  double before = 0;
  for (int i = 0; i < limits_.most_turns && before >= 0 && find_largest_amount(missing_) > limits_.settled * speed; ++i)
    turn(inverse_masses, before);
  for (std::size_t i = 0; i < count(); ++i)
    if (found_[i] != 0) push(i, found_[i], impulse_);
}

}  // namespace percuss
