// The launcher against the pure function, on a strip of elements that fills no pack.

#include "kernels/shell/shell_force.hpp"

#include <gtest/gtest.h>

#include "kernels/core/host_copy.hpp"
#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::shell_force_test {

namespace {

constexpr int width = pack_size<double>;
constexpr int element_count = 2 * width + 3, node_count = 2 * (element_count + 1), point_count = 3;
constexpr double thickness = 0.05, density = 2, dt = 1e-3;
using RowsOnHost = std::vector<std::array<double, 3>>;

J2Layer make_material() { return {find_plane_elasticity(3, 0.3), 1e-4, 0.1}; }

/// Nodes of element e of a strip along x.
std::array<int, 4> find_nodes(int e) { return {2 * e, 2 * e + 2, 2 * e + 3, 2 * e + 1}; }

struct Strip {
  RowsOnHost x, v, w;

  explicit Strip(Random& random) : x(node_count), v(node_count), w(node_count) {
    for (std::size_t n = 0; n < node_count; ++n) {
      x[n] = {static_cast<double>(n / 2) + 0.2 * random(), static_cast<double>(n % 2) + 0.2 * random(), 0.1 * random()};
      v[n] = {random(), random(), random()};
      w[n] = {random(), random(), random()};
    }
  }

  ElementMotion motion(bool skips_rest) const {
    ElementMotion motion{to_rows("x", x), to_rows("v", v), dt, skips_rest};
    motion.w = to_rows("w", w);
    return motion;
  }

  static ShellCorners gather(const RowsOnHost& rows, int e) {
    ShellCorners u;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& row = rows[static_cast<std::size_t>(find_nodes(e)[i])];
      u[i] = {row[0], row[1], row[2]};
    }
    return u;
  }
};

ElementChunks make_chunks() {
  constexpr int packs = (element_count + width - 1) / width;
  std::vector<int> nodes(node_count);
  for (int n = 0; n < node_count; ++n) nodes[static_cast<std::size_t>(n)] = n;
  std::vector<std::uint16_t> corners(std::size_t{packs} * 8 * width);
  for (int i = 0; i < packs * width; ++i) {
    for (int k = 0; k < 4; ++k) {
      const auto node = find_nodes(std::min(i, element_count - 1))[static_cast<std::size_t>(k)];
      corners[static_cast<std::size_t>((i / width * 8 + k) * width + i % width)] = static_cast<std::uint16_t>(node);
    }
  }
  ElementChunks chunks;
  chunks.count = 1;
  chunks.largest_slot_count = node_count;
  chunks.first_element = to_view<int>("first_element", {0, element_count});
  chunks.first_slot = to_view<int>("first_slot", {0, node_count});
  chunks.slots_to_nodes = to_view("slots_to_nodes", nodes);
  chunks.first_pack = to_view<int>("first_pack", {0, packs});
  chunks.corner_slots = to_view("corner_slots", corners);
  chunks.first_state = to_view<std::size_t>("first_state", {0});
  chunks.parameters = to_view<int>("parameters", {0});
  chunks.record_size = to_view<int>("record_size", {find_shell_record_size(point_count, J2Layer::most_history)});
  return chunks;
}

/// Records of elements at rest, from the elements of the pure function.
Array<double> make_records(const std::vector<TestShell<J2Layer>>& shells, int record_size) {
  constexpr int packs = (element_count + width - 1) / width;
  std::vector<double> records(static_cast<std::size_t>(packs * width * record_size));
  for (int i = 0; i < packs * width; ++i) {
    const auto& state = shells[static_cast<std::size_t>(std::min(i, element_count - 1))].state;
    double* const record = records.data() + i / width * record_size * width + i % width;
    record[ShellRecord::mass * width] = state.mass;
    record[ShellRecord::gyration_square * width] = state.gyration_square;
    record[ShellRecord::thickness * width] = state.thickness;
  }
  return to_view("records", records);
}

ChunkResults make_results() {
  return {Array<double>("step", 1),
          Array<int>("element", 1),
          Array<int>("failed", 1),
          WorkRows("work", 1),
          Array<int>("settled", 1),
          Array<std::int64_t>("skipped", 1),
          {}};
}

}  // namespace

