// What a build with PERCUSS_MEMORY_APART finds: touches of the host, not those of kernels and copies.

#include <gtest/gtest.h>

#include <vector>

#include "kernels/core/host_copy.hpp"

namespace percuss::test::guarded_memory_test {
namespace {

class Guarded : public ::testing::Test {
 protected:
  const MemoryGuard guard_;
  const Array<double> view_ = to_view("test::view", std::vector<double>{1, 2, 3});
  const long before_ = MemoryGuard::count_touches();

  long touches() const { return MemoryGuard::count_touches() - before_; }
};

TEST_F(Guarded, KernelsAndCopiesMayTouchTheirMemory) {
  const Array<double> view = view_;
  double sum = 0;
  Kokkos::parallel_for(
      "test::double", Range(ExecSpace(), 0, 3), KOKKOS_LAMBDA(int i) { view(i) *= 2; });
  Kokkos::parallel_reduce(
      "test::sum", Range(ExecSpace(), 0, 3), KOKKOS_LAMBDA(int i, double& s) { s += view(i); }, sum);
  EXPECT_EQ(sum, 12);
  const auto host = to_host(view_);
  EXPECT_EQ(host(2), 6);
  Kokkos::deep_copy(view_, 5.0);
  EXPECT_EQ(to_host(view_)(0), 5);
  EXPECT_EQ(touches(), 0);
}

TEST_F(Guarded, TheHostIsFoundAndStillGetsTheValue) {
  EXPECT_EQ(view_(1), 2);
  EXPECT_EQ(touches(), 1);
  view_(1) = 7;
  EXPECT_EQ(touches(), 2);
  EXPECT_EQ(to_host(view_)(1), 7);
  EXPECT_EQ(touches(), 2);
}

TEST_F(Guarded, TypesOfBothMemoriesDiffer) {
  EXPECT_FALSE((std::is_same_v<Array<double>::memory_space, HostMirror<Array<double>>::memory_space>));
}

}  // namespace
}  // namespace percuss::test::guarded_memory_test
