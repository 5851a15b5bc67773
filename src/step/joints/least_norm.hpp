#pragma once
// Solution of least norm of a small symmetric positive semidefinite system: rows may say the same twice.

#include <vector>

namespace percuss {

class LeastNormSolver {
 public:
  /// matrix: [row][column] of `size` rows, symmetric. Its rows are scaled to a diagonal of one; where nothing is left
  /// of one but a share of 1e-11, it depends on the others.
  void factorise(std::vector<double> matrix, int size);

  /// x with A x = b, where b is in the range of A: of all such x that with the least sum of a_ii x_i^2.
  std::vector<double> solve(const std::vector<double>& b) const;

  int rank() const { return rank_; }

 private:
  double& factor(int row, int column) {
    return factor_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)];
  }
  double factor(int row, int column) const {
    return factor_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)];
  }
  bool eliminate(const std::vector<double>& matrix, std::vector<double>& left);
  void factorise_normal();
  void solve_lower(std::vector<double>& y) const;
  void solve_normal(std::vector<double>& y) const;

  int size_ = 0, rank_ = 0;
  std::vector<double> scale_;   // 1 / sqrt(a_ii); 0: a row of zeros
  std::vector<int> pivots_;     // rows in the order of elimination
  std::vector<double> factor_;  // L with L L^T = the scaled matrix, rank_ columns
  std::vector<double> normal_;  // Cholesky factor of L^T L, [rank][rank]; only where rows depend on others
};

}  // namespace percuss
