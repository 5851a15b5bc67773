// Energies, momentum and mass by part: exact values, sums that are those of the scene, the same text on any ranks and
// after a restart.

#include "src/step/audit/part_energies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "src/step/results/history.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/eroding_scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

/// The columns of a state, by heading.
std::map<std::string, double> sum_parts(const Scene& scene) {
  const std::vector<std::string> columns = name_columns(list_part_columns(find_booked_parts(scene.deck)));
  std::vector<double> row;
  PartEnergies(scene.deck, scene.chunked).append(scene.model, scene.state, row);
  EXPECT_EQ(row.size(), columns.size());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < row.size(); ++i) values[columns[i]] = row[i];
  return values;
}

std::string read_file(const std::string& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

/// A block that can fail with a pin that falls on it, a plate of shells that turns, and a block that cannot fail; loads
/// and held nodes.
std::string make_eroding(const std::string& more) {
  return R"(
time: {end: 1000}
parts:
  block: {box: {size: [5, 5, 3], cells: [5, 5, 3]}, material: m}
  pin: {box: {size: [0.4, 0.4, 0.4], cells: [1, 1, 1]}, at: [2.3, 2.3, 3.05], material: m}
  plate: {shell_plate: {size: [5, 5], cells: [5, 5]}, thickness: 0.1, at: [0, 0, -1], material: m}
  whole: {box: {size: [1, 1, 1], cells: [5, 5, 5]}, at: [9, 0, 0], material: n}
materials:
  m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25, failure: {principal_strain: 9}}
  n: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}
initial: [{part: pin, velocity: [0, 0, -0.5]}, {part: plate, angular_velocity: [0.1, 0.2, 0.3]}, {part: whole, velocity: [3, 1, -2]}]
conditions: [{nodes: whole/x_max, velocity: {x: 2}}, {nodes: plate/x_min, fixed: [rx, ry]}]
loads: {gravity: [0, 0.1, -0.2], pressure: [{faces: block/z_max, value: 0.01}]}
contact: {friction: 0.1}
output: {history: {parts: all}}
)" + more;
}

/// Has elements of the block and of the plate die, at last all along an edge of the block; looks at every tenth state.
template <class Look>
void erode(ErodingScene& eroding, const Look& look) {
  eroding.run(10);
  look();
  eroding.kill({{2.5, 2.5, 2.5}, {2.5, 2.5, -1}});
  for (int i = 0; i < 2; ++i) {
    eroding.run(10);
    look();
  }
  eroding.kill({{0.5, 0.5, 2.5}, {0.5, 0.5, 1.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, -1}});
  for (int i = 0; i < 3; ++i) {
    eroding.run(10);
    look();
  }
}

/// Expects the sum of a quantity over the parts to be that of the scene; `scale`: of what is rounded.
void expect_sum(const std::map<std::string, double>& values, const std::string& quantity, double expected,
                double scale) {
  double sum = 0;
  for (const auto& [name, value] : values) {
    if (name.starts_with(quantity + ":")) sum += value;
  }
  EXPECT_NEAR(sum, expected, 1e-14 * scale) << quantity;
}

void expect_sums(const Scene& scene, const AuditResult& audit) {
  const std::map<std::string, double> values = sum_parts(scene);
  const EnergySummary& e = audit.energy;
  const double energy = e.kinetic + std::abs(e.internal()) + audit.eroded.energy;
  expect_sum(values, "kinetic", e.kinetic, energy);
  expect_sum(values, "internal", e.work[WorkKind::internal], energy);
  expect_sum(values, "hourglass", e.work[WorkKind::hourglass], energy);
  expect_sum(values, "viscous", e.work[WorkKind::viscous], energy);
  expect_sum(values, "folding", e.work[WorkKind::folding], energy);
  const double momentum = std::sqrt(2 * scene.state.total_mass * e.kinetic);
  expect_sum(values, "momentum_x", audit.momentum.linear[0], momentum);
  expect_sum(values, "momentum_y", audit.momentum.linear[1], momentum);
  expect_sum(values, "momentum_z", audit.momentum.linear[2], momentum);
  expect_sum(values, "mass", scene.state.total_mass, scene.state.total_mass);
  expect_sum(values, "eroded_mass", audit.eroded.mass, audit.eroded.mass);
}

}  // namespace

