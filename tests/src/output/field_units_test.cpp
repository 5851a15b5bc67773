// Units of fields from those of the deck.

#include "src/output/field_units.hpp"

#include <gtest/gtest.h>

namespace percuss {
namespace {

TEST(FieldUnits, AreDerivedFromTheDecksThreeUnits) {
  const auto name = [](const char* field) { return name_field_unit(field, "m, kg, s"); };
  EXPECT_EQ(name("displacement"), "m");
  EXPECT_EQ(name("thickness"), "m");
  EXPECT_EQ(name("velocity"), "m/s");
  EXPECT_EQ(name("mass"), "kg");
  EXPECT_EQ(name("contact_force"), "N");
  for (const char* stress : {"stress", "stress_bottom", "stress_point_3", "pressure", "von_mises", "internal_energy"})
    EXPECT_EQ(name(stress), "Pa") << stress;
  for (const char* pure : {"equivalent_plastic_strain", "damage", "alive", "body", "temperature"})
    EXPECT_EQ(name(pure), "") << pure;
}

TEST(FieldUnits, OfStressAndForceAreTheNamedOnesOfTheSystem) {
  EXPECT_EQ(name_field_unit("pressure", "mm, kg, ms"), "GPa");  // 1 kg / (1e-3 m 1e-6 s^2)
  EXPECT_EQ(name_field_unit("contact_force", "mm, kg, ms"), "kN");
  EXPECT_EQ(name_field_unit("pressure", "cm, g, us"), "Mbar");  // 1e-3 kg / (1e-2 m 1e-12 s^2) = 1e11 Pa
  EXPECT_EQ(name_field_unit("time", "mm, kg, ms"), "ms");
  EXPECT_EQ(name_field_unit("temperature", "m, kg, s, K"), "K");
}

TEST(FieldUnits, AreEmptyWhereTheDecksAreUnknown) {
  for (const char* units : {"", "inch and pound", "m, kg", "furlong, stone, s"})
    EXPECT_EQ(name_field_unit("velocity", units), "") << units;
}

}  // namespace
}  // namespace percuss
