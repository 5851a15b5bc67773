// Membranes as whole runs: a sphere that swings under pressure, Hencky's circular membrane, an arch of a strip, a strip
// that is let go, and free flight.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/mapped_shell.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::membrane_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Hencky's membrane (1915) by its own equation: with the radial force N = E t / 4 q^(2/3) B(r / a) and q = p a / E t,
/// B^2 (B'' + 3 B' / r) + 8 = 0, and B' + (1 - nu) B = 0 at the rim. B in the middle and the deflection there over
/// a q^(1/3), the integral of 2 r / B.
struct Hencky {
  double force, deflection;
};

Hencky integrate_hencky(double middle, double poisson, double& at_rim) {
  constexpr int steps = 2000;
  const double h = 1.0 / steps;
  // B = b0 - r^2 / b0^2 + ... begins the integration, whose equation divides by r.
  double r = h, b = middle - h * h / (middle * middle), slope = -2 * h / (middle * middle), deflection = h * h / middle;
  const auto second = [](double at, double value, double first) { return -8 / (value * value) - 3 * first / at; };
  for (int i = 1; i < steps; ++i) {
    const double k1 = second(r, b, slope), b2 = b + 0.5 * h * slope, s2 = slope + 0.5 * h * k1;
    const double k2 = second(r + 0.5 * h, b2, s2), b3 = b + 0.5 * h * s2, s3 = slope + 0.5 * h * k2;
    const double k3 = second(r + 0.5 * h, b3, s3), b4 = b + h * s3, s4 = slope + h * k3;
    const double k4 = second(r + h, b4, s4), next = b + h / 6 * (slope + 2 * s2 + 2 * s3 + s4);
    deflection += h * (r / b + (r + h) / next);
    b = next;
    slope += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    r += h;
  }
  at_rim = slope + (1 - poisson) * b;
  return {middle, deflection};
}

Hencky solve_hencky(double poisson) {
  double low = 1.2, high = 4, at_rim = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    integrate_hencky(middle, poisson, at_rim);
    (at_rim > 0 ? high : low) = middle;
  }
  return integrate_hencky(0.5 * (low + high), poisson, at_rim);
}

}  // namespace

TEST(Membrane, ASphereSwingsUnderPressureAsASpringAndAMass) {
  // u = p r^2 (1 - nu) / 2 E t (1 - cos w t), w^2 = 2 E / rho r^2 (1 - nu): twice the stress p r / 2 t after half a
  // swing.
  const double radius = 2, thickness = 0.01, young = 1e5, poisson = 0.3, density = 2, pressure = 0.5;
  const double frequency = std::sqrt(2 * young / (density * radius * radius * (1 - poisson)));
  const double at_rest = pressure * radius * radius * (1 - poisson) / (2 * young * thickness);
  for (const char* law : {"model: elastic", "model: j2_plasticity, yield_stress: 1e9"}) {
    const Outcome run =
        run_deck(fmt::format(R"yaml(
time: {{end: {}}}
parts: {{ball: {{shell_sphere: {{radius: {}, cells: 12}}, thickness: {}, material: skin, integration: membrane}}}}
materials: {{skin: {{{}, density: {}, youngs_modulus: {}, poissons_ratio: {}}}}}
loads: {{pressure: [{{faces: ball/inner, value: {}}}]}}
output: {{history: {{every: 0, elements: [{{name: e, near: [2, 0, 0]}}], nodes: [{{name: n, near: [2, 0, 0]}}]}}}}
audit: {{max_energy_error: 1e-3, max_momentum_error: 1e-9}}
)yaml",
                             pi / frequency, radius, thickness, law, density, young, poisson, pressure));
    const double stress = std::abs(run.history.last("e_stress_yy")), moved = run.history.last("n_x") - radius;
    fmt::print("sphere: stress {:.5f} of p r / t, displacement {:.5f}, energy {:.1e}\n",
               stress / (pressure * radius / thickness), moved / (2 * at_rest), run.summary.energy.error);
    EXPECT_NEAR(stress, pressure * radius / thickness, 0.01 * pressure * radius / thickness);
    EXPECT_NEAR(moved, 2 * at_rest, 0.01 * 2 * at_rest);
  }
}