TEST(ShellLauncher, GivesWhatThePureFunctionGives) {
  Random random(31);
  const Strip strip(random);
  std::vector<TestShell<J2Layer>> shells;
  for (int e = 0; e < element_count; ++e) {
    shells.emplace_back(make_material(), point_count, Strip::gather(strip.x, e), thickness, density);
  }
  const ElementChunks chunks = make_chunks();
  const Array<double> state = make_records(shells, find_shell_record_size(point_count, J2Layer::most_history));
  ShellBlocks blocks;
  auto& block = std::get<ShellBlock<J2Layer>>(blocks);
  block.chunks = to_view<int>("chunks", {0});
  block.parameters = to_view<ShellParameters<J2Layer>>("parameters", {shells[0].par});
  const Rows3<double> force("force", node_count), moment("moment", node_count);
  const ChunkResults results = make_results();
  advance_shells(ExecSpace(), chunks, blocks, strip.motion(false), {state, force, results, moment});

  RowsOnHost expected_force(node_count, {0, 0, 0}), expected_moment(node_count, {0, 0, 0});
  double step = 1e300, work = 0;
  int controlling = -1;
  for (int e = 0; e < element_count; ++e) {
    auto& shell = shells[static_cast<std::size_t>(e)];
    const auto result =
        shell.advance(Strip::gather(strip.x, e), Strip::gather(strip.v, e), Strip::gather(strip.w, e), dt);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto n = static_cast<std::size_t>(find_nodes(e)[i]);
      const Vec f = shell.force[i], m = shell.moment[i];
      expected_force[n] = {expected_force[n][0] - f.x, expected_force[n][1] - f.y, expected_force[n][2] - f.z};
      expected_moment[n] = {expected_moment[n][0] - m.x, expected_moment[n][1] - m.y, expected_moment[n][2] - m.z};
    }
    if (result.stable_step < step) {
      step = result.stable_step;
      controlling = e;
    }
    work += result.work.internal;
  }
  const auto f = to_host(force), m = to_host(moment);
  for (std::size_t n = 0; n < node_count; ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_DOUBLE_EQ(f(n, k), expected_force[n][k]) << n;
      EXPECT_DOUBLE_EQ(m(n, k), expected_moment[n][k]) << n;
    }
  }
  EXPECT_EQ(to_host(results.controlling_element)(0), controlling);
  EXPECT_DOUBLE_EQ(to_host(results.stable_step)(0), step);
  EXPECT_DOUBLE_EQ(to_host(results.work)(0, 0), work);
  EXPECT_EQ(to_host(results.failed_element)(0), -1);
}

TEST(ShellLauncher, SkipsAChunkThatRestsAndIsSettled) {
  Random random(32);
  Strip strip(random);
  for (auto* rows : {&strip.v, &strip.w}) std::fill(rows->begin(), rows->end(), std::array<double, 3>{0, 0, 0});
  std::vector<TestShell<J2Layer>> shells;
  for (int e = 0; e < element_count; ++e) {
    shells.emplace_back(make_material(), point_count, Strip::gather(strip.x, e), thickness, density);
  }
  const Array<double> state = make_records(shells, find_shell_record_size(point_count, J2Layer::most_history));
  ShellBlocks blocks;
  auto& block = std::get<ShellBlock<J2Layer>>(blocks);
  block.chunks = to_view<int>("chunks", {0});
  block.parameters = to_view<ShellParameters<J2Layer>>("parameters", {shells[0].par});
  const Rows3<double> force("force", node_count), moment("moment", node_count);
  const ChunkResults results = make_results();
  const auto advance = [&] {
    advance_shells(ExecSpace(), make_chunks(), blocks, strip.motion(true), {state, force, results, moment});
    return to_host(results.skipped)(0);
  };
  EXPECT_EQ(advance(), 0);
  EXPECT_EQ(advance(), 1);
  strip.w[5] = {0, 0, 1};
  EXPECT_EQ(advance(), 1);
}

}  // namespace percuss::test::shell_force_test
