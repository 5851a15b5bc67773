// One mesh in several formats: the same run, to the last bit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/output/summary.hpp"
#include "tests/src/app/percuss_process.hpp"
#include "tests/src/mesh/files/nastran_samples.hpp"
#include "tests/src/mesh/files/sample_files.hpp"
#include "tests/src/mesh/files/vtu_samples.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;

const char* const two_cubes_hit_a_wall = R"yaml(time: {end: 0.2}
parts: {bar: {mesh: {file: MESH, blocks: [block_1, block_2]}, material: soft}}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{velocity: [-0.1, 0, 0.01]}]
walls: [{normal: x, point: [-0.001, 0, 0]}]
)yaml";

TEST(PercussMeshes, GiveTheSameStateInEveryFormat) {
  const TemporaryFolder folder;
  const auto run = [&](const std::string& name, const std::string& text) {
    std::string deck = two_cubes_hit_a_wall;
    deck.replace(deck.find("MESH"), 4, folder.write(name, text));
    const std::string out = folder.path() + "/out_" + name;
    const ProcessResult result = run_percuss({"run", folder.write("deck.yaml", deck), "--quiet", "--out", out});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_summary(out + "/summary.json").state_hash;
  };
  const std::string expected = run("two.inp", abaqus_input);
  EXPECT_EQ(run("short.bdf", nastran_short), expected);
  EXPECT_EQ(run("long.nas", nastran_long), expected);
  EXPECT_EQ(run("free.dat", nastran_free), expected);
  EXPECT_EQ(run("two.vtu", make_vtu({VtuForm::appended_raw, true, true})), expected);
}

}  // namespace
}  // namespace percuss