TEST(Membrane, AFlatCircleBulgesAsHencky) {
  const double thickness = 1e-3, young = 1e6, pressure = 0.01;  // strains of 0.02 %, as Hencky takes them small
  const double q = pressure / (young * thickness);
  for (const bool is_fabric : {false, true}) {
    const double poisson = is_fabric ? 0.2 : 0.3;
    const Hencky exact = solve_hencky(poisson);
    const std::string law = is_fabric
                                ? fmt::format(
                                      "model: fabric, warp_modulus: {0}, weft_modulus: {0}, shear_modulus: {1}, "
                                      "warp_poissons_ratio: {2}, no_compression: true",
                                      young, young / (2 * (1 + poisson)), poisson)
                                : fmt::format("model: elastic, youngs_modulus: {}, poissons_ratio: {}", young, poisson);
    for (const int n : {4, 8}) {
      auto mesh = make_quarter_disc(n, [](double x, double y) { return Vec3{x, y, 0}; });
      const TemporaryFile file(testing_mesh::write_exodus(mesh, "hencky.exo"));
      const HistoryTable history = run_deck(fmt::format(R"yaml(
time: {{end: 1e-6}}
parts: {{disc: {{exodus: {{file: {}}}, thickness: {}, material: skin, integration: membrane}}}}
materials: {{skin: {{{}, density: 1}}}}
conditions: [{{nodes: disc/x_min, fixed: [x]}}, {{nodes: disc/y_min, fixed: [y]}}, {{nodes: disc/rim, fixed: [x, y, z]}}]
loads: {{pressure: [{{faces: disc/bottom, value: {}}}]}}
start: {{relaxation: {{}}}}
output: {{history: {{every: 0, nodes: [{{name: n, near: [0, 0, 0]}}], elements: [{{name: e, near: [0, 0, 0]}}]}}}}
)yaml",
                                                        file.path(), thickness, law, pressure))
                                       .history;
      const double deflection = std::abs(history["n_z"][0]) / std::cbrt(q) / exact.deflection;
      const double stress = history["e_stress_xx"][0] / (young / 4 * std::cbrt(q * q)) / exact.force;
      fmt::print(
          "Hencky, nu {}, {} cells: b0 {:.5f}, w0 {:.5f}; deflection {:.5f}, stress in the middle {:.5f} of it\n",
          poisson, n, exact.force, exact.deflection, deflection, stress);
      EXPECT_NEAR(deflection, 1, 5e-3) << n;
      EXPECT_NEAR(stress, 1, n == 4 ? 7e-3 : 5e-3) << n;  // falls with the square of the elements: 0.6 and 0.14 %
    }
  }
}

TEST(Membrane, HenckysCoefficientsAreThePublishedOnes) {
  // Hencky (1915), Fichter (1997): b0 = 1.7244 for nu = 0.3; the deflection 0.6532 (Timoshenko: 0.653 of the same
  // form).
  const Hencky exact = solve_hencky(0.3);
  EXPECT_NEAR(exact.force, 1.7244, 1e-3);
  EXPECT_NEAR(exact.deflection, 0.6532, 2e-3);
}

