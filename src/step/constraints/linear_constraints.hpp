#pragma once
// Linear constraints of velocities, and the impulses by which unknowns with masses keep them.
//
// A row demands sum a_i v_i = rate. Its impulse p gives a_i p to each of its unknowns, so that rows without a rate do
// no work once they are met. The impulses of all rows solve B M^-1 B^T p = rate - B v.

#include <cstddef>
#include <vector>

#include "src/step/model/spring_model.hpp"

namespace percuss {

/// When the solution ends.
struct ConstraintLimits {
  double settled = 1e-15;  // what may be missing of a row, as a share of the largest speed
  int most_turns = 200;
};

double find_largest_amount(const std::vector<double>& all);

class LinearConstraints {
 public:
  explicit LinearConstraints(ConstraintLimits limits) : limits_(limits) {}

  /// Where the sum of the factors is zero, velocities count from that of the first term: equal ones leave no round-off.
  void add_row(const std::vector<ConstraintTerm>& terms);

  /// A loose row holds nothing.
  void set_loose(std::size_t row, bool is_loose) { is_loose_[row] = is_loose ? 1 : 0; }
  bool is_loose(std::size_t row) const { return is_loose_[row] != 0; }

  /// velocities, inverse_masses: [unknowns], an inverse mass of 0: it is held; rates: [rows], none: all zero. Least in
  /// energy where rows depend on each other.
  void solve(const std::vector<double>& velocities, const std::vector<double>& inverse_masses,
             const std::vector<double>& rates);

  std::size_t count() const { return first_.size() - 1; }
  const ConstraintTerm* begin(std::size_t row) const { return terms_.data() + first_[row]; }
  const ConstraintTerm* end(std::size_t row) const { return terms_.data() + first_[row + 1]; }

  /// sum a_i v_i of a row.
  double sum(std::size_t row, const std::vector<double>& of_unknowns) const;

  // Results of the last solve():
  const std::vector<double>& row_impulses() const { return found_; }  // [rows]
  const std::vector<double>& impulses() const { return impulse_; }    // [unknowns]

 private:
  void start(const std::vector<double>& velocities, const std::vector<double>& inverse_masses,
             const std::vector<double>& rates);
  void turn(const std::vector<double>& inverse_masses, double& before);
  void push(std::size_t row, double impulse, std::vector<double>& of_unknowns) const;

  ConstraintLimits limits_;
  std::vector<std::size_t> first_{0};  // [rows + 1] of terms_
  std::vector<ConstraintTerm> terms_;
  std::vector<char> is_loose_, is_balanced_;  // [rows]; balanced: its factors have the sum 0
  std::vector<double> diagonal_, missing_, search_, applied_, found_;
  std::vector<double> impulse_, moved_;
};

}  // namespace percuss
