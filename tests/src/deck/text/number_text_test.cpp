// Texts that are numbers, to the last bit.

#include "src/deck/text/number_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace percuss {
namespace {

double number(const std::string& text) { return std::get<double>(read_number(text)); }
bool is_number(const std::string& text) { return std::holds_alternative<double>(read_number(text)); }

TEST(NumberText, ReadsWhatYamlCallsANumber) {
  EXPECT_EQ(number("0"), 0);
  EXPECT_EQ(number("-0.5"), -0.5);
  EXPECT_EQ(number("+3"), 3);
  EXPECT_EQ(number("200e9"), 200e9);
  EXPECT_EQ(number("1e-3"), 1e-3);
  EXPECT_EQ(number("2.5E+6"), 2.5e6);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("5."), 5);
  EXPECT_EQ(number("0.1"), 0.1);
  EXPECT_EQ(number("0e5"), 0);
  EXPECT_EQ(number("9007199254740993"), 9007199254740992.0);  // the nearest double
}

TEST(NumberText, RefusesEverythingElse) {
  for (const char* text : {"",     "-",     "+",    ".",   "e5",   "1e",   "1e+",      "--1",   "+-1",    "1.2.3",
                           "1,5",  "0x10",  "0o17", "0b1", "010",  "-01",  "00",       "1_000", "1 000",  "1d3",
                           ".inf", "-.inf", "inf",  "nan", ".NaN", "NAN",  "infinity", "1e999", "-1e999", "1e-999",
                           "5mm",  "5 mm",  "true", "~",   "1f",   "1.0f", " 1",       "1 ",    "１"}) {
    EXPECT_FALSE(is_number(text)) << "'" << text << "'";
  }
}

TEST(NumberText, NeverCutsAnInteger) {
  EXPECT_EQ(std::get<long long>(read_integer("8")), 8);
  EXPECT_EQ(std::get<long long>(read_integer("-3")), -3);
  EXPECT_EQ(std::get<long long>(read_integer("+3")), 3);
  EXPECT_EQ(std::get<long long>(read_integer("9223372036854775807")), 9223372036854775807LL);
  for (const char* text : {"", "8.0", "8.", "8e0", "1e3", "08", "9223372036854775808", "0x8", "8 ", "eight", "true"}) {
    EXPECT_TRUE(std::holds_alternative<NumberProblem>(read_integer(text))) << "'" << text << "'";
  }
}

TEST(NumberText, SaysHowToWriteItRight) {
  const auto advice = [](const char* text) { return std::get<NumberProblem>(read_number(text)).must_be; };
  EXPECT_THAT(advice("1,5"), testing::HasSubstr("1.5"));
  EXPECT_THAT(advice("1_000"), testing::HasSubstr("1000"));
  EXPECT_THAT(advice("1d-3"), testing::HasSubstr("1e-3"));
  EXPECT_THAT(advice("3.5mm"), testing::HasSubstr("without a unit or other text, in the units of the deck"));
  EXPECT_EQ(advice("-.inf"), "finite");
  EXPECT_EQ(advice("steel"), "a number");
}

TEST(NumberText, KnowsTheBooleansOfYamlOnly) {
  for (const char* text : {"true", "True", "TRUE", "false", "False", "FALSE"}) EXPECT_TRUE(is_boolean(text)) << text;
  for (const char* text : {"yes", "no", "on", "off", "y", "n", "1", "0", "tRUE", ""})
    EXPECT_FALSE(is_boolean(text)) << text;
}

}  // namespace
}  // namespace percuss