TEST(Membrane, AStripUnderPressureIsAnArcOfACircle) {
  // Width constant and nu = 0: N = p R, an arc 2 R a = l exp(N / E t) over the chord l = 2 R sin(a), by the logarithmic
  // strain of elastic.
  const double length = 1, thickness = 1e-3, young = 1e6, pressure = 20;
  double low = 0.5 * length * (1 + 1e-9), high = 1e3;
  const auto excess = [&](double radius) {
    return 2 * radius * std::asin(0.5 * length / radius) - length * std::exp(pressure * radius / (young * thickness));
  };
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0 ? low : high) = middle;
  }
  const double radius = 0.5 * (low + high), rise = radius * (1 - std::cos(std::asin(0.5 * length / radius)));
  const HistoryTable history = run_deck(fmt::format(R"yaml(
time: {{end: 1e-6}}
parts: {{strip: {{shell_plate: {{size: [1, 0.05], cells: [20, 1]}}, thickness: {}, material: skin, integration: membrane}}}}
materials: {{skin: {{model: elastic, density: 1, youngs_modulus: {}, poissons_ratio: 0}}}}
conditions: [{{nodes: strip, fixed: [y]}}, {{nodes: strip/x_min, fixed: [x, z]}}, {{nodes: strip/x_max, fixed: [x, z]}}]
loads: {{pressure: [{{faces: strip/bottom, value: {}}}]}}
start: {{relaxation: {{}}}}
output: {{history: {{every: 0, nodes: [{{name: n, near: [0.5, 0, 0]}}], elements: [{{name: e, near: [0.5, 0, 0]}}]}}}}
)yaml",
                                                    thickness, young, pressure))
                                   .history;
  const double moved = std::abs(history["n_z"][0]), stress = history["e_stress_xx"][0];
  fmt::print("arc: rise {:.5f} of {:.5f}, stress {:.5f} of p R / t\n", moved / rise, rise,
             stress / (pressure * radius / thickness));
  EXPECT_NEAR(moved, rise, 2e-3 * rise);
  EXPECT_NEAR(stress, pressure * radius / thickness, 2e-3 * stress);
}

TEST(Membrane, AStripThatIsPulledAndLetGoGivesBackItsEnergy) {
  // One element, nu = 0: u = u0 cos w t with w^2 = E t w / l over half the mass of its end, until it is as long as
  // before.
  const double young = 100, speed = 1e-3;
  const double frequency = std::sqrt(2 * young);  // density 1, a cube of 1
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {}, step_scale: 0.1}}
parts: {{strip: {{shell_plate: {{size: [1, 1], cells: [1, 1]}}, thickness: 1, material: skin, integration: membrane}}}}
materials: {{skin: {{model: elastic, density: 1, youngs_modulus: {}, poissons_ratio: 0}}}}
initial: [{{nodes: strip/x_max, velocity: [{}, 0, 0]}}]
conditions: [{{nodes: strip/x_min, fixed: [x, y, z]}}, {{nodes: strip, fixed: [y, z]}}]
output: {{history: {{every: 0, nodes: [{{name: n, near: [1, 0, 0]}}]}}}}
audit: {{max_energy_error: 1e-3}}
)yaml",
                                           2.1 * pi / frequency, young, speed));
  EXPECT_NEAR(run.history.largest("n_x") - 1, speed / frequency, 2e-3 * speed / frequency);
  EXPECT_NEAR(run.history.time_of_rise("n_x", 1 + 1e-9), 0, 1e-3);
  EXPECT_NEAR(run.history.at(2 * pi / frequency, "n_x") - 1, 0, 0.01 * speed / frequency);
  EXPECT_NEAR(run.history.at(2 * pi / frequency, "internal"), 0, 0.01 * run.history.largest("internal"));
}

TEST(Membrane, AWarpedSheetInFlightKeepsItsMomentumAndEnergy) {
  auto mesh = make_mapped_shell({6, 6}, [](double u, double v) {
    return Vec3{u - 0.5, v - 0.5, 0.3 * (u - 0.5) * (v - 0.5) + 0.05 * std::sin(5 * u)};
  });
  halve(6, Halving::every_other, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "flying_sheet.exo"));
  const double w = 200;
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {}}}
parts: {{sheet: {{exodus: {{file: {}}}, thickness: 0.001, material: film, integration: membrane}}}}
materials: {{film: {{model: elastic, density: 1000, youngs_modulus: 3e9, poissons_ratio: 0.4}}}}
initial: [{{part: sheet, angular_velocity: [{}, 30, {}]}}]
output: {{history: {{every: 1e-3}}}}
audit: {{max_energy_error: 1e-2, max_momentum_error: 1e-10}}
)yaml",
                                           10 * 2 * pi / w, file.path(), 0.1 * w, w));
  fmt::print("flight: angular momentum {:.1e}, energy {:.1e}\n", run.summary.momentum.angular_error,
             run.summary.energy.error);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-11);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

}  // namespace percuss::test::membrane_test
