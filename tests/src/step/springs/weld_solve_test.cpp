// One weld: nodes of all kinds move as one body afterwards, with the momenta that they had.

#include "src/step/springs/weld_solve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace percuss {
namespace {

using Vector = Vector3<double>;
using Nodes = std::array<WeldNode, 2>;

class RandomNodes {
 public:
  Nodes make(bool first_turns, bool second_turns, bool apart) {
    Nodes nodes;
    for (std::size_t i = 0; i < 2; ++i) {
      WeldNode& node = nodes[i];
      const double mass = 1 + number_(generator_) * 0.5, inertia = 1 + number_(generator_) * 0.5;
      node.place = i == 0 || apart ? vector() : nodes[0].place;
      node.velocity = vector();
      node.inverse_mass = {1 / mass, 1 / mass, 1 / mass};
      node.turns = i == 0 ? first_turns : second_turns;
      if (!node.turns) continue;
      node.spin = vector();
      node.inverse_inertia = {1 / inertia, 1 / inertia, 1 / inertia};
    }
    return nodes;
  }

 private:
  Vector vector() { return {number_(generator_), number_(generator_), number_(generator_)}; }
  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
};

Vector find_momentum(const Nodes& nodes) {
  Vector sum{0, 0, 0};
  for (const WeldNode& node : nodes) sum = sum + (1 / node.inverse_mass.x) * node.velocity;
  return sum;
}

Vector find_angular_momentum(const Nodes& nodes) {
  Vector sum{0, 0, 0};
  for (const WeldNode& node : nodes) {
    sum = sum + cross(node.place, (1 / node.inverse_mass.x) * node.velocity);
    if (node.turns) sum = sum + (1 / node.inverse_inertia.x) * node.spin;
  }
  return sum;
}

double find_energy(const Nodes& nodes) {
  double sum = 0;
  for (const WeldNode& node : nodes) {
    sum += 0.5 / node.inverse_mass.x * dot(node.velocity, node.velocity);
    if (node.turns) sum += 0.5 / node.inverse_inertia.x * dot(node.spin, node.spin);
  }
  return sum;
}

double find_length(const Nodes& nodes) { return norm(nodes[1].place - nodes[0].place); }

}  // namespace

// A node that is held wholly beside one that is held along the weld: only its spin could bring the length back.
TEST(WeldSolve, LeavesAnAxisAlongWhichNeitherNodeMovesToWhatHoldsThem) {
  Nodes nodes;
  for (WeldNode& node : nodes) node.turns = true;
  nodes[1].place = {1e-7, 0, 1};
  nodes[1].inverse_mass = {1, 1, 0};
  nodes[1].inverse_inertia = {1, 1, 1};
  nodes[1].velocity = {0.1, 0, 0};
  const WeldImpulse impulse = join_nodes(nodes, 0.99, 1e-3);
  EXPECT_EQ(impulse.impulse.z, 0);
  EXPECT_LT(norm(impulse.impulse), 0.2);
  EXPECT_LT(norm(nodes[1].spin), 0.2);
}

TEST(WeldSolve, MakesOneBodyOfTwoNodesAndKeepsTheirMomenta) {
  RandomNodes random;
  for (int i = 0; i < 400; ++i) {
    const bool first = i % 2 == 0, second = i % 4 < 2, apart = i % 8 < 4;
    const Nodes before = random.make(first, second, apart);
    Nodes after = before;
    join_nodes(after, find_length(before), 1e-3);
    EXPECT_LT(norm(find_momentum(after) - find_momentum(before)), 1e-14);
    EXPECT_LT(norm(find_angular_momentum(after) - find_angular_momentum(before)), 1e-13);
    EXPECT_LE(find_energy(after), find_energy(before) + 1e-14);
    const Vector across = after[1].place - after[0].place, parting = after[1].velocity - after[0].velocity;
    if (first && second) {
      EXPECT_LT(norm(after[1].spin - after[0].spin), 1e-13);
    }
    if (first || second) {
      EXPECT_LT(norm(parting - cross(first ? after[0].spin : after[1].spin, across)), 1e-13);
    } else if (apart) {
      EXPECT_LT(std::abs(dot(parting, across)), 1e-14);
    } else {
      EXPECT_LT(norm(parting), 1e-14);
    }
  }
}

TEST(WeldSolve, ChangesNothingOfNodesThatMoveAsOne) {
  RandomNodes random;
  Nodes nodes = random.make(true, true, true);
  nodes[1].spin = nodes[0].spin;
  nodes[1].velocity = nodes[0].velocity + cross(nodes[0].spin, nodes[1].place - nodes[0].place);
  const WeldImpulse impulse = join_nodes(nodes, find_length(nodes), 1e-3);
  EXPECT_LT(norm(impulse.impulse), 1e-15);
  EXPECT_LT(norm(impulse.moment[0]) + norm(impulse.moment[1]), 1e-15);
}

// A held node has no inverse mass; of two that are held in a direction neither moves there.
TEST(WeldSolve, LeavesHeldDirectionsAsTheyAre) {
  RandomNodes random;
  Nodes nodes = random.make(false, false, false);
  nodes[0].velocity = {0, 0, 0};
  nodes[0].inverse_mass = {0, 0, 0};
  nodes[1].velocity = {3, 4, 5};
  nodes[1].inverse_mass = {0.5, 0.5, 0};
  const WeldImpulse impulse = join_nodes(nodes, 0, 1e-3);
  EXPECT_EQ(norm(nodes[0].velocity), 0);
  EXPECT_NEAR(nodes[1].velocity.x, 0, 1e-15);
  EXPECT_NEAR(nodes[1].velocity.y, 0, 1e-15);
  EXPECT_EQ(nodes[1].velocity.z, 5);
  EXPECT_NEAR(impulse.impulse.x, -6, 1e-14);
  EXPECT_EQ(impulse.impulse.z, 0);
}

// A weld that has grown longer comes back within a step.
// Nodes of mass 2 and rotary inertia 4, and of mass 8 that does not turn.
TEST(WeldSolve, ComparesImpulsesAndMomentsByTheEnergyThatTheyGive) {
  Nodes nodes;
  nodes[0].inverse_mass = {0.5, 0.5, 0.5};
  nodes[0].inverse_inertia = {0.25, 0.25, 0};
  nodes[0].turns = true;
  nodes[1].inverse_mass = {0.125, 0.125, 0.125};
  EXPECT_DOUBLE_EQ(find_impulse_size({{0, 4, 0}, {}}, nodes), std::sqrt(10));
  EXPECT_DOUBLE_EQ(find_impulse_size({{0, 0, 0}, {Vector{6, 0, 9}, Vector{0, 0, 0}}}, nodes), 3);
  nodes[0].velocity = {3, 0, 0};
  nodes[0].spin = {0, 1, 7};
  nodes[1].velocity = {0, 1, 0};
  EXPECT_DOUBLE_EQ(find_motion_size(nodes), std::sqrt(18 + 4 + 8));
}

TEST(WeldSolve, BringsItsLengthBack) {
  RandomNodes random;
  Nodes nodes = random.make(true, true, true);
  for (WeldNode& node : nodes) node.velocity = node.spin = {0, 0, 0};
  const double length = 0.999 * find_length(nodes), dt = 1e-3;
  join_nodes(nodes, length, dt);
  for (WeldNode& node : nodes) node.place = node.place + dt * node.velocity;
  EXPECT_NEAR(find_length(nodes), length, 1e-6 * length);
}

}  // namespace percuss
