// Mass scaling of solids of every law and kind: stresses follow from the motion alone, and motions are those of a
// denser material.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

/// constants: HEAT and SPEED stand for what goes with the density in a material that is s times as dense.
struct SampleLaw {
  std::string name, constants;
  double density, heat = 0, speed = 0;
  bool has_twin = true;
};

const std::string of_steel = ", youngs_modulus: 200e9, poissons_ratio: 0.3";
const std::string crush = "[[0, 2e6], [0.3, 2e6], [0.6, 6e6]]";

const std::vector<SampleLaw> sample_laws = {
    {"elastic", "model: elastic" + of_steel, 7850},
    {"j2", "model: j2_plasticity, yield_stress: 3e8, hardening_modulus: 1e9" + of_steel, 7850},
    {"power",
     "model: power_law_plasticity, yield_stress: 3e8, hardening_coefficient: 5e8, hardening_exponent: 0.4" + of_steel,
     7850},
    {"voce", "model: voce_plasticity, yield_stress: 3e8, saturation_stress: 2e8, saturation_rate: 20" + of_steel, 7850},
    {"table", "model: tabulated_plasticity, hardening: [[0, 3e8], [0.1, 4e8]]" + of_steel, 7850},
    {"rates",
     "model: rate_table_plasticity, hardening_at_rates: [[0, [[0, 3e8], [0.1, 4e8]]], [1e4, [[0, 4e8], [0.1, 6e8]]]]" +
         of_steel,
     7850},
    {"combined",
     "model: combined_hardening, yield_stress: 3e8, hardening_modulus: 1e9, kinematic_share: 0.5" + of_steel, 7850},
    {"chaboche",
     "model: chaboche, yield_stress: 2e8, back_stresses: [[50, 4e9], [400, 4e10]], cyclic_stress: 5e7, cyclic_rate: "
     "20" +
         of_steel,
     7850},
    {"gurson",
     "model: gurson, hardening: [[0, 3e8], [0.1, 4e8]], void_fraction: 0.02, nucleation_fraction: 0.04, "
     "nucleation_strain: 0.02, nucleation_deviation: 0.01" +
         of_steel,
     7850},
    {"johnson_cook",
     "model: johnson_cook, a: 3e8, b: 4e8, n: 0.3, c: 0.02, melt_temperature: 1800, specific_heat: HEAT" + of_steel,
     7850, 450},
    {"neo_hookean", "model: neo_hookean, youngs_modulus: 5e7, poissons_ratio: 0.45", 1100},
    {"yeoh", "model: yeoh, c10: 4e5, c20: -2e4, c30: 1e4, bulk_modulus: 5e7", 1100},
    {"arruda", "model: arruda_boyce, mu: 8e5, locking_stretch: 3, bulk_modulus: 5e7", 1100},
    {"mooney", "model: mooney_rivlin, c10: 4e5, c01: 1e5, bulk_modulus: 5e7", 1100},
    {"ogden", "model: ogden, terms: [[-2, -2e5], [3, 4e5]], bulk_modulus: 5e7", 1100},
    {"curve", "model: tabulated_rubber, uniaxial: [[-0.5, -2e6], [0, 0], [1, 2e6]], bulk_modulus: 5e7", 1100},
    {"hyperfoam", "model: hyperfoam, terms: [[-1.5, -5e4], [6, 6e4]], poissons_ratio: 0.2", 60},
    {"viscoelastic", "model: viscoelastic, bulk_modulus: 1e9, long_term_shear_modulus: 1e6, relaxation: [[1e-4, 5e7]]",
     1100},
    {"soil",
     "model: soil_and_foam, shear_modulus: 5e7, unloading_bulk_modulus: 5e8, compaction: [[0, 0], [0.1, 5e6], [0.3, "
     "8e7]], a0: 1e12",
     1800},
    {"foam", "model: low_density_foam, youngs_modulus: 5e6, compression: [[0, 0], [0.1, 2e5], [0.6, 4e5]]", 60},
    {"foam at rates",
     "model: rate_table_foam, youngs_modulus: 5e6, compression_at_rates: [[1, [[0, 0], [0.1, 2e5], [0.6, 4e5]]], [1e4, "
     "[[0, 0], [0.1, 3e5], [0.6, 6e5]]]]",
     60},
    {"honeycomb",
     fmt::format(
         "model: honeycomb, youngs_modulus: 7e10, poissons_ratio: 0.3, yield_stress: 1e8, compacted_volume: 0.1, "
         "crush_moduli: [5e8, 5e8, 5e8], shear_moduli: [2e8, 2e8, 2e8], crush_xx: {0}, crush_yy: {0}, crush_zz: "
         "{0}, crush_xy: {0}, crush_yz: {0}, crush_zx: {0}",
         crush),
     100},
    {"grueneisen",
     "model: johnson_cook, a: 9e7, b: 3e8, n: 0.3, melt_temperature: 1356, specific_heat: HEAT, youngs_modulus: 124e9, "
     "poissons_ratio: 0.34, equation_of_state: {kind: mie_grueneisen, sound_speed: SPEED, slope: 1.5, grueneisen: 2}",
     8930, 383, 3940},
    {"water", "model: fluid, equation_of_state: {kind: linear, bulk_modulus: 2.2e9}", 1000},
    {"tillotson",
     "model: fluid, equation_of_state: {kind: tillotson, heat_a: 0.5, heat_b: 1.5, bulk_a: 27e9, bulk_b: 27e9, "
     "reference_energy: 4.9e8, alpha: 5, beta: 5, incipient_energy: 4.7e6, vapour_energy: 1.8e7}",
     2700, 0, 0, false},
};

