// fields.exo of whole runs: the numbers of fields.vtkhdf, what erodes, and what a restart makes of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comm/agreement.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using sample::Hdf5FileView;
using testing::HasSubstr;

// A bar that is pulled apart at its end, and shells.
std::string make_deck(const std::string& format, const std::string& more = "") {
  return R"yaml(
time: {end: 0.02, max_step: 1.0e-3)yaml" +
         more + R"yaml(}
parts:
  bar: {box: {size: [3, 1, 1], cells: [3, 1, 1]}, material: weak}
  plate: {shell_plate: {size: [1, 1], cells: [3, 2]}, thickness: 0.1, at: [0, 3, 0], material: sound}
materials:
  weak: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0, failure: {principal_stress: 1}}
  sound: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0}
initial: [{part: plate, velocity: [0, 0, 1]}]
conditions: [{nodes: bar/x_min, fixed: x}, {nodes: bar/x_max, velocity: {x: 1}}, {nodes: plate/x_min, fixed: z}]
output: {fields: {every: 5.0e-3, write: [velocity, stress], format: )yaml" +
         format + "}, checkpoint: {every: 1}}\n";
}

/// A folder that rank 0 makes, for all.
class Folder {
 public:
  Folder() {
    if (ranks_.rank() == 0) own_.emplace();
    path_ = broadcast_text(ranks_, own_ ? own_->path() : "", 0);
  }
  ~Folder() { ranks_.barrier(); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::string& path() const { return path_; }

 private:
  Communicator ranks_ = Communicator::world();
  std::optional<TemporaryFolder> own_;
  std::string path_;
};

void run(const std::string& deck, const std::string& folder, const std::string& restart = "") {
  RunOptions options;
  options.out_dir = folder;
  options.progress = Progress::Style::quiet;
  options.restart = restart;
  options.goes_on_in_place = !restart.empty();
  run_scene(parse_deck(deck, "deck.yaml"), options);
}

bool is_first_rank() { return Communicator::world().rank() == 0; }

/// One component of items [first, first + count) of every frame.
std::vector<double> pick(const std::vector<double>& rows, std::size_t items, std::size_t components,
                         std::array<std::size_t, 3> first_count_component) {
  const auto [first, count, component] = first_count_component;
  std::vector<double> picked;
  for (std::size_t frame = 0; frame < rows.size() / (items * components); ++frame) {
    for (std::size_t i = first; i < first + count; ++i)
      picked.push_back(rows[(frame * items + i) * components + component]);
  }
  return picked;
}

constexpr std::size_t bar_elements = 3, plate_elements = 6, elements = bar_elements + plate_elements,
                      nodes = 4 * 4 + 4 * 3;

TEST(ExodusOnRanks, HasTheNumbersOfVtkhdf) {
  const Folder folder;
  run(make_deck("[vtkhdf, exodus]"), folder.path());
  if (!is_first_rank()) return;
  const Hdf5FileView vtk(folder.path() + "/fields.vtkhdf"), exo(folder.path() + "/fields.exo");
  ASSERT_TRUE(exo.is_open());
  EXPECT_EQ(exo.numbers("time_whole"), vtk.numbers("VTKHDF/Steps/Values"));
  EXPECT_EQ(exo.numbers("vals_glo_var"), vtk.numbers("percuss/step"));
  EXPECT_EQ(exo.whole_numbers("node_num_map"), vtk.whole_numbers("VTKHDF/PointData/node_id"));
  EXPECT_EQ(exo.whole_numbers("elem_num_map"), vtk.whole_numbers("VTKHDF/CellData/element_id"));
  const std::vector<double> velocity = vtk.numbers("VTKHDF/PointData/velocity"),
                            stress = vtk.numbers("VTKHDF/CellData/stress");
  for (std::size_t d = 0; d < 3; ++d)  // after the displacement
    EXPECT_EQ(exo.numbers("vals_nod_var" + std::to_string(d + 4)), pick(velocity, nodes, 3, {0, nodes, d}));
  for (std::size_t k = 0; k < 6; ++k) {
    const std::string name = "vals_elem_var" + std::to_string(k + 1);
    EXPECT_EQ(exo.numbers(name + "eb1"), pick(stress, elements, 6, {0, bar_elements, k})) << k;
    EXPECT_EQ(exo.numbers(name + "eb2"), pick(stress, elements, 6, {bar_elements, plate_elements, k})) << k;
  }
}

TEST(ExodusOnRanks, TellsKindsAndErosion) {
  const Folder folder;
  run(make_deck("exodus"), folder.path());
  if (!is_first_rank()) return;
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/fields.vtkhdf"));
  const Hdf5FileView exo(folder.path() + "/fields.exo");
  EXPECT_EQ(exo.text_attribute("connect1", "elem_type"), "HEX8");
  EXPECT_EQ(exo.text_attribute("connect2", "elem_type"), "SHELL4");
  EXPECT_EQ(exo.shape("connect1"), (std::vector<hsize_t>{bar_elements, 8}));
  EXPECT_EQ(exo.shape("connect2"), (std::vector<hsize_t>{plate_elements, 4}));
  const std::vector<double> alive = exo.numbers("vals_elem_var7eb1");
  EXPECT_EQ(std::vector<double>(alive.begin(), alive.begin() + 3), (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(std::vector<double>(alive.end() - 3, alive.end()), (std::vector<double>{1, 1, 0}));
  for (const double one : exo.numbers("vals_elem_var7eb2")) EXPECT_EQ(one, 1);
}

/// Names of sets, each a row of characters.
std::vector<std::string> read_names(const Hdf5FileView& file, const std::string& name) {
  const std::vector<unsigned char> bytes = file.bytes(name);
  const std::size_t length = file.shape(name)[1];
  std::vector<std::string> names;
  for (std::size_t i = 0; i < bytes.size(); i += length)
    names.emplace_back(reinterpret_cast<const char*>(&bytes[i]));  // ends with a zero
  return names;
}

// The sets are those that the deck names, of generated parts; the bar is 3 long.
TEST(ExodusOnRanks, HasTheSetsThatTheDeckNames) {
  const Folder folder;
  run(make_deck("exodus"), folder.path());
  if (!is_first_rank()) return;
  const Hdf5FileView exo(folder.path() + "/fields.exo");
  EXPECT_EQ(read_names(exo, "ns_names"), (std::vector<std::string>{"bar/x_max", "bar/x_min", "plate/x_min"}));
  EXPECT_EQ(exo.whole_numbers("ns_prop1"), (std::vector<std::int64_t>{1, 2, 3}));
  const std::vector<double> x = exo.numbers("coordx"), y = exo.numbers("coordy");
  const auto places = [&](const std::string& name, const std::vector<double>& of) {
    std::vector<double> found;
    for (const std::int64_t node : exo.whole_numbers(name)) found.push_back(of.at(static_cast<std::size_t>(node - 1)));
    return found;
  };
  EXPECT_EQ(places("node_ns1", x), (std::vector<double>{3, 3, 3, 3}));
  EXPECT_EQ(places("node_ns2", x), (std::vector<double>{0, 0, 0, 0}));
  EXPECT_EQ(places("node_ns3", x), (std::vector<double>{0, 0, 0}));
  EXPECT_THAT(places("node_ns3", y), testing::Each(testing::Ge(3)));
  // Side 2 of HEX8 has the corners 2, 3, 7, 6 of the element, side 4 has 1, 5, 8, 4 (Exodus II manual, figure 4.4).
  ASSERT_EQ(read_names(exo, "ss_names"), (std::vector<std::string>{"bar/x_max", "bar/x_min"}));
  const std::vector<std::int64_t> corners = exo.whole_numbers("connect1");
  const auto corner_x = [&](const std::string& set, std::size_t corner) {
    const auto element = static_cast<std::size_t>(exo.whole_numbers("elem_" + set).at(0) - 1);
    return x.at(static_cast<std::size_t>(corners.at(8 * element + corner) - 1));
  };
  const std::size_t sides[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  for (const std::size_t corner : sides[exo.whole_numbers("side_ss1").at(0) - 1]) EXPECT_EQ(corner_x("ss1", corner), 3);
  for (const std::size_t corner : sides[exo.whole_numbers("side_ss2").at(0) - 1]) EXPECT_EQ(corner_x("ss2", corner), 0);
}

TEST(ExodusOnRanks, GoesOnAfterARestart) {
  const Folder whole, parts;
  run(make_deck("exodus"), whole.path());
  run(make_deck("exodus", ", max_steps: 8"), parts.path());
  run(make_deck("exodus"), parts.path(), parts.path() + "/checkpoint.h5");
  if (!is_first_rank()) return;
  const Hdf5FileView one(whole.path() + "/fields.exo"), other(parts.path() + "/fields.exo");
  EXPECT_EQ(other.datasets(), one.datasets());
  for (const std::string& name : one.datasets()) {
    EXPECT_EQ(other.shape(name), one.shape(name)) << name;
    EXPECT_EQ(other.bytes(name), one.bytes(name)) << name;
  }
}

TEST(ExodusOnRanks, ARestartThatDoesNotFitIsRefused) {
  const Folder folder;
  run(make_deck("vtkhdf", ", max_steps: 8"), folder.path());
  const std::string checkpoint = folder.path() + "/checkpoint.h5";
  const auto take_refusal = [&](const std::string& deck) -> std::string {
    try {
      run(deck, folder.path(), checkpoint);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  };
  EXPECT_THAT(take_refusal(make_deck("[vtkhdf, exodus]")),
              testing::AllOf(HasSubstr("fields.exo: error: "), HasSubstr("choose another folder with --out")));
}

}  // namespace
}  // namespace percuss::test
