// Parts that cross at the start: which, how deep and where, by geometry, on one rank and on several.

#include "src/contact/overlap/start_crossings.hpp"

#include <gtest/gtest.h>

#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/contact/overlap/start_overlap.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

using Contact = PartCrossing::Contact;

/// The start of a scene of some parts; what else the deck has.
struct Start {
  explicit Start(const std::string& parts, const std::string& rest = "contact: {surfaces: all}\n")
      : deck(parse_deck("time: {end: 1}\nparts:\n" + parts + "\n" + rest +
                            "materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n",
                        "deck.yaml")),
        chunked(load_mesh(deck, Communicator::world())),
        stage(chunked, deck, Communicator::world()) {
    stage.set_switches(std::vector<char>(deck.sensors.size(), 0));
    stage.prepare(to_rows("test::x", chunked.mesh.nodes), Rows3<double>("test::v", chunked.mesh.nodes.size()));
    for (const PartCrossing& crossing : stage.start_overlap().crossings)
      if (crossing.is_deep()) crossings.push_back(crossing);
  }

  /// The gap between the first two parts.
  double find_gap() const {
    for (const PartGap& gap : stage.start_overlap().gaps)
      if (gap.part == 0 && gap.other == 1) return gap.gap;
    return 1e300;
  }

  Deck deck;
  ChunkedMesh chunked;
  ContactStage stage;
  std::vector<PartCrossing> crossings;
};

/// One crossing of the first two parts, of this depth at this place; the gap is its negative.
void expect_crossing(const Start& start, double depth, const Vec3& place, double round_off = 1e-9) {
  ASSERT_EQ(start.crossings.size(), 1U);
  const PartCrossing& found = start.crossings.front();
  EXPECT_EQ(found.part, 0);
  EXPECT_EQ(found.other, 1);
  EXPECT_EQ(found.contact, Contact::now);
  EXPECT_NEAR(found.depth, depth, round_off);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found.deepest[k], place[k], 1e-9) << k;
  EXPECT_FALSE(found.places.empty());
  EXPECT_LE(start.find_gap(), -found.depth);
}

const std::string plate =
    "  plate: {shell_plate: {size: [200, 200], cells: [20, 20]}, at: [-100, -100, 0], thickness: 1.5, material: m}\n";
const std::string turn = "rotate: [{axis: x, angle: 90}]";  // a sheet of x and y stands

TEST(StartCrossings, FindABallThroughAPlate) {
  // Its lowest node is at z = 15 - 20; the faces about it are flat within 1e-9 of this depth from the node.
  const Start start(plate + "  ball: {sphere: {radius: 20, cells: 8}, at: [0, 0, 15], material: m, rigid: {}}");
  expect_crossing(start, 5, {0, 0, -5}, 1e-9);
}

TEST(StartCrossings, FindABlockInsideAPanelWhoseNodesLieInItsPlane) {
  const Start start(
      "  panel: {shell_plate: {size: [300, 200], cells: [30, 20]}, thickness: 1.2, material: m}\n"
      "  block: {box: {size: [60, 40, 20], cells: [12, 8, 4]}, at: [120, 80, -5], material: m}");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_NEAR(start.crossings.front().depth, 5, 1e-9);
  EXPECT_NEAR(start.find_gap(), -5, 1e-9);
}

TEST(StartCrossings, FindASheetThroughASheet) {
  // The second one reaches from z = -6 to 44, beside the nodes of the first.
  const Start start(plate + "  wall: {shell_plate: {size: [50, 50], cells: [7, 7]}, " + turn +
                    ", at: [-23, 3, -6], thickness: 1, material: m}");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_NEAR(start.crossings.front().depth, 6, 1e-9);
  EXPECT_NEAR(start.crossings.front().deepest[2], -6, 1e-9);
}

TEST(StartCrossings, FindSheetsThatAreSlitIntoEachOther) {
  // The second one reaches over the end of the first at x = 100, and 37 into it; neither is divided. Its nodes lie
  // almost in the plane of the first.
  const Start start(plate + "  wall: {shell_plate: {size: [50, 50], cells: [5, 5]}, " + turn +
                    ", at: [63, 3, -20.001], thickness: 1, material: m}");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_NEAR(start.crossings.front().depth, 37, 10);  // of the edges in it, 10 long
}

