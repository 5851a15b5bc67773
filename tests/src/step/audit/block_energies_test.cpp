// Energies, momentum and mass of element blocks and element sets: exact values, sums that are those of their part, the
// same bits on any ranks and after a restart.

#include "src/step/audit/block_energies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "src/error.hpp"
#include "src/step/audit/part_energies.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/eroding_scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

/// A bar along x of unit cubes, 10 x 2 x 2, as a keyword file with shells on its upper face: the parts "core" and
/// "skin", the sets "low" and "high" of the cubes before and behind x = 3, and "ends" of the first and the last ones.
std::string write_coated_bar() {
  constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const auto node = [](int i, int j, int k) { return 1 + 9 * i + 3 * j + k; };
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n", shells = "*ELEMENT_SHELL\n", low, high, ends;
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) nodes += fmt::format("{},{},{},{}\n", node(i, j, k), i, j, k);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        const int id = 1 + 4 * i + 2 * j + k;
        solids += fmt::format("{},1", id);
        for (const auto& c : corner) solids += fmt::format(",{}", node(i + c[0], j + c[1], k + c[2]));
        solids += "\n";
        (i < 3 ? low : high) += fmt::format("{},\n", id);
        if (i == 0 || i == 9) ends += fmt::format("{},\n", id);
        if (k == 1)
          shells += fmt::format("{},2,{},{},{},{}\n", 100 + id, node(i, j, 2), node(i + 1, j, 2), node(i + 1, j + 1, 2),
                                node(i, j + 1, 2));
      }
  return "*KEYWORD\n" + nodes + "*PART\ncore\n1,\n" + solids + "*PART\nskin\n2,\n" + shells +
         "*SET_SOLID_LIST_TITLE\nlow\n1,\n" + low + "*SET_SOLID_LIST_TITLE\nhigh\n2,\n" + high +
         "*SET_SOLID_LIST_TITLE\nends\n3,\n" + ends + "*END\n";
}

/// Writes the mesh for all ranks.
class CoatedBar {
 public:
  CoatedBar() : path_(folder_.path() + "/bar.k") {
    if (Communicator::world().rank() == 0) std::ofstream(path_) << write_coated_bar();
    Communicator::world().barrier();
  }
  const std::string& path() const { return path_; }
  const std::string& folder() const { return folder_.path(); }

 private:
  SharedFolder folder_;
  std::string path_;
};

/// The bar with the density 2 and shells of the thickness 0.1. blocks: a list.
std::string make_coated(const CoatedBar& bar, const std::string& blocks, const std::string& more) {
  return fmt::format(
      R"(
parts: {{bar: {{mesh: {{file: {}}}, material: m, thickness: 0.1{}}}}}
materials: {{m: {{model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25, failure: {{principal_strain: 9}}}}}}
output: {{history: {{parts: all, blocks: {}}}}}
{})",
      bar.path(),
      more.find("every: 3") == std::string::npos ? "" : ", mass_scaling: {step: 0.1, every: 3, max_added: 2}", blocks,
      more);
}

/// The columns of blocks, or of parts, by heading.
std::map<std::string, double> name_values(const std::vector<HistoryColumn>& columns, const std::vector<double>& row) {
  EXPECT_EQ(row.size(), columns.size());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < row.size(); ++i) values[columns[i].name] = row[i];
  return values;
}

std::vector<double> take_block_row(const Scene& scene) {
  std::vector<double> row;
  BlockEnergies(scene.deck, scene.chunked).append(scene.model, scene.state, row);
  return row;
}

std::map<std::string, double> sum_blocks(const Scene& scene) {
  return name_values(list_block_columns(scene.deck), take_block_row(scene));
}

/// Expects the sums of all columns over these blocks to be those of the part.
void expect_part(const Scene& scene, const std::vector<std::string>& blocks) {
  std::vector<double> row;
  PartEnergies(scene.deck, scene.chunked).append(scene.model, scene.state, row);
  const auto part = name_values(list_part_columns(find_booked_parts(scene.deck)), row), of_blocks = sum_blocks(scene);
  const double energy = part.at("kinetic:bar") + std::abs(part.at("internal:bar")) + part.at("eroded_energy:bar");
  const double mass = part.at("mass:bar");
  for (const auto& [name, value] : part) {
    const std::string quantity = name.substr(0, name.find(':'));
    double sum = 0;
    for (const std::string& block : blocks) sum += of_blocks.at(quantity + ":" + block);
    const bool is_of_mass = quantity == "mass" || quantity == "eroded_mass";
    const double scale = is_of_mass ? mass : quantity.starts_with("momentum") ? std::sqrt(2 * mass * energy) : energy;
    EXPECT_NEAR(sum, value, 1e-14 * scale) << quantity;
  }
}

