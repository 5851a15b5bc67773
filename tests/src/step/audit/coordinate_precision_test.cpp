// Scenes far from the origin, where doubles are as far apart as their elements are long.

#include "src/step/audit/coordinate_precision.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two cubes of elements of 1e-3 at `place` and its neighbourhood.
std::vector<Warning> check(const std::string& place, const std::string& contact) {
  const Deck deck =
      parse_deck("time: {end: 1}\nparts:\n  a: {box: {size: [3e-3, 3e-3, 3e-3], cells: [3, 3, 3]}, at: [" + place +
                     ", 0, 0], material: m}\n" +
                     "  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}\n"
                     "materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n"
                     "contact: {surfaces: " +
                     contact + "}\n",
                 "deck.yaml");
  return check_coordinate_precision(deck, load_mesh(deck, Communicator::world()));
}

TEST(CoordinatePrecision, IsNotToldNearTheOrigin) {
  EXPECT_THAT(check("1e6", "all"), IsEmpty());  // 2.2e-16 * 1e6 / 1e-3 = 2.2e-7
  EXPECT_THAT(check("0", "none"), IsEmpty());
}

TEST(CoordinatePrecision, IsToldWhereRoundOffIsAMillionthOfAnElement) {
  for (const char* contact : {"all", "none"}) {
    const std::vector<Warning> warnings = check("1e7", contact);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].rule, "coordinate_precision");
    EXPECT_EQ(warnings[0].place, "deck.yaml:3:3");
    EXPECT_THAT(
        warnings[0].text,
        AllOf(
            HasSubstr(
                "coordinates as large as 1e+07 the resolution of double precision is 2.2e-06 of the shortest edge of"),
            HasSubstr("of part 'a'"), HasSubstr("`at`")));
  }
}

TEST(CoordinatePrecision, IsAnErrorWhereContactCannotTellSides) {
  EXPECT_THAT(check("1e9", "none"), testing::SizeIs(1));
  EXPECT_THAT([] { check("1e9", "all"); }, testing::ThrowsMessage<InputError>(AllOf(
                                               HasSubstr("deck.yaml:3:3: error: at coordinates as large as 1e+09"),
                                               HasSubstr("contact needs 2.2e-05"), HasSubstr("`at`"))));
  EXPECT_THAT([] { check("1e10", "none"); }, testing::ThrowsMessage<InputError>(HasSubstr("a run needs 0.001")));
}

TEST(CoordinatePrecision, OfElementsThatAreLargeWhereTheyAreIsEnough) {
  const Deck deck = parse_deck(
      "time: {end: 1}\n"
      "parts:\n"
      "  fine: {box: {size: [1e-3, 1e-3, 1e-3], cells: [1, 1, 1]}, material: m}\n"
      "  far: {box: {size: [1e6, 1e6, 1e6], cells: [1, 1, 1]}, at: [1e9, 0, 0], material: m}\n"
      "materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n",
      "deck.yaml", {"contact.surfaces=none"});
  EXPECT_THAT(check_coordinate_precision(deck, load_mesh(deck, Communicator::world())), IsEmpty());
}

}  // namespace
}  // namespace percuss::test