const std::vector<std::string> kinds = {"elements: hexahedra",  "elements: hexahedra, integration: full",
                                        "elements: wedges",     "elements: pyramids",
                                        "elements: tetrahedra", "elements: tetrahedra PLAIN"};

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), by);
}

/// The law with s times its density, and the same stress of the same motion.
std::string write_law(const SampleLaw& law, double s) {
  std::string constants = law.constants;
  replace(constants, "HEAT", fmt::format("{:.17g}", law.heat / s));
  replace(constants, "SPEED", fmt::format("{:.17g}", law.speed / std::sqrt(s)));
  return fmt::format("materials: {{m: {{density: {:.17g}, {}}}}}\n", law.density * s, constants);
}

std::string write_body(std::string kind, const std::string& size, const std::string& more) {
  const bool is_plain = kind.find("PLAIN") != std::string::npos;
  replace(kind, " PLAIN", "");
  return "elements: {bulk_viscosity: {linear: 0, quadratic: 0}" + std::string(is_plain ? ", tetrahedra: plain" : "") +
         "}\nparts: {body: {box: {" + size + "}, material: m, " + kind + more + "}}\n";
}

std::string ask_for(double step) { return fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 99}}", step); }

double find_bound(const std::string& text) {
  Scene scene(text);
  scene.stepper.start(scene.state);
  return scene.state.bound.step;
}

/// Largest difference of the records' stresses, over the largest of them.
double compare_stresses(const Scene& a, const Scene& b) {
  double difference = 0, largest = 0;
  for (int c = 0; c < a.model.chunks.count; ++c) {
    for (int i = 0; i < count_elements(a.model.chunks, c); ++i) {
      const ElementRecord one = find_record(a.model.chunks, a.state.elements, c, i),
                          other = find_record(b.model.chunks, b.state.elements, c, i);
      for (int k = 0; k < 6; ++k) {
        const double stress = one.get(HexRecord::stress + k);
        difference = std::max(difference, std::abs(stress - other.get(HexRecord::stress + k)));
        largest = std::max(largest, std::abs(stress));
      }
    }
  }
  EXPECT_GT(largest, 0);
  return difference / largest;
}

}  // namespace

