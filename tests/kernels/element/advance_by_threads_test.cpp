// A thread an element gives the bits that packs of elements give: forces of slots, records, bounds of the step.

#include "kernels/element/advance_by_threads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/same_bits.hpp"
#include "perf/device/box_chunks.hpp"

namespace percuss::test::advance_by_threads_test {

namespace {

constexpr int threads_cells = 12, threads_chunk = 6, threads_steps = 20;

template <class Material, HexKind Kind>
HexBlock<Material, Kind> make_whole_block(const Box& box) {
  std::vector<int> all;
  for (int c = 0; c < box.chunks.count; ++c) all.push_back(c);
  return {to_view("chunks", all), Kokkos::View<SolidParameters<Material>*, MemSpace>("parameters", 1)};
}

/// The box after some steps. Stored: elements side by side; other than those of packs: by threads.
template <int Stored, class Material, HexKind Kind>
Box run_box(const Material& material) {
  const Box box = make_box({threads_cells, threads_chunk, Stored, hex_record_size<Material, Kind>, 7850});
  const HexBlock<Material, Kind> block = make_whole_block<Material, Kind>(box);
  block.parameters(0) = {material, material.lambda, material.mu, 0.05, {}, 0};
  const NodeForces forces{box.nodes_to_slots, box.fields.slot_force, box.inverse_mass, {}};
  const ExecSpace space;
  for (int n = 0; n < threads_steps; ++n) {
    const double dt = n == 0 ? 0.0 : 2e-6;
    advance_free_nodes(space, forces, dt, dt, box.v, box.x);
    const ElementMotion motion{box.x, box.v, dt};
    if constexpr (Stored == pack_size<Real>)
      advance_block(space, box.chunks, block, motion, box.fields);
    else
      advance_by_threads<Stored>(space, box.chunks, box.slot_corners, block, motion, box.fields);
    space.fence();
  }
  return box;
}

template <class View>
void expect_same_bits(const View& a, const View& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_TRUE(has_same_bits(a.data()[i], b.data()[i])) << i;
}

template <class T>
struct Variant;
template <class M, HexKind K>
struct Variant<HexBlock<M, K>> {
  using Material = M;
  static constexpr HexKind kind = K;
};

Elastic make_material(const Elastic*) { return Elastic::make({200e9, 0.3}); }
J2Plasticity make_material(const J2Plasticity*) { return J2Plasticity::make({200e9, 0.3, 400e6, 1e9}); }

template <class Block>
class ByThreads : public testing::Test {};
using ThreadBlocks =
    testing::Types<HexBlock<Elastic, HexKind::assumed_strain>, HexBlock<J2Plasticity, HexKind::assumed_strain>,
                   HexBlock<J2Plasticity, HexKind::stiffness>, HexBlock<J2Plasticity, HexKind::viscous>,
                   HexBlock<J2Plasticity, HexKind::full>>;
TYPED_TEST_SUITE(ByThreads, ThreadBlocks);

}  // namespace

// Chunks of 216 elements: two rounds, and the last warp is partly empty.
TYPED_TEST(ByThreads, GivesTheBitsOfPacks) {
  using Material = typename Variant<TypeParam>::Material;
  constexpr HexKind kind = Variant<TypeParam>::kind;
  const Material material = make_material(static_cast<const Material*>(nullptr));
  const Box packs = run_box<pack_size<Real>, Material, kind>(material);
  const Box threads = run_box<device_lanes, Material, kind>(material);
  expect_same_bits(packs.x, threads.x);
  expect_same_bits(packs.v, threads.v);
  expect_same_bits(packs.fields.slot_force, threads.fields.slot_force);
  expect_same_bits(packs.fields.results.stable_step, threads.fields.results.stable_step);
  for (int c = 0; c < packs.chunks.count; ++c) {
    EXPECT_EQ(packs.fields.results.controlling_element(c), threads.fields.results.controlling_element(c));
    EXPECT_EQ(packs.fields.results.failed_element(c), threads.fields.results.failed_element(c));
    for (int k = 0; k < 3; ++k) {
      const double work = packs.fields.results.work(c, k);
      EXPECT_NEAR(threads.fields.results.work(c, k), work, 1e-12 * std::fabs(work)) << c << ' ' << k;
    }
  }
}

}  // namespace percuss::test::advance_by_threads_test
