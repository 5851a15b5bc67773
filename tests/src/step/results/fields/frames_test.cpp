// Fields that show how a run is divided among ranks, as its frames have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "src/step/run/run.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/step/scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using sample::Hdf5FileView;

// Two cubes of 4 x 4 x 4 elements, the upper one about to land on the lower one. They are searched in the first step.
const std::string two_cubes = R"yaml(
time: {end: 1, max_steps: 2}
parts:
  low: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, material: steel}
  high: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [0.3, 0.2, 1.0001], material: steel}
initial: [{part: high, velocity: [0, 0, -10]}]
contact: {surfaces: all}
output: {fields: {every: 1, write: [contact_rank, fe_rank]}}
)yaml" + steel_text;

constexpr std::size_t node_count = 2 * 5 * 5 * 5, inner_nodes = 2 * 3 * 3 * 3, element_count = 2 * 4 * 4 * 4;

/// Ranks of nodes and elements in a frame.
struct Frame {
  std::vector<double> contact_ranks, fe_ranks;
};

/// The first and the last frame of the scene, read on rank 0.
std::vector<Frame> write_and_read(const Communicator& ranks) {
  const SharedFolder folder;
  const std::string& path = folder.path();
  run_scene(parse_deck(two_cubes, "deck.yaml"), {path, Progress::Style::quiet});
  if (ranks.rank() > 0) return {};
  const Hdf5FileView file(path + "/fields.vtkhdf");
  const std::vector<double> contact = file.numbers("VTKHDF/PointData/contact_rank");
  const std::vector<double> fe = file.numbers("VTKHDF/CellData/fe_rank");
  EXPECT_EQ(contact.size(), 2 * node_count);
  EXPECT_EQ(fe.size(), 2 * element_count);
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto n = static_cast<std::ptrdiff_t>(i * node_count), e = static_cast<std::ptrdiff_t>(i * element_count);
    frames.push_back({{contact.begin() + n, contact.begin() + n + static_cast<std::ptrdiff_t>(node_count)},
                      {fe.begin() + e, fe.begin() + e + static_cast<std::ptrdiff_t>(element_count)}});
  }
  return frames;
}

std::size_t count(const std::vector<double>& values, double value) {
  return static_cast<std::size_t>(std::count(values.begin(), values.end(), value));
}

TEST(FramesOnRanks, ShowWhoOwnsEveryContactNodeAndComputesEveryElement) {
  const Communicator ranks = Communicator::world();
  const std::vector<Frame> frames = write_and_read(ranks);
  if (ranks.rank() > 0) return;
  const Frame& last = frames.back();
  EXPECT_EQ(count(last.contact_ranks, -1), inner_nodes);
  // Nodes and faces together are divided evenly; nodes alone nearly so.
  const double share = static_cast<double>(node_count - inner_nodes) / ranks.size();
  std::size_t owned = 0, computed = 0;
  for (int r = 0; r < ranks.size(); ++r) {
    EXPECT_NEAR(static_cast<double>(count(last.contact_ranks, r)), share, 0.2 * share) << "rank " << r;
    owned += count(last.contact_ranks, r);
    computed += count(last.fe_ranks, r);
  }
  EXPECT_EQ(owned, node_count - inner_nodes);
  EXPECT_EQ(computed, element_count);
}

// A plate of two elements, bent by its ends beyond yield.
const std::string bent_plate = R"yaml(
time: {end: 1, max_steps: 60, max_step: 1.0e-6}
parts: {plate: {shell_plate: {size: [1, 1], cells: [1, 2]}, thickness: 0.1, points: 5, material: steel}}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 4.0e5}}
conditions:
  - {nodes: plate, fixed: [x, y, z, rx, rz]}
  - {nodes: plate/x_min, velocity: {ry: -2}}
  - {nodes: plate/x_max, velocity: {ry: 2}}
output: {fields: {every: 1, write: [stress_bottom, stress_top, stress_point_1, stress_point_5, equivalent_plastic_strain_point_1, equivalent_plastic_strain_point_3]}}
)yaml";

TEST(FramesOnRanks, HaveTheFirstPointOfShellsAtTheBottomAndTheLastAtTheTop) {
  const Communicator ranks = Communicator::world();
  const SharedFolder folder;
  const std::string& path = folder.path();
  run_scene(parse_deck(bent_plate, "deck.yaml"), {path, Progress::Style::quiet});
  if (ranks.rank() > 0) return;
  const Hdf5FileView file(path + "/fields.vtkhdf");
  const std::vector<double> bottom = file.numbers("VTKHDF/CellData/stress_bottom");
  EXPECT_EQ(file.numbers("VTKHDF/CellData/stress_point_1"), bottom);
  EXPECT_EQ(file.numbers("VTKHDF/CellData/stress_point_5"), file.numbers("VTKHDF/CellData/stress_top"));
  EXPECT_GT(std::abs(bottom.at(2 * 6)), 4e5);  // of the last frame, along x
  EXPECT_GT(file.numbers("VTKHDF/CellData/equivalent_plastic_strain_point_1").back(), 1e-6);
  EXPECT_EQ(file.numbers("VTKHDF/CellData/equivalent_plastic_strain_point_3").back(), 0);
}

TEST(FramesOnRanks, ShowTheDivisionFromTheFirstFrameOn) {
  const Communicator ranks = Communicator::world();
  const std::vector<Frame> frames = write_and_read(ranks);
  if (ranks.rank() > 0) return;
  EXPECT_EQ(count(frames.front().contact_ranks, -1), inner_nodes);
}

