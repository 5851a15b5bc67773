// Hints: the distance against its definition, and words that people misspell.

#include "src/deck/text/nearest_name.hpp"

#include <gtest/gtest.h>

#include <string>

namespace percuss {
namespace {

TEST(EditDistance, CountsSingleChanges) {
  EXPECT_EQ(edit_distance("density", "density"), 0);
  EXPECT_EQ(edit_distance("density", "densty"), 1);    // deletion
  EXPECT_EQ(edit_distance("density", "densitty"), 1);  // insertion
  EXPECT_EQ(edit_distance("density", "dencity"), 1);   // replacement
  EXPECT_EQ(edit_distance("density", "denisty"), 1);   // swap
  EXPECT_EQ(edit_distance("Density", "dENSITY"), 0);   // letter case
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(EditDistance, IsSymmetric) {
  const char* words[] = {"velocity", "viscosity", "every", "end", "", "x_min"};
  for (const char* a : words) {
    for (const char* b : words) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
  }
}

TEST(NearestName, FindsTheWordThatWasMeant) {
  const std::vector<std::string> fields = {"displacement", "velocity", "stress", "pressure", "von_mises"};
  EXPECT_EQ(nearest_name("velocty", fields), "velocity");
  EXPECT_EQ(nearest_name("presure", fields), "pressure");
  EXPECT_EQ(nearest_name("vonmises", fields), "von_mises");
  EXPECT_EQ(nearest_name("disp", fields), "displacement");  // an abbreviation
  EXPECT_EQ(nearest_name("stresses", fields), "stress");
}

TEST(NearestName, DoesNotGuessWildly) {
  EXPECT_EQ(nearest_name("temperature", {"velocity", "stress"}), "");
  EXPECT_EQ(nearest_name("q", {"x", "y", "z"}), "");
  EXPECT_EQ(nearest_name("", {"x"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name(std::string(10'000, 'a'), {"aaa"}), "");
}

TEST(NameHint, ListsWhatIsKnownWhenNothingIsNear) {
  EXPECT_EQ(name_hint("stel", {"steel"}), " (did you mean 'steel'?)");
  EXPECT_EQ(name_hint("wood", {"steel", "brick"}), " (known: steel, brick)");
  EXPECT_EQ(name_hint("wood", {}), "");
}

}  // namespace
}  // namespace percuss
