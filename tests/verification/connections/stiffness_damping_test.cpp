// Damping in proportion to stiffness: free vibrations decay by the ratio xi = beta omega / 2, rigid motion does not.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::stiffness_damping_test {
namespace {

/// Damping ratio and circular frequency of a vibration about `rest` from its turning points after a time.
struct Vibration {
  double ratio = 0, frequency = 0;
};

Vibration measure(const HistoryTable& history, const std::string& column, double rest, double after) {
  const std::vector<double>&u = history[column], &t = history["time"];
  std::vector<double> size, time;
  for (std::size_t i = 1; i + 1 < u.size(); ++i) {
    if (t[i] < after || (u[i] - u[i - 1]) * (u[i + 1] - u[i]) > 0) continue;
    const double a = u[i - 1] - rest, b = u[i] - rest, c = u[i + 1] - rest, bend = a - 2 * b + c;
    const double shift = 0.5 * (a - c) / bend;  // of the parabola through three rows
    size.push_back(std::abs(b - 0.25 * (a - c) * shift));
    time.push_back(t[i] + shift * (t[i] - t[i - 1]));
  }
  const double halves = static_cast<double>(size.size() - 1);
  const double decrement = std::log(size.front() / size.back()) / halves;  // of half a period
  const double damped = halves * std::numbers::pi / (time.back() - time.front());
  const double ratio = decrement / std::hypot(decrement, std::numbers::pi);
  return {ratio, damped / std::sqrt(1 - ratio * ratio)};
}

constexpr double young = 200e9, density = 8000;
const double speed = std::sqrt(young / density);

/// A bar or strip along x that is held at x = 0 and starts with a velocity along `axis`.
std::string make_bar(const std::string& shape, const char* held, const char* velocity, double beta, double end) {
  return fmt::format(R"yaml(
time: {{end: {}}}
parts: {{bar: {{{}, material: steel, stiffness_damping: {}}}}}
materials: {{steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
conditions: [{{nodes: bar/{}, fixed: {}}}]
initial: [{{part: bar, velocity: {}}}]
output: {{history: {{every: 0, nodes: [{{name: end, near: [0.2, 0, 0]}}]}}}}
)yaml",
                     end, shape, beta, shape.find("line") == std::string::npos ? "x_min" : "start", held, velocity);
}

}  // namespace

// The slowest mode of a bar that is held at one end, omega = pi c / 2 L, is left after the others have decayed. Of 20
// elements its frequency is smaller by (pi / 40)^2 / 24.
TEST(StiffnessDamping, OfABarIsThatOfItsFrequency) {
  const double frequency = std::numbers::pi * speed / (2 * 0.2), beta = 2 * 0.05 / frequency;
  for (const char* shape : {"box: {size: [0.2, 0.01, 0.01], cells: [20, 1, 1]}",
                            "box: {size: [0.2, 0.01, 0.01], cells: [20, 1, 1]}, integration: full",
                            "shell_plate: {size: [0.2, 0.01], cells: [20, 1]}, thickness: 0.01",
                            "line: {from: [0, 0, 0], to: [0.2, 0, 0], cells: 20}, section: {truss: {area: 1e-4}}",
                            "line: {from: [0, 0, 0], to: [0.2, 0, 0], cells: 20}, section: {round: {radius: 0.005}}"}) {
    const Outcome run = run_deck(make_bar(shape, "[x, y, z]", "[0.01, 0, 0]", beta, 1.5e-3));
    const Vibration found = measure(run.history, "end_x", 0.2, 5e-4);
    EXPECT_NEAR(found.frequency, frequency, 2e-3 * frequency) << shape;
    EXPECT_NEAR(found.ratio, 0.05, 0.01 * 0.05) << shape;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-4) << shape;
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12) << shape;
    EXPECT_GT(run.history.last("viscous"), 0.5 * run.summary.energy.initial) << shape;
  }
}