constexpr const char* all_blocks = "[core, bar/skin, low, bar/high, ends]";
constexpr const char* moving_text = R"(time: {end: 1000}
initial: [{part: bar, velocity: [0.3, 0.1, -0.2], angular_velocity: [0.02, 0.05, 0.03]}]
added_mass: [{nodes: {inside: [[0, 0, 0], [3, 2, 2]]}, mass: 5}]
conditions: [{nodes: {inside: [[0, 0, 0], [0, 2, 2]]}, fixed: [y, rx]}]
loads: {gravity: [0, 0.1, -0.2]}
walls: [{point: [10.5, 0, 0], normal: -x}]
contact: {surfaces: all}
)";

/// Elements die: cubes of "low" and "high" and a shell, at last all that hold an edge.
void erode_bar(ErodingScene& eroding, int steps = 8) {
  eroding.run(steps);
  eroding.kill({{2.5, 0.5, 0.5}, {3.5, 1.5, 1.5}, {3.5, 1.5, 2}});
  eroding.run(steps);
  eroding.kill({{0.5, 0.5, 0.5}});
  eroding.run(steps);
}

}  // namespace

TEST(BlockEnergies, AreThoseOfBodiesThatFly) {
  const CoatedBar bar;
  Scene scene(make_coated(bar, all_blocks, "time: {end: 1}\ninitial: [{part: bar, velocity: [1, 2, 3]}]\n"));
  scene.run(20);
  const std::map<std::string, double> values = sum_blocks(scene),
                                      masses{
                                          {"core", 80}, {"bar/skin", 4}, {"low", 24}, {"bar/high", 56}, {"ends", 16}};
  for (const auto& [block, mass] : masses) {
    EXPECT_NEAR(values.at("mass:" + block), mass, 1e-13 * mass);
    EXPECT_NEAR(values.at("kinetic:" + block), 7 * mass, 1e-12 * mass);
    EXPECT_NEAR(values.at("momentum_x:" + block), mass, 1e-12 * mass);
    EXPECT_NEAR(values.at("momentum_y:" + block), 2 * mass, 1e-12 * mass);
    EXPECT_NEAR(values.at("momentum_z:" + block), 3 * mass, 1e-12 * mass);
    EXPECT_NEAR(values.at("internal:" + block), 0, 1e-12 * mass);
  }
}