TEST(StartCrossings, FindARodWithinAFaceOfACoarseSheet) {
  // No node of the sheet is near it, and none of its edges meets the rod: 20 of 60 are beyond.
  const Start start(plate + "  rod: {box: {size: [2, 2, 60], cells: [1, 1, 7]}, at: [4, 4, -20], material: m}");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_NEAR(start.crossings.front().depth, 20, 1e-9);
}

TEST(StartCrossings, FindABeamThroughASheet) {
  const Start start(
      plate + "  bar: {line: {from: [3, 4, -7], to: [3, 4, 30], cells: 3}, section: {round: {radius: 1}}, material: m}",
      "contact: {surfaces: all, beams: true}\n");
  expect_crossing(start, 7, {3, 4, -7});
}

TEST(StartCrossings, FindABeamInASolidWithoutContact) {
  const Start start(
      "  block: {box: {size: [40, 40, 30], cells: [4, 4, 3]}, material: m}\n"
      "  bar: {line: {from: [3, 24, 12], to: [103, 24, 12], cells: 4}, section: {round: {radius: 1}}, material: m}");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_EQ(start.crossings.front().contact, Contact::never);
  EXPECT_NEAR(start.crossings.front().depth, 12, 1e-9);  // of its node at x = 28 from the face z = 0 or x = 40
  EXPECT_EQ(start.find_gap(), 1e300);
  ASSERT_EQ(start.stage.start_notes().size(), 1U);
  EXPECT_EQ(start.stage.start_notes().front(),
            "crossing at the start, without contact: 'block' and 'bar' by 12 at (28, 24, 12)");
}

TEST(StartCrossings, FindTheRidgeOfASolidInAnother) {
  // The second block stands on an edge and dips 3 into the first.
  const Start start(
      "  low: {box: {size: [40, 40, 10], cells: [2, 2, 1]}, material: m}\n"
      "  high: {box: {size: [20, 20, 20], cells: [2, 2, 2]}, rotate: [{axis: y, angle: 45}], at: [5, 10, "
      "21.142135623730951], material: m}");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_NEAR(start.crossings.front().depth, 3, 1e-9);  // its lowest line lies at 21.142 - 14.142 = 7
}

TEST(StartCrossings, AreSilentOnNearMisses) {
  EXPECT_TRUE(
      Start(plate + "  ball: {sphere: {radius: 20, cells: 8}, at: [0, 0, 20.01], material: m}").crossings.empty());
  EXPECT_TRUE(Start(plate + "  rod: {box: {size: [2, 2, 60], cells: [1, 1, 7]}, at: [100.01, 4, -20], material: m}")
                  .crossings.empty());
  EXPECT_TRUE(Start(plate + "  bar: {line: {from: [3, 4, 0.01], to: [3, 4, 30], cells: 3}, section: {round: {radius: "
                            "1}}, material: m}",
                    "contact: {surfaces: all, beams: true}\n")
                  .crossings.empty());
}

TEST(StartCrossings, AreSilentWhereSurfacesAreFlush) {
  const std::string low = "  low: {box: {size: [40, 40, 10], cells: [4, 4, 2]}, material: m}\n";
  for (const char* const at :
       {"[0, 0, 10]", "[10, 0, 10]", "[-7, 13, 10]", "[40, 0, 0]", "[40, 10, 5]", "[40, 40, 10]"})
    EXPECT_TRUE(Start(low + "  high: {box: {size: [40, 40, 10], cells: [4, 4, 2]}, at: " + at + ", material: m}")
                    .stage.start_overlap()
                    .crossings.empty())
        << at;
  // Sheets that stand on a sheet or a solid without common nodes, above it and below it, and one that continues it.
  for (const char* const at : {"[-25, 5, 0]", "[-25, 0, 0]", "[-25, 5, -50]"})
    for (const char* const contact : {"contact: {surfaces: all}\n", ""})
      EXPECT_TRUE(Start(plate + "  wall: {shell_plate: {size: [50, 50], cells: [7, 7]}, " + turn + ", at: " + at +
                            ", thickness: 1, material: m}",
                        contact)
                      .stage.start_overlap()
                      .crossings.empty())
          << at << contact;
  EXPECT_TRUE(Start(low + "  wall: {shell_plate: {size: [50, 50], cells: [7, 7]}, " + turn +
                        ", at: [-5, 15, 10], thickness: 1, material: m}",
                    "")
                  .stage.start_overlap()
                  .crossings.empty());
  EXPECT_TRUE(Start(plate + "  next: {shell_plate: {size: [50, 50], cells: [5, 5]}, at: [70, -25, 0], thickness: 1.5, "
                            "material: m}")
                  .crossings.empty());
}

