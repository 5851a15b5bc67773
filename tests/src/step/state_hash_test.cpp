// The hash of a state: any bit changes it, nothing else does.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

// 45 elements: the last pack of the only chunk is partly empty at any width.
const std::string text = R"(
time: {end: 1}
parts: {a: {box: {size: [5, 3, 3], cells: [5, 3, 3]}, material: steel}}
initial: [{part: a, velocity: [10, 0, 0], angular_velocity: [1, 2, 3]}]
)" + steel_text;

/// Changes the last bit of one value of a view.
template <class View>
void flip(const View& view, std::size_t place) {
  const auto host = Kokkos::create_mirror_view(view);
  Kokkos::deep_copy(host, view);
  double& value = host.data()[place];
  value = std::nextafter(value, 1e300);
  Kokkos::deep_copy(view, host);
}

}  // namespace

TEST(StateHash, IsTheSameForTheSameRun) {
  Scene a(text), b(text);
  a.run(20);
  b.run(20);
  EXPECT_EQ(hash_state(a.model, a.state), hash_state(b.model, b.state));
  b.stepper.advance(b.state);
  EXPECT_NE(hash_state(a.model, a.state), hash_state(b.model, b.state));
}

TEST(StateHash, ChangesWithAnyBitOfPositionsVelocitiesAndElementRecords) {
  Scene scene(text);
  scene.run(5);
  std::set<std::uint64_t> seen{hash_state(scene.model, scene.state)};
  const std::size_t nodes = scene.chunked.mesh.nodes.size();
  for (std::size_t i = 0; i < 3 * nodes; ++i) {
    flip(scene.state.x, i);
    EXPECT_TRUE(seen.insert(hash_state(scene.model, scene.state)).second) << "position " << i;
    flip(scene.state.v, i);
    EXPECT_TRUE(seen.insert(hash_state(scene.model, scene.state)).second) << "velocity " << i;
  }
  // records lie pack by pack, scalar by scalar, lane by lane
  const std::size_t width = pack_size<double>;
  const auto size = static_cast<std::size_t>(to_host(scene.model.chunks.record_size)(0));
  for (std::size_t e = 0; e < 45; e += 4) {
    for (std::size_t scalar = 0; scalar < size; ++scalar) {
      flip(scene.state.elements, (e / width * size + scalar) * width + e % width);
      EXPECT_TRUE(seen.insert(hash_state(scene.model, scene.state)).second) << "element " << e << " scalar " << scalar;
    }
  }
}

TEST(StateHash, DoesNotSeeTheEmptyLanesOfAPack) {
  Scene scene(text);
  scene.run(5);
  const auto before = hash_state(scene.model, scene.state);
  const std::size_t width = pack_size<double>;
  if (45 % width == 0) GTEST_SKIP() << "packs of one lane have no empty lanes";
  flip(scene.state.elements, scene.model.state_size - 1);
  EXPECT_EQ(hash_state(scene.model, scene.state), before);
}

TEST(StateHash, TellsNodesThatSwapTheirPlacesApart) {
  Scene scene(text);
  const auto before = hash_state(scene.model, scene.state);
  const auto x = Kokkos::create_mirror_view(scene.state.x);
  Kokkos::deep_copy(x, scene.state.x);
  for (std::size_t k = 0; k < 3; ++k) std::swap(x(3, k), x(7, k));
  Kokkos::deep_copy(scene.state.x, x);
  EXPECT_NE(hash_state(scene.model, scene.state), before);
}

}  // namespace percuss::test
