// What a run warns of in its steps and at its end, by the numbers of its contact and its energies.

#include "src/step/run/run_notes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "src/step/run/run_warnings.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> format_all(const std::vector<Warning>& warnings) {
  std::vector<std::string> lines;
  lines.reserve(warnings.size());
  for (const Warning& warning : warnings) lines.push_back(format_warning(warning));
  return lines;
}

/// Warnings of a run in which contact has done so much work.
std::vector<std::string> find_texts(double work, const EnergyScales& scales, const std::string& units = "",
                                    double friction = 0) {
  const double given = find_given(work, friction, scales);
  if (!is_gain(given, find_tolerated_gain({}), scales)) return {};
  return format_all({warn_of_gain(given, scales, {201, 5, {0, 0, 1}, 0.25}, units)});
}

TEST(ContactGain, IsNotToldOfARunWithoutDoubts) {
  EXPECT_THAT(find_texts(0, {}), IsEmpty());
  EXPECT_THAT(find_texts(0.9, {.largest = 100}), IsEmpty());
  EXPECT_THAT(find_texts(-30, {.largest = 100}), IsEmpty());
}

TEST(ContactGain, IsToldWithStepAndPlaceInTheUnitsOfTheDeck) {
  EXPECT_THAT(find_texts(30, {.largest = 100}),
              ElementsAre(AllOf(HasSubstr("added 30 of energy, 30 % of the largest, first above the limit in step 201, "
                                          "most of it then at node 5 at (0, 0, 1) ("),
                                HasSubstr("[contact_energy] (t = 0.25)"))));
  EXPECT_THAT(find_texts(30, {.largest = 100}, "mm, t, s"), ElementsAre(HasSubstr("added 30 mJ of energy, 30 %")));
  EXPECT_THAT(find_texts(30, {}),
              ElementsAre(StartsWith("warning: contact has added 30 of energy first above the limit")));
}

TEST(ContactGain, IsNotOfEnergyThatIsRoundOffOrWasAskedFor) {
  EXPECT_THAT(find_texts(5e-26, {.largest = 5e-26, .resolved = 1e-20}), IsEmpty());
  EXPECT_THAT(find_texts(30, {.largest = 100, .granted = 29.5}), IsEmpty());
  EXPECT_THAT(find_texts(30, {.largest = 100, .granted = 10}), ElementsAre(HasSubstr("added 20 of energy")));
}

TEST(ContactGain, IsOfPushesOrOfFrictionWithTheirOwnSprings) {
  EXPECT_THAT(find_texts(-10, {.largest = 100, .stored = 30, .stored_slip = 20}, "", -20), IsEmpty());
  EXPECT_THAT(find_texts(-10, {.largest = 100, .stored = 30, .stored_slip = 20}, "", -16),
              ElementsAre(HasSubstr("added 4 of energy")));
  EXPECT_THAT(find_texts(-10, {.largest = 100, .stored = 30, .stored_slip = 15}, "", -20),
              ElementsAre(HasSubstr("added 5 of energy")));
  EXPECT_THAT(find_texts(0, {.largest = 100}, "", 4), ElementsAre(HasSubstr("added 4 of energy")));
}

TEST(ContactGain, CountsWhatTheSpringsOfContactHold) {
  EXPECT_THAT(find_texts(-10, {.largest = 100, .stored = 10}), IsEmpty());
  EXPECT_THAT(find_texts(-10, {.largest = 100, .stored = 30}), ElementsAre(HasSubstr("added 20 of energy")));
}

TEST(ContactGain, IsLimitedByTheDeck) {
  AuditDeck audit;
  EXPECT_EQ(find_tolerated_gain(audit), 0.01);
  audit.max_contact_gain = 1e-3;
  EXPECT_TRUE(is_gain(0.2, find_tolerated_gain(audit), {.largest = 100}));
}

TEST(ElementEnergy, IsToldWhereElementsHaveGivenMoreThanTheyTook) {
  EnergySummary energy;
  energy.kinetic = 22258, energy.work = {-4778, -32389};
  EXPECT_EQ(find_given_by_elements(energy, true), 4778 + 32389);
  EXPECT_EQ(find_given_by_elements(energy, false), 32389);  // a gas may have given the rest
  energy.work[WorkKind::hourglass] = 5000;
  EXPECT_EQ(find_given_by_elements(energy, true), 4778);
  EXPECT_LT(find_given_by_elements({}, true), 1e-300);
  EXPECT_THAT(format_all(warn_of_elements(3, {.largest = 100}, 0.25, "m, kg, s")),
              ElementsAre(AllOf(HasSubstr("elements have given 3 J of energy more than they took, 3 % of the largest"),
                                HasSubstr("[element_energy] (t = 0.25)"))));
  EXPECT_THAT(warn_of_elements(0.9, {.largest = 100}, 0.25, ""), IsEmpty());
  EXPECT_THAT(warn_of_elements(3, {.largest = 100, .resolved = 4}, 0.25, ""), IsEmpty());
  EXPECT_THAT(warn_of_elements(-3, {.largest = 100}, 0.25, ""), IsEmpty());
}