// A cube whose faces all move inwards, at given steps: nothing is left to masses.
TEST(ScaledLaws, StressesFollowFromTheMotionAlone) {
  const std::string motion = R"(
time: {end: 1, max_step: 2e-7}
conditions:
  - {nodes: body/x_min, velocity: {x: 20}}
  - {nodes: body/x_max, velocity: {x: -20}}
  - {nodes: body/y_min, velocity: {y: 20}}
  - {nodes: body/y_max, velocity: {y: -20}}
  - {nodes: body/z_min, velocity: {z: 20}}
  - {nodes: body/z_max, velocity: {z: -20}}
)";
  const std::string cube = "size: [0.01, 0.01, 0.01], cells: [1, 1, 1]";
  for (const SampleLaw& law : sample_laws) {
    for (const std::string& kind : kinds) {
      const std::string rest = motion + write_law(law, 1);
      const double wanted = 2 * find_bound(rest + write_body(kind, cube, ""));
      Scene plain(rest + write_body(kind, cube, "")), scaled(rest + write_body(kind, cube, ask_for(wanted)));
      plain.run(50);
      scaled.run(50);
      EXPECT_GT(scaled.model.total_mass, 1.5 * plain.model.total_mass) << law.name << ", " << kind;
      EXPECT_LT(compare_stresses(plain, scaled), 1e-11) << law.name << ", " << kind;  // round-off of the middle
    }
  }
}

// A block whose elements are all alike flies into a wall: every element gets the same share of mass.
TEST(ScaledLaws, MoveAsADenserMaterialDoes) {
  const std::string flight = R"(
time: {end: 1}
initial: [{velocity: [3, 0, -20], angular_velocity: [50, 200, 100]}]
walls: [{normal: z, point: [0, 0, -0.001]}]
)";
  const std::string block = "size: [0.03, 0.02, 0.02], cells: [3, 2, 2]";
  for (const SampleLaw& law : sample_laws) {
    for (const std::string& kind : kinds) {
      if (!law.has_twin || kind == "elements: tetrahedra") continue;
      const std::string plain = write_body(kind, block, "");
      const double bound = find_bound(flight + plain + write_law(law, 1)), wanted = 1.7 * bound;
      Scene scaled(flight + write_law(law, 1) + write_body(kind, block, ask_for(wanted)));
      Scene dense(flight + write_law(law, 1.7 * 1.7) + plain);
      EXPECT_NEAR(scaled.model.total_mass / dense.model.total_mass, 1, 1e-12) << law.name << ", " << kind;
      scaled.run(150);
      dense.run(150);
      EXPECT_NEAR(scaled.state.time / dense.state.time, 1, 1e-9) << law.name << ", " << kind;
      double difference = 0, moved = 0;
      for (std::size_t n = 0; n < static_cast<std::size_t>(scaled.model.node_count); ++n) {
        for (std::size_t k = 0; k < 3; ++k) {
          difference = std::max(difference, std::abs(scaled.state.x(n, k) - dense.state.x(n, k)));
          moved = std::max(moved, std::abs(dense.state.x(n, k) - dense.model.start(n, k)));
        }
      }
      EXPECT_LT(difference, 1e-8 * moved) << law.name << ", " << kind;  // round-off, grown by contact
    }
  }
}

// Tetrahedra share the mass of their nodes: a bar of them, held at one end, swings with 4 L sqrt(m / (E A L)), m with
// what was added.
TEST(ScaledLaws, ABarOfTetrahedraSwingsWithItsMass) {
  const std::string bar = "size: [0.2, 0.02, 0.02], cells: [20, 2, 2]", rest = R"(
time: {end: 1}
initial: [{velocity: [1, 0, 0]}]
conditions: [{nodes: body/x_min, fixed: [x]}]
materials: {m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}
)";
  const double bound = find_bound(rest + write_body(kinds[4], bar, "")), wanted = 2.5 * bound;
  Scene scene(rest + write_body(kinds[4], bar, ask_for(wanted)));
  scene.stepper.start(scene.state);
  EXPECT_NEAR(scene.state.bound.step / wanted, 1, 2e-6);
  EXPECT_GT(scene.model.total_mass, 4 * 7850 * 0.2 * 4e-4);
  const double half = 2 * std::sqrt(scene.model.total_mass * 0.2 / (200e9 * 4e-4));
  const auto find_tip = [&] {
    double sum = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(scene.model.node_count); ++n)
      if (scene.model.start(n, 0) > 0.2 - 1e-9) sum += scene.state.x(n, 0) - 0.2;
    return sum;
  };
  do scene.stepper.advance(scene.state);
  while (find_tip() > 0 && scene.state.time < 2 * half);
  EXPECT_NEAR(scene.state.time / half, 1, 0.02);  // of 20 elements along it
}

}  // namespace percuss::test
