// The units of a deck and what follows from them.

#include "src/deck/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Force, stress, energy, velocity and density of a system.
std::vector<std::string> name_units(const std::string& text) {
  const std::optional<Units> units = find_units(text);
  if (!units) return {};
  using namespace dimensions;
  return {units->name_of(force), units->name_of(stress), units->name_of(energy), units->name_of(velocity),
          units->name_of(density)};
}

TEST(Units, FollowFromLengthMassAndTime) {
  EXPECT_THAT(name_units("m, kg, s"), ElementsAre("N", "Pa", "J", "m/s", "kg/m\u00b3"));
  EXPECT_THAT(name_units("mm, t, s"), ElementsAre("N", "MPa", "mJ", "mm/s", "t/mm\u00b3"));
  EXPECT_THAT(name_units("mm, kg, ms"), ElementsAre("kN", "GPa", "J", "mm/ms", "kg/mm\u00b3"));
  EXPECT_THAT(name_units("mm, g, ms"), ElementsAre("N", "MPa", "mJ", "mm/ms", "g/mm\u00b3"));
  EXPECT_THAT(name_units("mm, kg, s"), ElementsAre("mN", "kPa", "\u00b5J", "mm/s", "kg/mm\u00b3"));
  EXPECT_THAT(name_units("cm, g, us"), ElementsAre("g\u00b7cm/\u00b5s\u00b2", "Mbar", "g\u00b7cm\u00b2/\u00b5s\u00b2",
                                                   "cm/\u00b5s", "g/cm\u00b3"));
  EXPECT_THAT(name_units("cm, g, s"), ElementsAre("dyn", "g/(cm\u00b7s\u00b2)", "erg", "cm/s", "g/cm\u00b3"));
  EXPECT_THAT(name_units("in, lbf s2/in, s"),
              ElementsAre("lbf", "psi", "in\u00b7lbf", "in/s", "(lbf\u00b7s\u00b2/in)/in\u00b3"));
  EXPECT_THAT(name_units("ft, slug, s"), ElementsAre("lbf", "psf", "ft\u00b7lbf", "ft/s", "slug/ft\u00b3"));
  for (const std::string& system : list_unit_systems()) EXPECT_EQ(find_units(system)->text(), system);
}

TEST(Units, AreThoseOfSiByTheirSize) {
  const Units units = find_units("mm, kg, ms").value();
  EXPECT_NEAR(units.in_si(dimensions::stress), 1e9, 1e-3);
  EXPECT_NEAR(units.in_si(dimensions::velocity), 1, 1e-15);
  // psi: NIST Special Publication 811, 6.894 757 kPa
  EXPECT_NEAR(find_units("in, lbf s2/in, s")->in_si(dimensions::stress), 6894.757, 5e-4);
}

TEST(Units, MayBeSpelledInSeveralWays) {
  EXPECT_EQ(find_units("SI")->text(), "m, kg, s");
  EXPECT_EQ(find_units(" mm,kg , ms ")->text(), "mm, kg, ms");
  EXPECT_EQ(find_units("cm, g, \u00b5s")->name_of(dimensions::time), "\u00b5s");
  EXPECT_EQ(find_units("m, kg, s, C")->text(), "m, kg, s, C");
  for (const char* mass : {"lbf s^2/in", "lbf*s2/in", "lbf-s^2/in", "lbf s\u00b2/in", "lbf\u00b7s\u00b2/in"})
    EXPECT_EQ(find_units(std::string("in, ") + mass + ", s")->text(), "in, lbf s2/in, s") << mass;
}

TEST(Units, AreUnknownInOtherWordsAndInAnotherOrder) {
  for (const char* text : {"", "inch and pound", "m kg s", "m, kg", "kg, m, s", "mm, kg, ms, s", "furlong, kg, s",
                           "m,,s", "m, kg, s, C, K", ",,", "consistent", "lbf s\xc2"})
    EXPECT_FALSE(find_units(text)) << text;
}

TEST(Units, OfADeckThatAreNotKnownAreRefusedWithThoseThatAre) {
  try {
    parse_deck("units: inch and pound\ntime: {end: 1}\n", "deck.yaml");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("deck.yaml:1:8: error: units is 'inch and pound' (must be a length, a mass and a "
                          "time, such as 'm, kg, s', 'mm, t, s', 'mm, kg, ms', "));
    EXPECT_THAT(error.what(), HasSubstr("in ft; kg t"));
  }
}

TEST(UnitSuffix, IsEmptyWithoutUnits) {
  EXPECT_EQ(unit_suffix("", dimensions::mass), "");
  EXPECT_EQ(unit_suffix("mm, t, s", dimensions::energy), " mJ");
}

}  // namespace
}  // namespace percuss
