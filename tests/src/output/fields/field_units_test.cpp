// Units of fields from those of the deck.

#include "src/output/frame/field_units.hpp"

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
  for (const char* pure : {"equivalent_plastic_strain", "damage", "alive", "body", "temperature", "stresses", "xdmf"})
    EXPECT_EQ(name(pure), "") << pure;
}

TEST(FieldUnits, OfTemperatureAreNamedApart) {
  EXPECT_EQ(name_field_unit("temperature", "mm, kg, ms, K"), "K");
  EXPECT_EQ(name_field_unit("contact_force", "mm, kg, ms, K"), "kN");
}

TEST(FieldUnits, AreEmptyWhereTheDecksAreUnknown) {
  for (const char* units : {"", "inch and pound", "m, kg"}) EXPECT_EQ(name_field_unit("velocity", units), "") << units;
}

}  // namespace
}  // namespace percuss
