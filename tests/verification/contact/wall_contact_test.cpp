// A rod strikes a rigid wall obliquely: no node goes through, not those inside it either.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/src/step/scene.hpp"

namespace percuss::test::wall_contact_test {
namespace {

TEST(WallContact, NoNodeOfAnObliqueRodGoesThrough) {
  Scene scene(R"(
time: {end: 1.2e-05}
parts:
  rod: {cylinder: {radius: 0.0032, length: 0.0324, cells: [8, 32]}, rotate: [{axis: y, angle: 30}], at: [0, 0, 0.001601], material: cu}
materials:
  cu: {model: j2_plasticity, density: 8970, youngs_modulus: 110e9, poissons_ratio: 0.3, yield_stress: 314e6}
initial: [{part: rod, velocity: [-170, 0, -294.4486372867092]}]
walls: [{normal: z, friction: 0.2}]
)");
  scene.contact.prepare(scene.state.x, scene.state.v);
  scene.stepper.start(scene.state);
  const double initial = 0.5 * scene.model.total_mass * (170.0 * 170 + 294.4486372867092 * 294.4486372867092);
  double lowest = 0;
  while (scene.state.time < scene.deck.time.end) {
    scene.stepper.advance(scene.state);
    ASSERT_LT(scene.state.bound.failed_element, 0);
    const auto x = to_host(scene.state.x);
    for (std::size_t n = 0; n < x.extent(0); ++n) lowest = std::min(lowest, x(n, 2));
  }
  EXPECT_GT(lowest, -1e-3 * 0.0004);  // of an element
  EXPECT_LT(scene.state.books.contact_work, 0);
  EXPECT_LT(std::abs(scene.state.books.contact_work), 0.05 * initial);
}

}  // namespace
}  // namespace percuss::test::wall_contact_test