TEST(EndWarnings, TellABalanceThatIsOff) {
  Summary summary;
  summary.energy.error = -0.009;
  EXPECT_THAT(find_end_warnings(summary, {.largest = 1}, {}), IsEmpty());
  summary.energy.error = -0.023;
  EXPECT_THAT(format_all(find_end_warnings(summary, {.largest = 1}, {})),
              ElementsAre(AllOf(HasSubstr("off by -2.3 % of the largest energy"), HasSubstr("[energy_error]"))));
  EXPECT_THAT(find_end_warnings(summary, {.largest = 1e-20, .resolved = 1e-19}, {}), IsEmpty());
}

TEST(EndWarnings, NameThePartAndTheElementThatHourglass) {
  EXPECT_THAT(
      format_all(find_end_warnings({}, {.largest = 100}, {{"bar", 10, 2.5, "element 7 of part 'bar' at (1, 2, 3)"}})),
      ElementsAre(AllOf(StartsWith("part 'bar': warning: hourglass modes hold 25 % of the strain energy, most of "
                                   "it near element 7 of part 'bar' at (1, 2, 3) ("),
                        HasSubstr("[hourglass_energy]"))));
}

TEST(EndWarnings, SayOfAFluidWhatItsControlHolds) {
  EXPECT_THAT(format_all(find_end_warnings({}, {.largest = 100}, {{"water", 10, 2.5, "element 7", true}})),
              ElementsAre(AllOf(HasSubstr("25 % of the strain energy of a fluid"), HasSubstr("elements.hourglass"),
                                Not(HasSubstr("single nodes")), HasSubstr("[hourglass_energy]"))));
}

TEST(ContactLoss, IsTheWorkLessWhatSpringsHold) {
  EXPECT_EQ(find_taken(-30, 2, {.largest = 100, .stored = 5, .stored_slip = 1}), 28);
  EXPECT_EQ(find_taken(3, 0, {.largest = 100}), 0);
  EXPECT_EQ(find_taken(-3, 0, {.largest = 100, .resolved = 4}), 0);
}

TEST(HourglassLimits, LeaveAloneWhatRingsAfterAnImpact) {
  const HourglassLimits limits = find_hourglass_limits({.largest = 1000, .resolved = 0.5, .largest_strain = 400});
  EXPECT_EQ(limits.least, 1);
  EXPECT_EQ(limits.least_of_all, 8);
  EXPECT_LT(limits.share, limits.whole_share);
}

TEST(StepWarnings, TellContactThatDidNotConvergeOrIsDeep) {
  ContactReport report;
  report.deepest = 0.09;
  EXPECT_THAT(warn_of_residual(report, 0.5), IsEmpty());
  EXPECT_FALSE(is_deep(report, 0));
  report.converged = false;
  EXPECT_THAT(
      format_all(warn_of_residual(report, 0.5)),
      ElementsAre(AllOf(HasSubstr("did not converge in a step"), HasSubstr("[unconverged_contact] (t = 0.5)"))));
  report.deepest = 0.2;
  EXPECT_TRUE(is_deep(report, 0));
  EXPECT_FALSE(is_deep(report, 0.15));  // 0.15 were accepted at the start
  EXPECT_THAT(
      format_warning(warn_of_depth(0.5, "node 17 at (1, 2, 3), 0.2 of a face edge")),
      AllOf(HasSubstr("deeper than 0.1 of a face edge, first node 17 at (1, 2, 3), 0.2 of a face edge (contact"),
            HasSubstr("[deep_penetration] (t = 0.5)")));
}

// To name the node takes all ranks and copies of positions: it is done once, and not for a warning that nobody hears.
TEST(StepWarnings, NameTheDeepestNodeOnce) {
  for (const bool is_silenced : {false, true}) {
    std::set<std::string> silenced;
    if (is_silenced) silenced.insert(deep_penetration);
    RunWarnings warnings(silenced, Communicator::world());
    ContactReport report;
    int names = 0;
    const auto note = [&](double deepest, double time) {
      report.deepest = deepest;
      warnings.note_step(report, time, [&] { return fmt::format("node {}", ++names); });
    };
    note(0, 1);
    note(0.2, 2);
    report.converged = false;
    note(0.3, 3);
    note(0.05, 4);
    EXPECT_EQ(names, is_silenced ? 0 : 1);
    const auto& told = warnings.list();
    ASSERT_EQ(told.size(), is_silenced ? 1U : 2U);
    EXPECT_EQ(told.back().rule, "unconverged_contact");
    if (is_silenced) continue;
    EXPECT_THAT(told[0].text, HasSubstr("first node 1 (contact"));
    EXPECT_EQ(told[0].time, 2);
    EXPECT_EQ(told[0].count, 2);
  }
}

TEST(ResolvedEnergy, IsThatOfAMotionByTheRoundOffOfContact) {
  const Scene scene(
      "time: {end: 1}\nparts: {a: {box: {size: [1, 1, 4], cells: [1, 1, 1]}, at: [0, 0, -8], material: m}}\n"
      "materials: {m: {model: elastic, density: 3, youngs_modulus: 1, poissons_ratio: 0}}\n");
  // mass 12, ten times 1e-14 of the largest coordinate 8 in a step of 0.1
  EXPECT_NEAR(find_resolved_energy(scene.chunked, scene.model, 0.1), 0.5 * 12 * 8e-12 * 8e-12, 1e-32);
  EXPECT_EQ(find_resolved_energy(scene.chunked, scene.model, 0), 0);
}

}  // namespace
}  // namespace percuss::test