// A cantilever that bends in its first mode, a strip and a beam. Near omega = 1.8751^2 sqrt(E t^2 / (12 rho)) / L^2,
// less what shear and eight elements take of it: the ratio is that of the frequency that it has.
TEST(StiffnessDamping, OfAStripThatBendsIsThatOfItsFrequency) {
  const double slender = std::pow(1.8751 / 0.2, 2) * 0.04 * std::sqrt(young / density / 12), beta = 2 * 0.01 / slender;
  for (const char* shape : {"shell_plate: {size: [0.2, 0.025], cells: [8, 1]}, thickness: 0.04",
                            "line: {from: [0, 0, 0], to: [0.2, 0, 0], cells: 8}, section: {rectangle: {size: [0.025, "
                            "0.04]}}, toward: y"}) {
    const Outcome run = run_deck(make_bar(shape, "[x, y, z, rx, ry, rz]", "[0, 0, 0.01]", beta, 1.5e-2));
    const Vibration found = measure(run.history, "end_z", 0, 5e-3);
    EXPECT_NEAR(found.frequency, slender, 0.05 * slender) << shape;
    EXPECT_NEAR(found.ratio, 0.5 * beta * found.frequency, 0.01 * found.ratio) << shape;
  }
}

// A free body keeps its momenta and, apart from round-off and what its spin strains, its energy.
TEST(StiffnessDamping, LeavesRigidMotion) {
  for (const char* shape : {"box: {size: [0.03, 0.02, 0.01], cells: [3, 2, 1]}",
                            "box: {size: [0.03, 0.02, 0.01], cells: [3, 2, 1]}, integration: full",
                            "shell_plate: {size: [0.03, 0.02], cells: [3, 2]}, thickness: 0.01",
                            "line: {from: [0, 0, 0], to: [0.03, 0, 0], cells: 3}, section: {round: {radius: 0.005}}"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 2e-4}}
parts: {{body: {{{}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
elements: {{stiffness_damping: 1e-6}}
initial: [{{part: body, velocity: [30, 10, 20], angular_velocity: [100, 200, 300]}}]
output: {{history: {{every: 0}}}}
)yaml",
                                             shape));
    EXPECT_LT(run.summary.momentum.linear_error, 1e-13) << shape;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12) << shape;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-7) << shape;
    EXPECT_LT(std::abs(run.history.last("viscous")), 1e-4 * run.summary.energy.initial) << shape;
  }
}

// The step of undamped elements, h = 2 / omega, becomes h (sqrt(1 + xi^2) - xi), xi = beta omega / 2.
TEST(StiffnessDamping, ShortensTheStep) {
  const auto find_step = [](double beta) {
    return run_deck(
               make_bar("box: {size: [0.2, 0.01, 0.01], cells: [20, 1, 1]}", "[x, y, z]", "[0.01, 0, 0]", beta, 1e-3))
        .summary.dt.max;
  };
  const double whole = find_step(0) / 0.9, beta = 0.7 * whole, xi = beta / whole;
  EXPECT_NEAR(find_step(beta) / 0.9, whole * (std::sqrt(1 + xi * xi) - xi), 1e-4 * whole);
}

TEST(StiffnessDamping, IsRefusedWhereItCannotBe) {
  const auto refuse = [](const std::string& shape, const std::string& material,
                         const std::string& time) -> std::string {
    try {
      run_deck(
          fmt::format("time: {{end: 1e-6{}}}\nparts: {{bar: {{{}, material: m}}}}\nmaterials: {{m: {{{}}}}}\n"
                      "elements: {{stiffness_damping: 1e-6}}\n",
                      time, shape, material));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  };
  const std::string box = "box: {size: [1, 1, 1], cells: [1, 1, 1]}";
  const std::string elastic = "model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3";
  EXPECT_NE(refuse(box + ", elements: tetrahedra", elastic, "").find("acts on hexahedra, shells and beams"),
            std::string::npos);
  EXPECT_NE(refuse(box, "model: neo_hookean, density: 1000, youngs_modulus: 1e6, poissons_ratio: 0.45", "")
                .find("elastic constants that do not change"),
            std::string::npos);
  EXPECT_NE(refuse(box, elastic, ", step_estimate: global").find("does not know it"), std::string::npos);
  EXPECT_EQ(refuse(box, elastic, ""), "no refusal");
}

}  // namespace percuss::test::stiffness_damping_test
