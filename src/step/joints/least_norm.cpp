#include "src/step/joints/least_norm.hpp"

#include <algorithm>
#include <cmath>

#include "src/index.hpp"

namespace percuss {
namespace {

/// Remainder of a row that depends on others, as a share of its diagonal: round-off is 1e-16.
constexpr double dependent = 1e-11;

}  // namespace

void LeastNormSolver::factorise(std::vector<double> matrix, int size) {
  size_ = size;
  rank_ = 0;
  scale_.assign(at(size), 0);
  pivots_.clear();
  factor_.assign(at(size * size), 0);
  for (int i = 0; i < size; ++i) {
    const double diagonal = matrix[at(i * size + i)];
    if (diagonal > 0) scale_[at(i)] = 1 / std::sqrt(diagonal);
  }
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) matrix[at(i * size + j)] *= scale_[at(i)] * scale_[at(j)];
  std::vector<double> left;
  for (int i = 0; i < size; ++i) left.push_back(matrix[at(i * size + i)]);
  while (rank_ < size && eliminate(matrix, left)) ++rank_;
  if (rank_ < size) factorise_normal();
}

/// One more column of L, of the row of which most is left. left: what L has not taken of the diagonal, -1: a pivot.
bool LeastNormSolver::eliminate(const std::vector<double>& matrix, std::vector<double>& left) {
  const int pivot = static_cast<int>(std::max_element(left.begin(), left.end()) - left.begin());
  if (!(left[at(pivot)] > dependent)) return false;
  const double root = std::sqrt(left[at(pivot)]);
  for (int i = 0; i < size_; ++i) {
    if (i == pivot || left[at(i)] < 0) continue;
    double rest = matrix[at(i * size_ + pivot)];
    for (int k = 0; k < rank_; ++k) rest -= factor(i, k) * factor(pivot, k);
    factor(i, rank_) = rest / root;
    left[at(i)] = std::max(0.0, left[at(i)] - factor(i, rank_) * factor(i, rank_));
  }
  factor(pivot, rank_) = root;
  left[at(pivot)] = -1;
  pivots_.push_back(pivot);
  return true;
}

void LeastNormSolver::factorise_normal() {
  const int r = rank_;
  normal_.assign(at(r * r), 0);
  for (int i = 0; i < r; ++i) {
    for (int j = 0; j <= i; ++j) {
      double sum = 0;
      for (int n = 0; n < size_; ++n) sum += factor(n, i) * factor(n, j);
      for (int k = 0; k < j; ++k) sum -= normal_[at(i * r + k)] * normal_[at(j * r + k)];
      normal_[at(i * r + j)] = i == j ? std::sqrt(sum) : sum / normal_[at(j * r + j)];
    }
  }
}

/// (L L^T)^-1 y of full rank.
void LeastNormSolver::solve_lower(std::vector<double>& y) const {
  for (int k = 0; k < size_; ++k) {
    const int row = pivots_[at(k)];
    for (int j = 0; j < k; ++j) y[at(row)] -= factor(row, j) * y[at(pivots_[at(j)])];
    y[at(row)] /= factor(row, k);
  }
  for (int k = size_; k-- > 0;) {
    const int row = pivots_[at(k)];
    for (int j = k + 1; j < size_; ++j) y[at(row)] -= factor(pivots_[at(j)], k) * y[at(pivots_[at(j)])];
    y[at(row)] /= factor(row, k);
  }
}

/// (L^T L)^-1 y.
void LeastNormSolver::solve_normal(std::vector<double>& y) const {
  const int r = rank_;
  for (int i = 0; i < r; ++i) {
    for (int k = 0; k < i; ++k) y[at(i)] -= normal_[at(i * r + k)] * y[at(k)];
    y[at(i)] /= normal_[at(i * r + i)];
  }
  for (int i = r; i-- > 0;) {
    for (int k = i + 1; k < r; ++k) y[at(i)] -= normal_[at(k * r + i)] * y[at(k)];
    y[at(i)] /= normal_[at(i * r + i)];
  }
}

std::vector<double> LeastNormSolver::solve(const std::vector<double>& b) const {
  std::vector<double> x(at(size_));
  for (int i = 0; i < size_; ++i) x[at(i)] = scale_[at(i)] * b[at(i)];
  if (rank_ == size_) {
    solve_lower(x);
  } else {  // L (L^T L)^-2 L^T b
    std::vector<double> y(at(rank_));
    for (int k = 0; k < rank_; ++k)
      for (int i = 0; i < size_; ++i) y[at(k)] += factor(i, k) * x[at(i)];
    solve_normal(y);
    solve_normal(y);
    for (int i = 0; i < size_; ++i) {
      x[at(i)] = 0;
      for (int k = 0; k < rank_; ++k) x[at(i)] += factor(i, k) * y[at(k)];
    }
  }
  for (int i = 0; i < size_; ++i) x[at(i)] *= scale_[at(i)];
  return x;
}

}  // namespace percuss