TEST(PartEnergies, OfARigidBodyAreThoseOfItsGivenMass) {
  Scene scene(R"(
time: {end: 1, max_step: 1e-6}
parts:
  ram: {box: {size: [1, 2, 1], cells: [2, 2, 2]}, material: steel, rigid: {mass: 300}}
  bar: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [3, 0, 0], material: steel}
initial: [{part: ram, velocity: [10, 0, 0]}, {part: bar, velocity: [0, 2, 0]}]
output: {history: {parts: all}}
)" + steel_text);
  scene.run(10);
  const std::map<std::string, double> values = sum_parts(scene);
  EXPECT_DOUBLE_EQ(values.at("mass:ram"), 300);
  EXPECT_NEAR(values.at("kinetic:ram"), 15000, 1e-9);
  EXPECT_NEAR(values.at("momentum_x:ram"), 3000, 1e-9);
  EXPECT_NEAR(values.at("momentum_y:bar"), 2 * values.at("mass:bar"), 1e-9);
  expect_sums(scene, Audit(scene.model)(scene.state));
}

TEST(PartEnergies, AreExactOfABlockThatFliesAndOneThatIsStretched) {
  // b is one element between a face at rest and one at speed u: uniaxial strain e = ln(1 + u t), Cauchy stress M e, and
  // W = integral of M e exp(e) de = M ((e - 1) exp(e) + 1) per volume at the start.
  Scene scene(R"(
time: {end: 1, max_step: 1e-6}
parts:
  a: {box: {size: [1, 2, 1], cells: [9, 9, 9]}, material: steel}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [3, 0, 0], material: steel}
initial: [{part: a, velocity: [1, 2, 3]}]
conditions: [{nodes: b/x_min, fixed: [x, y, z]}, {nodes: b/x_max, velocity: {x: 100, y: 0, z: 0}}]
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
output: {history: {parts: [b, a]}}
)" + steel_text);
  scene.run(100);
  const std::map<std::string, double> values = sum_parts(scene);
  EXPECT_EQ(values.size(), 18u);
  const double rho = 7850, time = 1e-4, u = 100;
  EXPECT_NEAR(scene.state.time, time, 1e-16);
  EXPECT_NEAR(values.at("mass:a"), 2 * rho, 1e-14 * 2 * rho);
  EXPECT_NEAR(values.at("kinetic:a"), 0.5 * 2 * rho * 14, 1e-12 * 14 * rho);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(values.at(std::string("momentum_") + "xyz"[k] + ":a"), 2 * rho * (k + 1), 1e-12 * 2 * rho);
  }
  EXPECT_NEAR(values.at("internal:a"), 0, 1e-9);
  EXPECT_NEAR(values.at("mass:b"), rho, 1e-14 * rho);
  EXPECT_NEAR(values.at("kinetic:b"), 0.5 * (rho / 2) * u * u, 1e-14 * rho * u * u);
  EXPECT_NEAR(values.at("momentum_x:b"), rho / 2 * u, 1e-14 * rho * u);
  const double e = std::log(1 + u * time), young = 200e9, nu = 0.3;
  const double modulus = young * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  const double work = 0.5 * modulus * e * e;  // the rate of the law is that of J sigma
  EXPECT_NEAR(values.at("internal:b"), work, 1e-6 * work);
  EXPECT_EQ(values.at("hourglass:b"), 0);
  EXPECT_EQ(values.at("viscous:b"), 0);
  EXPECT_EQ(list_part_columns(find_booked_parts(scene.deck)).front().name, "kinetic:b");  // in the order of the list
}

TEST(PartEnergies, AddUpToThoseOfTheScene) {
  for (const char* more : {"", "erosion: {free_nodes: remove}\n"}) {
    ErodingScene eroding(make_eroding(more));
    EXPECT_EQ(sum_parts(eroding.scene).count("eroded_mass:whole"), 0u);
    erode(eroding, [&] { expect_sums(eroding.scene, eroding.audit(eroding.scene.state)); });
    EXPECT_GE(eroding.events, 2);
    const AuditResult audit = eroding.audit(eroding.scene.state);
    EXPECT_GT(audit.energy.hourglass(), 0);
    EXPECT_EQ(audit.eroded.elements, 6);
  }
}