// Two blocks with equal faces that press flat on each other, in uniaxial strain.
TEST(FramesOnRanks, ContactPressureIsTheForceOverTheAreaOfEachNode) {
  const Communicator ranks = Communicator::world();
  const SharedFolder folder;
  const std::string& path = folder.path();
  run_scene(parse_deck(R"yaml(
time: {end: 1, max_steps: 8}
parts:
  top: {box: {size: [0.6, 0.4, 1], cells: [3, 2, 10]}, at: [0, 0, 1.0005], material: m}
  base: {box: {size: [0.6, 0.4, 1], cells: [3, 2, 10]}, material: m}
materials: {m: {model: elastic, density: 4, youngs_modulus: 100, poissons_ratio: 0}}
initial: [{part: top, velocity: [0, 0, -0.1]}]
conditions: [{nodes: top, fixed: [x, y]}, {nodes: base, fixed: [x, y]}]
contact: {friction: 0.2}
output: {fields: {every: 10, write: [contact_force, contact_pressure]}}
)yaml",
                       "deck.yaml"),
            {path, Progress::Style::quiet});
  if (ranks.rank() > 0) return;
  const Hdf5FileView file(path + "/fields.vtkhdf");
  const std::vector<double> force = file.numbers("VTKHDF/PointData/contact_force"),
                            pressure = file.numbers("VTKHDF/PointData/contact_pressure");
  double sum = 0;
  for (std::size_t i = force.size() / 2 + 2; i < force.size(); i += 3) sum += std::max(force[i], 0.0);
  EXPECT_GT(sum, 0.1);
  std::size_t pressed = 0;
  for (std::size_t n = pressure.size() / 2; n < pressure.size(); ++n) {
    if (pressure[n] == 0) continue;
    ++pressed;
    EXPECT_NEAR(pressure[n], sum / 0.24, 1e-7 * sum / 0.24);
  }
  EXPECT_EQ(pressed, 2 * 4 * 3);
}

// The last frame of a run that restarts where it ends: no step comes before it.
TEST(FramesOnRanks, ContactPressureIsThereInAFrameThatARestartWritesBeforeItsFirstStep) {
  const Communicator ranks = Communicator::world();
  const SharedFolder folder;
  const std::string& path = folder.path();
  if (ranks.rank() == 0) {
    for (const char* name : {"/whole", "/first", "/second"}) std::filesystem::create_directory(path + name);
  }
  ranks.barrier();
  const auto run = [&](const std::string& name, const std::string& steps, const std::string& restart) {
    RunOptions options{path + name, Progress::Style::quiet};
    options.restart = restart;
    run_scene(parse_deck(R"yaml(
time: {end: 1, max_steps: 8}
parts:
  top: {box: {size: [0.6, 0.4, 1], cells: [3, 2, 10]}, at: [0, 0, 1.0005], material: m}
  base: {box: {size: [0.6, 0.4, 1], cells: [3, 2, 10]}, material: m}
materials: {m: {model: elastic, density: 4, youngs_modulus: 100, poissons_ratio: 0}}
initial: [{part: top, velocity: [0, 0, -0.1]}]
contact: {friction: 0.2}
output: {fields: {every: 10, write: [contact_pressure]}, checkpoint: {every: 1.0e-6}}
)yaml",
                         "deck.yaml", {"time.max_steps=" + steps}),
              options);
  };
  run("/whole", "7", "");
  run("/first", "8", "");
  run("/second", "7", path + "/first/checkpoint_previous.h5");
  if (ranks.rank() > 0) return;
  const auto read_last = [&](const std::string& name) {
    const std::vector<double> all = Hdf5FileView(path + name).numbers("VTKHDF/PointData/contact_pressure");
    return std::vector<double>(all.end() - 2 * 4 * 3 * 11, all.end());
  };
  const std::vector<double> pressure = read_last("/whole/fields.vtkhdf");
  EXPECT_GT(*std::max_element(pressure.begin(), pressure.end()), 0);
  EXPECT_EQ(read_last("/second/fields.vtkhdf"), pressure);
}

// A bar that is pulled apart at its end; its deck does not name the field.
TEST(FramesOnRanks, TellWhoLivesWhereverElementsCanDie) {
  const Communicator ranks = Communicator::world();
  const SharedFolder folder;
  const std::string& path = folder.path();
  run_scene(parse_deck(R"yaml(
time: {end: 0.02, max_step: 1.0e-3}
parts: {bar: {box: {size: [3, 1, 1], cells: [3, 1, 1]}, material: weak}}
materials: {weak: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0, failure: {principal_stress: 1}}}
conditions: [{nodes: bar/x_min, fixed: x}, {nodes: bar/x_max, velocity: {x: 1}}]
output: {fields: {every: 1, write: [velocity]}}
)yaml",
                       "deck.yaml"),
            {path, Progress::Style::quiet});
  if (ranks.rank() > 0) return;
  const Hdf5FileView file(path + "/fields.vtkhdf");
  EXPECT_EQ(file.numbers("VTKHDF/CellData/alive"), (std::vector<double>{1, 1, 1, 1, 1, 0}));
  EXPECT_EQ(file.bytes_of_number("VTKHDF/CellData/alive"), 1u);
}

}  // namespace
}  // namespace percuss::test
