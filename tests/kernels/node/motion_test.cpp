#include "kernels/node/motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace percuss::test::motion_test {

namespace {

/// Nodes with none to three slots, held directions among them; all values odd enough to round.
struct Scene {
  static constexpr int nodes = 7, slots = 9;
  NodeForces forces;
  Rows3<double> x{"x", nodes}, v{"v", nodes};

  Scene() {
    const int first[nodes + 1] = {0, 1, 3, 3, 6, 7, 8, 9};
    forces.nodes_to_slots = {Array<int>("first", nodes + 1), Array<int>("slots", slots)};
    const Rows3<double> slot_force("slot_force", slots), inverse_mass("inverse_mass", nodes);
    for (int n = 0; n <= nodes; ++n) forces.nodes_to_slots.first(n) = first[n];
    for (int s = 0; s < slots; ++s) {
      forces.nodes_to_slots.slots(s) = (5 * s) % slots;
      for (int k = 0; k < 3; ++k) slot_force(s, k) = 1.0 / (3 + s + 10 * k) - 0.05;
    }
    for (int n = 0; n < nodes; ++n) {
      for (int k = 0; k < 3; ++k) {
        x(n, k) = 1.0 / (1 + n + 7 * k);
        v(n, k) = 0.3 - 1.0 / (2 + n + 5 * k);
        inverse_mass(n, k) = (n + k) % 4 == 0 ? 0 : 1.0 / (0.7 + n);  // 0: held
      }
    }
    forces.slot_force = slot_force;
    forces.inverse_mass = inverse_mass;
    forces.gravity = {{0.1, 0, -9.81}};
  }
};

}  // namespace

TEST(Motion, VelocitiesFollowTheSumOfTheSlots) {
  Scene scene;
  const Rows3<double> force("force", Scene::nodes), before("before", Scene::nodes);
  const double held = scene.v(3, 1);
  predict_velocities(ExecSpace(), scene.forces, 0.25, force, before, scene.v);
  double sum = 0;
  for (int i = 3; i < 6; ++i) sum += scene.forces.slot_force(scene.forces.nodes_to_slots.slots(i), 1);
  EXPECT_EQ(force(3, 1), sum);
  EXPECT_EQ(before(3, 1), held);
  EXPECT_EQ(scene.v(3, 1), held);
  EXPECT_EQ(force(2, 0), 0);
  EXPECT_EQ(scene.v(1, 1), before(1, 1) + 0.25 * (force(1, 1) * scene.forces.inverse_mass(1, 1)));
}

TEST(Motion, NodesWithoutInertiaStay) {
  Scene all, some;
  const Rows3<double> force("force", Scene::nodes), before("before", Scene::nodes);
  const Rows3<double> force_of_all("force", Scene::nodes), before_of_all("before", Scene::nodes);
  const Array<double> inertia("inertia", Scene::nodes);
  for (int n = 0; n < Scene::nodes; ++n) inertia(n) = n == 1 ? 0 : 1;
  some.forces.inertia = inertia;
  const double v = some.v(1, 1);
  predict_velocities(ExecSpace(), all.forces, 0.25, force_of_all, before_of_all, all.v);
  predict_velocities(ExecSpace(), some.forces, 0.25, force, before, some.v);
  EXPECT_EQ(some.v(1, 1), v);
  EXPECT_EQ(force(1, 1), 0);
  EXPECT_EQ(before(1, 1), 0);
  EXPECT_NE(all.v(1, 1), v);
  for (const int n : {0, 2, 3}) EXPECT_EQ(some.v(n, 1), all.v(n, 1)) << n;
}

TEST(Motion, OnePassOverFreeNodesGivesTheBitsOfTwo) {
  Scene two, one;
  const Rows3<double> force("force", Scene::nodes), before("before", Scene::nodes);
  predict_velocities(ExecSpace(), two.forces, 0.37, force, before, two.v);
  move_nodes(ExecSpace(), two.v, 0.41, two.x);
  advance_free_nodes(ExecSpace(), one.forces, 0.37, 0.41, one.v, one.x);
  for (int n = 0; n < Scene::nodes; ++n) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(one.v(n, k), two.v(n, k));
      EXPECT_EQ(one.x(n, k), two.x(n, k));
    }
  }
}

TEST(Motion, MeasuredPassesMoveNodesAsTheOthersDo) {
  Scene plain, measured;
  const Rows3<double> force("force", Scene::nodes), before("before", Scene::nodes);
  predict_velocities(ExecSpace(), plain.forces, 0.37, force, before, plain.v);
  move_nodes(ExecSpace(), plain.v, 0.41, plain.x);
  const double predicted = predict_and_measure(ExecSpace(), measured.forces, 0.37, force, before, measured.v);
  const double moved = move_and_measure(ExecSpace(), measured.v, 0.41, measured.x);
  double largest = 0;
  for (int n = 0; n < Scene::nodes; ++n) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(measured.v(n, k), plain.v(n, k));
      EXPECT_EQ(measured.x(n, k), plain.x(n, k));
      largest = std::max(largest, std::abs(plain.v(n, k)));
    }
  }
  EXPECT_EQ(predicted, largest);
  EXPECT_EQ(moved, largest);
}

TEST(Motion, FindsTheLargestComponentWhereverItIs) {
  for (const int count : {1, 64, 100}) {
    const Rows3<double> v("v", static_cast<std::size_t>(count));
    const Array<int> all("all", static_cast<std::size_t>(count));
    EXPECT_EQ(find_largest_component(ExecSpace(), v), 0);
    Kokkos::deep_copy(v, 0.5);
    for (int n = 0; n < count; ++n) {
      all(n) = n;
      for (int k = 0; k < 3; ++k) {
        v(n, k) = -2;
        EXPECT_EQ(find_largest_component(ExecSpace(), v), 2);
        EXPECT_EQ(find_largest_component(ExecSpace(), all, n + 1, v), 2);
        EXPECT_EQ(find_largest_component(ExecSpace(), all, n, v), n == 0 ? 0 : 0.5);
        v(n, k) = 0.5;
      }
    }
  }
  EXPECT_EQ(find_largest_component(ExecSpace(), Rows3<double>("v", 0)), 0);
}

}  // namespace percuss::test::motion_test