TEST(PartEnergies, LoseWhatDeadElementsTakeToColumnsOfTheirOwn) {
  for (const bool removes : {false, true}) {
    ErodingScene eroding(make_eroding(removes ? "erosion: {free_nodes: remove}\n" : ""));
    const double before = sum_parts(eroding.scene).at("mass:block");
    erode(eroding, [] {});
    const std::map<std::string, double> values = sum_parts(eroding.scene);
    const AuditResult audit = eroding.audit(eroding.scene.state);
    EXPECT_NEAR(values.at("eroded_mass:block"), 4, 1e-13);  // of elements of volume and density 1
    EXPECT_NEAR(values.at("eroded_mass:plate"), 0.2, 1e-14);
    EXPECT_EQ(values.at("eroded_mass:pin"), 0);
    // The edge of the block where all died: its nodes had an eighth of an element at the ends, a quarter between.
    EXPECT_NEAR(before - values.at("mass:block"), removes ? 3.0 / 4 : 0, 1e-13);
    double energy = 0;
    for (const char* part : {"block", "pin", "plate"}) energy += values.at(std::string("eroded_energy:") + part);
    if (removes) {
      EXPECT_GT(audit.eroded.energy, energy * (1 + 1e-12));  // the energy of nodes that vanished is that of no part
    } else {
      EXPECT_NEAR(energy, audit.eroded.energy, 1e-14 * energy);
    }
    EXPECT_GT(energy, 0);
  }
}

TEST(PartEnergies, AreTheSameTextOnAnyNumberOfRanksAndCloseTheMass) {
  for (const char* more : {"", "erosion: {free_nodes: remove}\n"}) {
    const std::string deck = make_eroding(more);
    ErodingScene together(deck), alone(deck, Communicator(MPI_COMM_SELF));
    const TemporaryFolder folders[2];
    ErodingScene* const scenes[2] = {&together, &alone};
    for (std::size_t i = 0; i < 2; ++i) {
      ErodingScene& eroding = *scenes[i];
      Scene& scene = eroding.scene;
      History history(folders[i].path(), {scene.deck, scene.chunked, scene.stepper});
      erode(eroding, [&] {
        history.write(scene.model, {scene.state, eroding.audit(scene.state), scene.stepper.contact_report(), Vec3{},
                                    scene.contact.sum_pair_work(), scene.stepper});
      });
      history.flush();
    }
    if (together.scene.model.ranks.rank() != 0) continue;
    EXPECT_EQ(read_file(folders[0].path() + "/history.csv"), read_file(folders[1].path() + "/history.csv"));
    const HistoryTable table(folders[1].path() + "/history.csv");
    EXPECT_EQ(table.rows(), 6u);
    EXPECT_EQ(table.has("vanished_mass"), *more != '\0');
    if (*more == '\0') continue;
    EXPECT_NEAR(table.last("vanished_mass"), 0.75 + 0.025, 1e-14);  // an edge of the block, a corner of the plate
    for (std::size_t row = 0; row < table.rows(); ++row) {
      double mass = table["vanished_mass"][row];
      for (const char* part : {"block", "pin", "plate", "whole"}) mass += table[std::string("mass:") + part][row];
      EXPECT_NEAR(mass, 75 + 0.064 + 2.5 + 2, 1e-13);
    }
  }
}

TEST(PartEnergies, GoOnAfterARestart) {
  // The rod meets the block and tears where it is held.
  const std::string deck = R"(
parts:
  rod: {box: {size: [6, 1, 1], cells: [12, 2, 2]}, material: m}
  block: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [6.1, 0, 0], material: m}
materials:
  m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25, failure: {principal_strain: 0.03}}
conditions: [{nodes: rod/x_min, fixed: [x, y, z]}, {nodes: rod/x_max, velocity: {x: 0.2}}]
initial: [{part: block, velocity: [-0.1, 0, 0]}]
erosion: {free_nodes: remove}
contact: {friction: 0.1}
)";
  const std::string history = "output: {history: {parts: all}";
  const SharedFolder whole, parts;
  const auto run = [&](const std::string& rest, const std::string& folder, const std::string& restart) {
    RunOptions options;
    options.out_dir = folder;
    options.restart = restart;
    options.goes_on_in_place = !restart.empty();
    return run_scene(parse_deck(deck + rest, "deck.yaml"), options).summary;
  };
  const Summary expected = run("time: {end: 1.2}\n" + history + "}\n", whole.path(), "");
  const Summary stopped = run("time: {end: 1.2, max_steps: " + std::to_string(expected.steps * 2 / 3) + "}\n" +
                                  history + ", checkpoint: {every: 1}}\n",
                              parts.path(), "");
  EXPECT_EQ(stopped.eroded.elements, 8);  // before the checkpoint
  run("time: {end: 1.2}\n" + history + "}\n", parts.path(), parts.path() + "/checkpoint.h5");
  const std::string text = read_file(whole.path() + "/history.csv");
  EXPECT_NE(text.find("eroded_energy:rod"), std::string::npos);
  EXPECT_EQ(read_file(parts.path() + "/history.csv"), text);
}

}  // namespace percuss::test