TEST(BlockEnergies, AreThoseOfTheElementThatIsStretched) {
  // One end moves, all else is held: each cube of the last layer has the strain e = ln(1 + u t) in x and takes the work
  // M e^2 / 2, where M is the modulus of uniaxial strain. Its free nodes have an eighth of its mass each.
  const CoatedBar bar;
  Scene scene(make_coated(bar, "[high, ends, low]",
                          R"(time: {end: 1, max_step: 0.001}
conditions:
  - {nodes: {inside: [[0, 0, 0], [9, 2, 2]]}, fixed: [x, y, z, rx, ry, rz]}
  - {nodes: {inside: [[10, 0, 0], [10, 2, 2]]}, velocity: {x: 0.1, y: 0, z: 0}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
)"));
  scene.run(100);
  const std::map<std::string, double> values = sum_blocks(scene);
  const double strain = std::log(1 + 0.1 * scene.state.time), modulus = 120;
  const double work = 4 * 0.5 * modulus * strain * strain;
  EXPECT_NEAR(values.at("internal:high"), work, 1e-6 * work);
  EXPECT_NEAR(values.at("internal:ends"), work, 1e-6 * work);
  EXPECT_EQ(values.at("internal:low"), 0);
  EXPECT_NEAR(values.at("kinetic:ends"), 0.5 * 4 * 0.01, 1e-14);  // half of the mass of four cubes
  EXPECT_NEAR(values.at("momentum_x:high"), 4 * 0.1, 1e-14);
  EXPECT_EQ(values.at("kinetic:low"), 0);
}

TEST(BlockEnergies, AddUpToThoseOfTheirPart) {
  const CoatedBar bar;
  for (const char* more : {"", "erosion: {free_nodes: remove}\n", "elements: {resist_folding: true}\n"}) {
    ErodingScene eroding(make_coated(bar, all_blocks, std::string(moving_text) + more));
    expect_part(eroding.scene, {"core", "bar/skin"});
    eroding.run(10);
    erode_bar(eroding);
    EXPECT_EQ(eroding.audit(eroding.scene.state).eroded.elements, 4);
    expect_part(eroding.scene, {"core", "bar/skin"});
    expect_part(eroding.scene, {"low", "bar/high", "bar/skin"});
    const std::map<std::string, double> values = sum_blocks(eroding.scene);
    EXPECT_NEAR(values.at("eroded_mass:low"), 4, 1e-13);
    EXPECT_NEAR(values.at("eroded_mass:bar/high"), 2, 1e-13);
    EXPECT_NEAR(values.at("eroded_mass:bar/skin"), 0.2, 1e-14);
    EXPECT_GT(values.at("eroded_energy:low"), 0);
  }
}

TEST(BlockEnergies, AddUpWhereMassComesDuringTheRun) {
  const CoatedBar bar;
  Scene scene(make_coated(bar, all_blocks, std::string(moving_text) + "# every: 3\n"));
  scene.run(40);
  EXPECT_GT(scene.state.books.added_mass, 0);
  expect_part(scene, {"core", "bar/skin"});
  expect_part(scene, {"low", "bar/high", "bar/skin"});
}

TEST(BlockEnergies, AreTheSameBitsOnAnyRanks) {
  const CoatedBar bar;
  const std::string deck = make_coated(bar, all_blocks, moving_text);
  ErodingScene together(deck), alone(deck, Communicator(MPI_COMM_SELF));
  erode_bar(together);
  erode_bar(alone);
  EXPECT_EQ(take_block_row(together.scene), take_block_row(alone.scene));
}

TEST(BlockEnergies, GoOnAfterARestart) {
  const CoatedBar bar;
  const std::string whole = bar.folder() + "/whole", parts = bar.folder() + "/parts";
  if (Communicator::world().rank() == 0)
    for (const std::string& path : {whole, parts}) std::filesystem::create_directory(path);
  Communicator::world().barrier();
  const auto run = [&](const std::string& time, const std::string& more, const std::string& folder,
                       const std::string& restart) {
    std::string text = make_coated(bar, all_blocks, moving_text);
    text.replace(text.find("time: {end: 1000}"), 17, "time: " + time);
    text.replace(text.find("9}}"), 1, "0.02");
    text.replace(text.find("output: {"), 9, "output: {" + more);
    RunOptions options;
    options.out_dir = folder;
    options.restart = restart;
    options.goes_on_in_place = !restart.empty();
    return run_scene(parse_deck(text, "deck.yaml"), options).summary;
  };
  EXPECT_GT(run("{end: 6}", "", whole, "").eroded.elements, 0);
  run("{end: 6, max_steps: 60}", "checkpoint: {every: 3}, ", parts, "");
  run("{end: 6}", "", parts, parts + "/checkpoint.h5");
  if (Communicator::world().rank() != 0) return;
  const auto read = [](const std::string& path) {
    std::ostringstream all;
    all << std::ifstream(path, std::ios::binary).rdbuf();
    return all.str();
  };
  const std::string text = read(whole + "/history.csv");
  EXPECT_NE(text.find("eroded_energy:bar/skin"), std::string::npos);
  EXPECT_TRUE(read(parts + "/history.csv") == text);
}

TEST(BlockEnergies, RefuseNamesThatAreNoBlocks) {
  const CoatedBar bar;
  const auto take = [&](const char* blocks) { take_block_row(Scene(make_coated(bar, blocks, "time: {end: 1}\n"))); };
  EXPECT_NO_THROW(take("[core, bar/low]"));
  EXPECT_ERROR(take("[cores]"), InputError, "is called 'cores'");
  EXPECT_ERROR(take("[bar/cores]"), InputError, "is called 'bar/cores'");
  EXPECT_ERROR(take("[bar]"), InputError, "names the part 'bar'");
}

}  // namespace percuss::test