TEST(StartCrossings, AreSilentWhereNodesAreCommonOrPartsAreMeantToCross) {
  const std::string block = "  block: {box: {size: [40, 40, 30], cells: [4, 4, 3]}, material: m}\n";
  const std::string bar =
      "  bar: {line: {from: [5, 24, 12], to: [55, 24, 12], cells: 5}, section: {round: {radius: 1}}, material: m}";
  EXPECT_TRUE(Start(block + bar, "embedded: {bars: {nodes: bar, in: block}}\n").crossings.empty());
  const std::string cross = "  wall: {shell_plate: {size: [50, 50], cells: [5, 5]}, " + turn +
                            ", at: [-30, 0, -30], thickness: 1, material: m}";
  EXPECT_TRUE(Start(plate + cross, "join: [{parts: [plate, wall]}]\ncontact: {surfaces: all}\n").crossings.empty());
  EXPECT_EQ(Start(plate + cross, "contact: {surfaces: all}\n").crossings.size(), 1U);
  const std::string rigid_ball =
      "  ball: {sphere: {radius: 20, cells: 8}, at: [0, 0, 15], material: m, rigid: {body: one}}\n"
      "  cap: {sphere: {radius: 10, cells: 4}, at: [0, 0, 36], material: m, rigid: {body: one}}";
  EXPECT_TRUE(Start(rigid_ball).crossings.empty());
}

TEST(StartCrossings, TellOfContactThatASensorBegins) {
  const Start start(plate + "  ball: {sphere: {radius: 20, cells: 8}, at: [0, 0, 15], material: m}",
                    "sensors: {late: {time: 0.5}}\ncontact: {surfaces: [{a: plate, b: ball, from: late}]}\n");
  ASSERT_EQ(start.crossings.size(), 1U);
  EXPECT_EQ(start.crossings.front().contact, Contact::later);
  EXPECT_NEAR(start.crossings.front().depth, 5, 1e-9);
}

TEST(StartCrossings, AreRefusedByName) {
  const std::string ball = "  ball: {sphere: {radius: 20, cells: 8}, at: [0, 0, 15], material: m}";
  for (const char* const overlap : {"refuse", "push_out"}) {
    std::string text;
    try {
      const Start start(plate + ball, fmt::format("contact: {{surfaces: all, overlap: {}}}\n", overlap));
    } catch (const InputError& error) {
      text = error.what();
    }
    EXPECT_NE(text.find("'plate' and 'ball' by 5 at (0, 0, -5)"), std::string::npos) << overlap << ": " << text;
  }
}

TEST(StartCrossings, LeaveFlushTiedFacesAlone) {
  const std::string parts =
      "  panel: {shell_plate: {size: [300, 200], cells: [30, 20]}, thickness: 1.2, material: m}\n"
      "  block: {box: {size: [60, 40, 20], cells: [12, 8, 4]}, at: [120, 80, 0.6], material: m}";
  for (const char* const tie : {"{a: block/z_min, b: panel}", "{a: panel, b: block/z_min}"}) {
    const Start start(parts, fmt::format("contact: {{surfaces: all, ties: [{}]}}\n", tie));
    EXPECT_TRUE(start.stage.start_overlap().crossings.empty()) << tie;
    EXPECT_EQ(start.stage.start_overlap().nodes, 0) << tie;
    EXPECT_EQ(start.find_gap(), 0) << tie;
  }
}

}  // namespace
}  // namespace percuss::test
