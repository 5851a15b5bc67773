// What the iterated enforcement leaves after how many iterations, against the multipliers of the same rows: a stack of
// bricks and a staggered wall, one step. Prints the tables of docs/theory_contact.md.
//
// usage: compare_enforcements

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "tests/kernels/contact/enforcement/enforced_scene.hpp"

namespace {

using namespace percuss;
using namespace percuss::test;
using Scene = EnforcedScene<SmallSpace>;

constexpr double dt = 0.01;

/// n bricks on each other, each shifted by a part of its length, all falling on the lowest, which is held.
BrickScene make_stack(int n) {
  BrickScene bricks;
  for (int i = 0; i < n; ++i)
    bricks.add_brick({0.3 * (i % 2), 0.2 * (i % 3), 1.0 * i}, {1, 1, 1}, {0.02 * (i % 3), 0, i == 0 ? 0 : -0.1});
  for (std::size_t a = 0; a < 8; ++a) bricks.inverse_mass[a] = {0, 0, 0};
  return bricks;
}

double find_error(const Scene& scene, const Scene& exact) {
  double error = 0;
  for (int n = 0; n < scene.scene.surface.num_nodes; ++n) error = std::max(error, norm(scene.v(n) - exact.v(n)));
  return error / 0.1;
}

/// Milliseconds of the solution alone, the least of some.
template <class Run>
double time_least(const Run& run) {
  double least = 1e300;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run();
    least =
        std::min(least, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

void compare(const char* name, const BrickScene& bricks, double friction) {
  const Scene exact(bricks, dt, friction, Scene::no_walls(), Solver::together);
  const double prepare = time_least([&] { Scene(bricks, dt, friction, Scene::no_walls(), Solver::iterated, 1e9); });
  fmt::print("{}, friction {}: {} rows\n", name, friction, exact.system.num_rows);
  for (double tolerance = 1e-1; tolerance > 5e-9; tolerance /= 10) {
    const Scene scene(bricks, dt, friction, Scene::no_walls(), Solver::iterated, tolerance);
    const double ms = time_least([&] { Scene(bricks, dt, friction, Scene::no_walls(), Solver::iterated, tolerance); });
    fmt::print("  kinematic {:7.0e}: {:5} iterations, velocity error {:8.1e}, left over {:8.1e} h, {:8.2f} ms\n",
               tolerance, scene.solved.iterations, find_error(scene, exact), scene.sums.residual, ms - prepare);
  }
  const double ms = time_least([&] { Scene(bricks, dt, friction, Scene::no_walls(), Solver::together); });
  fmt::print("  lagrange         : {:5} sweeps, complementarity {:8.1e}, left over {:8.1e} h, {:8.2f} ms\n",
             exact.solved.iterations, exact.solved.complementarity, exact.sums.residual, ms - prepare);
}

}  // namespace

int main(int argc, char** argv) {
  Kokkos::initialize(argc, argv);
  for (const double friction : {0.0, 0.3}) {
    for (const int n : {4, 16, 64}) compare(fmt::format("stack of {}", n).c_str(), make_stack(n), friction);
    compare("wall of 8 x 8", make_brick_wall(8), friction);
  }
  Kokkos::finalize();
  return 0;
}
