// Curves against values known in closed form; texts that are no expression of t.

#include "src/deck/functions/curve.hpp"
#include "tests/expect_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <vector>

namespace percuss {
namespace {

TEST(Curve, IsZeroByDefault) {
  EXPECT_EQ(Curve()(3.0), 0.0);
  EXPECT_TRUE(Curve().is_constant());
}

TEST(Curve, KeepsAConstant) {
  EXPECT_EQ(Curve::constant(4.5)(1e9), 4.5);
  EXPECT_TRUE(Curve::constant(4.5).is_constant());
}

TEST(Curve, InterpolatesATableAndHoldsItsEnds) {
  const Curve curve = Curve::table({{1, 10}, {2, 20}, {4, 0}});
  EXPECT_EQ(curve(0.0), 10);
  EXPECT_EQ(curve(1.0), 10);
  EXPECT_EQ(curve(1.5), 15);
  EXPECT_EQ(curve(2.0), 20);
  EXPECT_EQ(curve(3.0), 10);
  EXPECT_EQ(curve(4.0), 0);
  EXPECT_EQ(curve(9.0), 0);
  EXPECT_FALSE(curve.is_constant());
}

TEST(Curve, KnowsATableOfEqualValuesForAConstant) {
  EXPECT_TRUE(Curve::table({{0, 2}, {1, 2}}).is_constant());
  EXPECT_EQ(Curve::table({{0, 2}})(7.0), 2);
}

TEST(Curve, RefusesTablesThatAreNoFunction) {
  EXPECT_ERROR(Curve::table({}), std::invalid_argument, "the table is empty");
  EXPECT_ERROR(Curve::table({{1, 0}, {1, 1}}), std::invalid_argument, "must ascend; 1 follows 1");
  EXPECT_ERROR(Curve::table({{2, 0}, {1, 1}}), std::invalid_argument, "must ascend; 1 follows 2");
  EXPECT_ERROR(Curve::table({{0, std::numeric_limits<double>::quiet_NaN()}}), std::invalid_argument,
               "row 1 of the table is not finite");
  EXPECT_ERROR(Curve::table({{0, 0}, {std::numeric_limits<double>::infinity(), 1}}), std::invalid_argument,
               "row 2 of the table is not finite");
}

struct Expression {
  const char* text;
  double expected;  // at t = 0.3
};

TEST(Curve, EvaluatesExpressions) {
  const double t = 0.3;
  const Expression expressions[] = {
      {"2 * t + 1", 2 * t + 1},
      {"sin(2*pi*t)", std::sin(2 * std::numbers::pi * t)},
      {"e^t", std::pow(std::numbers::e, t)},
      {"-t^2", -(t * t)},
      {"t < 0.5 ? 1 : 2", 1},
      {"(t > 0.5) || (t == 0.3)", 1},
      {"max(t, 1e-1) - min(t, .5)", 0},
      {"atan2(t, -1)", std::atan2(t, -1.0)},
      {"log(exp(t))", std::log(std::exp(t))},
      {"log10(1e3)", std::log10(1e3)},
      {"step(t - 0.3) + step(t - 0.31)", 1},
      {"sign(t) + sign(-t) + sign(0)", 0},
      {"floor(t) + ceil(t)", 1},
      {"sqrt(abs(-4))", 2},
      {"1.5e-1 * 2", 0.3},
  };
  for (const Expression& expression : expressions) {
    // Two roundings of the last place: the parser may fold constants in another order.
    EXPECT_NEAR(Curve::expression(expression.text)(t), expression.expected, 4e-16 * (1 + std::abs(expression.expected)))
        << expression.text;
  }
}

TEST(Curve, KnowsWhetherAnExpressionDependsOnTime) {
  EXPECT_TRUE(Curve::expression("2 * pi").is_constant());
  EXPECT_FALSE(Curve::expression("t").is_constant());
}

TEST(Curve, RefusesWhatIsNoExpressionOfTime) {
  const std::pair<const char*, const char*> texts[] = {{"", "empty"},
                                                       {"  ", "empty"},
                                                       {"2 *", "Unexpected end"},
                                                       {"(t", "Missing parenthesis"},
                                                       {"t)", "Unexpected parenthesis"},
                                                       {"sine(t)", "token \"sine\""},
                                                       {"x", "token \"x\""},
                                                       {"t = 3", "assigns"},
                                                       {"t += 1", "assigns"},
                                                       {"a = t", "assigns"},
                                                       {"\"t\"", "unexpected character"},
                                                       {"sin", "token \"sin\""},
                                                       {"sin()", "Too few parameters"},
                                                       {"sin(t, t)", "Too many parameters"},
                                                       {"t, 2", "one value"},
                                                       {"1 2", "Unexpected value"},
                                                       {"t;t", "unexpected character"},
                                                       {"`id`", "unexpected character"},
                                                       {"t $ 2", "unexpected character"},
                                                       {"rnd()", "token \"rnd\""},
                                                       {"0x10", "token \"x10\""},
                                                       {"2,5", "one value"},
                                                       {"{t}", "unexpected character"}};
  for (const auto& [text, reason] : texts) EXPECT_ERROR(Curve::expression(text), std::invalid_argument, reason) << text;
  EXPECT_ERROR(Curve::expression(std::string(100'000, '(')), std::invalid_argument, "more than 2000 characters");
  EXPECT_ERROR(Curve::expression(std::string(1'900, '(')), std::invalid_argument, "Unexpected end");
}

TEST(Curve, DoesNotDependOnTheLocale) {
  const char* before = std::setlocale(LC_ALL, nullptr);
  const std::string saved = before == nullptr ? "C" : before;
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) == nullptr) continue;  // not installed here
    EXPECT_EQ(Curve::expression("1.5 * 2")(0.0), 3.0) << name;
  }
  std::setlocale(LC_ALL, saved.c_str());
}

TEST(Curve, MayBeAskedByManyThreads) {
  const Curve curve = Curve::expression("t * t");
  std::vector<int> wrong(4);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    threads.emplace_back([&, k] {
      for (int i = 0; i < 2000; ++i) wrong[k] += curve(i) == static_cast<double>(i) * i ? 0 : 1;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(wrong, testing::Each(0));
}

}  // namespace
}  // namespace percuss
