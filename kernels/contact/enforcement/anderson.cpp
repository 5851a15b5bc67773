#include "kernels/contact/enforcement/anderson.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

using Vectors = Kokkos::View<double**, Kokkos::LayoutRight, MemSpace>;

Array<double> make(const std::string& label, int n) { return Array<double>(label, static_cast<std::size_t>(n)); }

/// The window as it is: differences in use, the one that is new, -1: none, and unknowns.
struct WindowSize {
  int count, fresh, n;
};

/// Dots of each difference with f, of each with the new one, and of f with itself.
void find_dots(const WindowSize& size, const Vectors& df, const Array<const double>& f,
               const Array<const double>& weight, const Array<double>& dots) {
  const int differences = size.count, last = size.fresh, unknowns = size.n;
  const Vectors of = df;
  const Array<const double> residual = f, factor = weight;
  const Array<double> out = dots;
  parallel_for(
      "contact::anderson_dots", RangeOf(ExecSpace(), 0, 2 * differences + 1), KOKKOS_LAMBDA(int d) {
        double sum = 0;
        if (d == 2 * differences) {
          for (int i = 0; i < unknowns; ++i) sum += factor(i) * residual(i) * residual(i);
        } else if (d < differences) {
          for (int i = 0; i < unknowns; ++i) sum += factor(i) * of(d, i) * residual(i);
        } else if (last >= 0) {
          for (int i = 0; i < unknowns; ++i) sum += factor(i) * of(d - differences, i) * of(last, i);
        }
        out(d) = sum;
      });
  Kokkos::fence();
}

/// g - sum gamma_i dg_i. on_device: scratch [gamma].
void subtract_differences(const std::vector<double>& gamma, const Vectors& dg, const Array<double>& on_device, int n,
                          const Array<double>& g) {
  const auto on_host = Kokkos::create_mirror_view(on_device);
  for (std::size_t d = 0; d < gamma.size(); ++d) on_host(d) = gamma[d];
  copy_values(on_device, on_host);
  const int count = static_cast<int>(gamma.size());
  const Array<const double> coefficients = on_device;
  const Vectors differences = dg;
  const Array<double> out = g;
  parallel_for(
      "contact::anderson_step", RangeOf(ExecSpace(), 0, n), KOKKOS_LAMBDA(int i) {
        double sum = 0;
        for (int d = 0; d < count; ++d) sum += coefficients(d) * differences(d, i);
        out(i) -= sum;
      });
}

/// to(slot, i) = now(i) - last(i).
void set_difference(const Vectors& to, int slot, const Array<const double>& now, const Array<const double>& last) {
  parallel_for(
      "contact::anderson_difference", RangeOf(ExecSpace(), 0, static_cast<int>(last.extent(0))),
      KOKKOS_LAMBDA(int i) { to(slot, i) = now(i) - last(i); });
}

}  // namespace

AndersonWindow::AndersonWindow(int n, const Array<const double>& weight)
    : n_(n),
      weight_(weight),
      df_("contact::anderson_df", width, static_cast<std::size_t>(n)),
      dg_("contact::anderson_dg", width, static_cast<std::size_t>(n)),
      f_(make("contact::anderson_f", n)),
      f_last_(make("contact::anderson_f_last", n)),
      g_last_(make("contact::anderson_g_last", n)),
      dots_(make("contact::anderson_dots", 2 * width + 1)),
      gram_(static_cast<std::size_t>(width * width)) {}

void AndersonWindow::store_difference(const Array<const double>& f, const Array<const double>& g) {
  if (has_last_) {
    set_difference(df_, next_, f, f_last_);
    set_difference(dg_, next_, g, g_last_);
  }
  copy_values(f_last_, f);
  copy_values(g_last_, g);
}

/// gamma of the normal equations by Cholesky; differences that depend on earlier ones get none.
std::vector<double> AndersonWindow::solve_coefficients(std::vector<double> x) const {
  constexpr double dependent = 1e-13;  // share of a difference's own square that is left of it
  const auto n = static_cast<std::size_t>(count_);
  const auto at = [](std::size_t i, std::size_t j) { return i * width + j; };
  std::vector<double> l(gram_);
  std::vector<char> used(n, 1);
  for (std::size_t j = 0; j < n; ++j) {
    double pivot = gram_[at(j, j)];
    for (std::size_t k = 0; k < j; ++k) pivot -= l[at(j, k)] * l[at(j, k)];
    used[j] = pivot > dependent * gram_[at(j, j)] ? 1 : 0;
    l[at(j, j)] = used[j] != 0 ? std::sqrt(pivot) : 1;
    for (std::size_t i = j + 1; i < n; ++i) {
      double sum = gram_[at(i, j)];
      for (std::size_t k = 0; k < j; ++k) sum -= l[at(i, k)] * l[at(j, k)];
      l[at(i, j)] = used[j] != 0 ? sum / l[at(j, j)] : 0;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= l[at(i, k)] * x[k];
    x[i] = used[i] != 0 ? x[i] / l[at(i, i)] : 0;
  }
  for (std::size_t i = n; i-- > 0;) {
    if (used[i] == 0) continue;
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= l[at(k, i)] * x[k];
    x[i] /= l[at(i, i)];
  }
  return x;
}

double AndersonWindow::accelerate(const Array<const double>& z, const Array<double>& g) {
  const Array<double> f = f_;
  parallel_for(
      "contact::anderson_f", RangeOf(ExecSpace(), 0, n_), KOKKOS_LAMBDA(int i) { f(i) = g(i) - z(i); });
  store_difference(f_, g);
  int fresh = -1;
  if (has_last_) {
    fresh = next_;
    next_ = (next_ + 1) % width;
    count_ = std::min(count_ + 1, width);
  }
  has_last_ = true;
  find_dots({count_, fresh, n_}, df_, f_, weight_, dots_);
  const auto host = to_host(dots_);
  const auto norm = std::sqrt(host(static_cast<std::size_t>(2 * count_)));
  if (count_ == 0) return norm;
  std::vector<double> right;
  for (int d = 0; d < count_; ++d) {
    right.push_back(host(static_cast<std::size_t>(d)));
    const double dot = host(static_cast<std::size_t>(count_ + d));
    gram_[static_cast<std::size_t>(d * width + fresh)] = gram_[static_cast<std::size_t>(fresh * width + d)] = dot;
  }
  subtract_differences(solve_coefficients(std::move(right)), dg_, dots_, n_, g);
  return norm;
}

}  // namespace percuss
