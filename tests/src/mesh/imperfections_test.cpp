// Imperfections against the displacements that they are to be, and noise against what it promises.

#include "src/mesh/imperfections.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

Mesh build(const std::string& part, const std::string& imperfections) {
  return build_mesh(parse_deck(fmt::format("time: {{end: 1}}\nparts: {{body: {{{}, material: steel}}}}\n"
                                           "materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: "
                                           "200e9, poissons_ratio: 0.3}}}}\n{}",
                                           part, imperfections.empty() ? "" : "imperfections: [" + imperfections + "]"),
                               "deck.yaml"));
}

const std::string block = "box: {size: [2, 1, 1], cells: [4, 2, 2]}",
                  tube = "shell_tube: {radius: 2, length: 3, cells: [24, 6]}, thickness: 0.1";

std::string take_refusal(const std::string& part, const std::string& imperfections) {
  try {
    build(part, imperfections);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

}  // namespace

TEST(Imperfections, AModeMovesNodesAlongItsDirection) {
  const Mesh before = build(block, "");
  const Mesh after = build(block, "{nodes: body, mode: \"0.01 * sin(pi * x) + 0.001 * y * z\", direction: [0, 3, 4]}");
  for (std::size_t n = 0; n < before.nodes.size(); ++n) {
    const Vec3& x = before.nodes[n];
    const double d = 0.01 * std::sin(std::acos(-1.0) * x[0]) + 0.001 * x[1] * x[2];
    EXPECT_EQ(after.nodes[n][0], x[0]);
    EXPECT_NEAR(after.nodes[n][1], x[1] + 0.6 * d, 1e-16);
    EXPECT_NEAR(after.nodes[n][2], x[2] + 0.8 * d, 1e-16);
  }
  ASSERT_EQ(after.notes.size(), 1U);
  EXPECT_EQ(after.notes[0], "imperfection of 'body': largest displacement 0.011, of 45 nodes");
}

TEST(Imperfections, OfShellsAreAlongTheirNormals) {
  const Mesh before = build(tube, "");
  const Mesh after = build(tube, "{nodes: body, mode: 0.02 * z}");
  for (std::size_t n = 0; n < before.nodes.size(); ++n) {
    const Vec3 &x = before.nodes[n], &y = after.nodes[n];
    EXPECT_NEAR(std::hypot(y[0], y[1]), 2 + 0.02 * x[2], 1e-11);  // normals are integers of 2^-40
    EXPECT_NEAR(y[0] * x[1] - y[1] * x[0], 0, 1e-11);
    EXPECT_NEAR(y[2], x[2], 1e-11);
  }
}

TEST(Imperfections, EachSeesThePlacesWithoutTheOthers) {
  const Mesh before = build(block, "");
  const Mesh after = build(block,
                           "{nodes: body, mode: \"0.1\", direction: x}, {nodes: body/x_max, mode: \"0.01 * x\", "
                           "direction: -x}");
  for (std::size_t n = 0; n < before.nodes.size(); ++n) {
    const double x = before.nodes[n][0];
    EXPECT_NEAR(after.nodes[n][0], x + 0.1 - (x == 2 ? 0.02 : 0), 1e-15);
  }
}

TEST(Imperfections, NoiseStaysWithinItsAmplitudeAndFollowsItsSeed) {
  const Mesh before = build(block, "");
  const auto shift = [&](const std::string& noise) {
    const Mesh after = build(block, "{nodes: body, noise: {amplitude: 0.01" + noise + "}, direction: z}");
    std::vector<double> shifts;
    for (std::size_t n = 0; n < before.nodes.size(); ++n) shifts.push_back(after.nodes[n][2] - before.nodes[n][2]);
    return shifts;
  };
  for (const char* length : {"", ", length: 0.4"}) {
    const std::vector<double> one = shift(length), same = shift(length),
                              other = shift(fmt::format("{}, seed: 2", length));
    EXPECT_EQ(one, same);
    EXPECT_NE(one, other);
    double largest = 0;
    for (const double d : one) largest = std::max(largest, std::abs(d));
    EXPECT_LE(largest, 0.01 * (1 + 1e-12));
    EXPECT_GT(largest, 0.004);
  }
}

TEST(Imperfections, NoiseOfPlacesIsSmoothOverItsLength) {
  constexpr double length = 0.5, h = 1e-4;
  double steepest = 0, mean = 0;
  int count = 0;
  for (double x = -3; x < 3; x += 0.0317) {
    const Vec3 a{x, 0.3 * x, 1 - x}, b{x + h, 0.3 * x, 1 - x};
    const double value = find_noise(a, length, 7);
    EXPECT_LE(std::abs(value), 1);
    steepest = std::max(steepest, std::abs(find_noise(b, length, 7) - value) / h);
    mean += value;
    ++count;
  }
  EXPECT_LE(steepest, 2 * 1.875 / length);  // between values of -1 and 1, the steepest of the smooth step
  EXPECT_GT(steepest, 0.2 / length);
  EXPECT_LT(std::abs(mean / count), 0.2);
}

TEST(Imperfections, NoiseOfIdsIsUniform) {
  double sum = 0, square = 0, product = 0, last = 0;
  constexpr int count = 100000;
  for (int id = 1; id <= count; ++id) {
    const double value = find_noise(id, 3);
    EXPECT_LE(std::abs(value), 1);
    sum += value;
    square += value * value;
    product += value * last;
    last = value;
  }
  EXPECT_NEAR(sum / count, 0, 0.01);            // 5 of its standard deviations, sqrt(1 / 3 / count)
  EXPECT_NEAR(square / count, 1.0 / 3, 0.005);  // likewise
  EXPECT_NEAR(product / count, 0, 0.006);
}

TEST(Imperfections, WithoutADirectionOrAValueAreRefusedWithTheirPlace) {
  EXPECT_THAT(take_refusal(block, "{nodes: body, mode: \"0.01\"}"),
              testing::AllOf(testing::HasSubstr("deck.yaml:4:"), testing::HasSubstr("give a direction")));
  EXPECT_THAT(take_refusal(block, "{nodes: body, mode: \"1 / x\", direction: x}"), testing::HasSubstr("not finite"));
  EXPECT_THAT(take_refusal(block, "{nodes: body/x_max, mode: \"0.6\", direction: -x}"),
              testing::HasSubstr("without volume"));
  EXPECT_THAT(take_refusal(block, "{nodes: body/lid, mode: \"1\", direction: x}"), testing::HasSubstr("no side 'lid'"));
}

}  // namespace percuss
