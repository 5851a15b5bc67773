// The chunked launcher against the pure element function, element by element and bit by bit, on a mesh whose chunks end
// in partly empty packs.

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

#include "kernels/element/hex8/point_mean.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/results/fields/element_fields.hpp"
#include "tests/kernels/element/random_element.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

// 693 elements in several chunks and 15 in one of their own; the tough part yields, the other cannot.
std::string make_launcher_text(const std::string& elements) {
  return R"(
time: {end: 1}
parts:
  tough: {box: {size: [11, 9, 7], cells: [11, 9, 7]}, material: copper}
  small: {box: {size: [5, 3, 1], cells: [5, 3, 1]}, at: [20, 0, 0], material: steel}
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 400e6, hardening_modulus: 1e9}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
elements: )" +
         elements + "\n";
}

/// Everything about the elements, advanced one by one by advance_hex8 on doubles.
template <HexKind Kind>
class OneByOne {
 public:
  explicit OneByOne(const Scene& scene) : scene_(scene) {
    const auto mass = to_host(scene.model.element_mass);
    for (std::size_t e = 0; e < scene.chunked.mesh.elements.size(); ++e) {
      plastic_.push_back(make_state<J2Plasticity, Kind>(mass(e)));
      elastic_.push_back(make_state<Elastic, Kind>(mass(e), find_modes(gather(scene.model.start, e))));
    }
  }

  /// Forces on the nodes: within a chunk by ascending element, then chunk by chunk.
  std::vector<Vec3> advance(double dt) {
    const Mesh& mesh = scene_.chunked.mesh;
    std::vector<Vec3> force(mesh.nodes.size(), Vec3{});
    results.clear();
    for (const Chunk& chunk : scene_.chunked.chunks) {
      std::vector<Vec3> share(mesh.nodes.size(), Vec3{});
      for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
        add_element(static_cast<std::size_t>(e), dt, share);
      }
      for (std::size_t n = 0; n < force.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) force[n][k] += share[n][k];
      }
    }
    return force;
  }

  /// Mean over the points, in space axes.
  Symmetric3<double> find_stress(std::size_t e) const {
    return is_plastic(e) ? find_mean_stress(plastic_[e]) : find_mean_stress(elastic_[e]);
  }
  double find_strain(std::size_t e) const {
    if (!is_plastic(e)) return 0;
    if constexpr (hex_points < Kind >> 1) {
      return find_point_mean(hex_points<Kind>, [&](int p) { return plastic_[e].history.value[0][p]; });
    } else {
      return plastic_[e].history.value[0][0];
    }
  }

  std::vector<HexResult<double>> results;

 private:
  template <class State>
  static Symmetric3<double> find_mean_stress(const State& state) {
    const std::vector<Symmetric3<double>> points = list_stresses(state);
    const int count = static_cast<int>(points.size());
    Symmetric3<double> mean = find_point_share(count, 0) * points[0];
    for (int p = 1; p < count; ++p) mean = mean + find_point_share(count, p) * points[static_cast<std::size_t>(p)];
    return push_forward(state.polar.rotation, mean);
  }

  bool is_plastic(std::size_t e) const { return scene_.chunked.mesh.part_of(e) == 0; }

  Corners gather(const Rows3<double>& rows, std::size_t e) const {
    const auto host = to_host(rows);
    Corners c{};
    for (std::size_t i = 0; i < 8; ++i) {
      const auto n = static_cast<std::size_t>(scene_.chunked.mesh.corners(e)[i]);
      c.x[i] = host(n, 0), c.y[i] = host(n, 1), c.z[i] = host(n, 2);
    }
    return c;
  }

  void add_element(std::size_t e, double dt, std::vector<Vec3>& share) {
    const VectorModes<double> a = find_modes(gather(scene_.state.x, e)), v = find_modes(gather(scene_.state.v, e));
    double f[3][8];
    if (is_plastic(e)) {
      const LameConstants c = find_lame_constants(117e9, 0.35);
      const SolidParameters<J2Plasticity> par{{c.lambda, c.mu, 400e6, 1e9}, c.lambda, c.mu, 0.1, {0.06, 1.2}};
      results.push_back(advance_hex8(par, a, v, dt, plastic_[e], {f[0], f[1], f[2]}));
    } else {
      const LameConstants c = find_lame_constants(200e9, 0.3);
      const SolidParameters<Elastic> par{{c.lambda, c.mu}, c.lambda, c.mu, 0.1, {0.06, 1.2}};
      results.push_back(advance_hex8(par, a, v, dt, elastic_[e], {f[0], f[1], f[2]}));
    }
    for (std::size_t i = 0; i < 8; ++i) {
      const auto n = static_cast<std::size_t>(scene_.chunked.mesh.corners(e)[i]);
      for (std::size_t k = 0; k < 3; ++k) share[n][k] -= f[k][i];
    }
  }

  const Scene& scene_;
  std::vector<HexState<double, J2Plasticity, Kind>> plastic_;
  std::vector<HexState<double, Elastic, Kind>> elastic_;
};

/// Distorts the mesh and gives every node its own velocity.
void shake(Scene& scene) {
  Random random(21);
  const auto x = Kokkos::create_mirror_view(scene.state.x);
  const auto v = Kokkos::create_mirror_view(scene.state.v);
  Kokkos::deep_copy(x, scene.state.x);
  for (std::size_t n = 0; n < x.extent(0); ++n) {
    for (std::size_t k = 0; k < 3; ++k) x(n, k) += 0.1 * random();
    for (std::size_t k = 0; k < 3; ++k) v(n, k) = 60 * random();
  }
  Kokkos::deep_copy(scene.state.x, x);
  Kokkos::deep_copy(scene.state.v, v);
}

template <HexKind Kind>
void expect_same_results(const OneByOne<Kind>& expected, const Scene& scene) {
  const auto step = to_host(scene.state.results.stable_step);
  const auto controlling = to_host(scene.state.results.controlling_element);
  const auto failed = to_host(scene.state.results.failed_element);
  for (std::size_t c = 0; c < scene.chunked.chunks.size(); ++c) {
    const Chunk& chunk = scene.chunked.chunks[c];
    int lowest = chunk.first_element;
    for (int e = lowest; e < chunk.first_element + chunk.element_count; ++e) {
      const auto bound = [&](int i) { return expected.results[static_cast<std::size_t>(i)].stable_step; };
      if (bound(e) < bound(lowest)) lowest = e;
    }
    EXPECT_EQ(controlling(c), lowest);
    EXPECT_EQ(step(c), expected.results[static_cast<std::size_t>(lowest)].stable_step);
    EXPECT_EQ(failed(c), -1);
  }
}

template <HexKind Kind>
void compare_steps(const std::string& elements) {
  Scene scene(make_launcher_text(elements));
  ASSERT_GE(scene.chunked.chunks.size(), 3u);
  shake(scene);
  OneByOne<Kind> one_by_one(scene);
  const Rows3<double> force("force", scene.chunked.mesh.nodes.size());
  double work[3] = {0, 0, 0};
  for (int n = 0; n < 3; ++n) {
    const double dt = 2e-5;
    move_nodes(ExecSpace(), scene.state.v, dt, scene.state.x);
    const std::vector<Vec3> expected = one_by_one.advance(dt);
    advance_elements(ExecSpace(), scene.model.chunks, scene.model.others->hexahedra, {scene.state.x, scene.state.v, dt},
                     scene.state.chunk_fields());
    assemble_slots(ExecSpace(), scene.model.nodes_to_slots, scene.state.slot_force, force);
    const auto host = to_host(force);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(host(i, k), expected[i][k]) << "node " << i << " step " << n;
    }
    expect_same_results(one_by_one, scene);
    for (const HexResult<double>& r : one_by_one.results) {
      work[0] += r.work.internal, work[1] += r.work.hourglass, work[2] += r.work.viscous;
    }
  }
  // Work is added lane by lane within packs: another order than here, so equal only up to the round-off of 708 terms.
  const auto chunk_work = to_host(scene.state.results.work);
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (std::size_t c = 0; c < chunk_work.extent(0); ++c) sum += chunk_work(c, k);
    EXPECT_NEAR(sum, work[k], 1e-12 * std::abs(work[k]));  // 2x2x2 points do no hourglass work
  }
  const std::vector<double> stresses = find_stresses(scene.model, scene.state);
  const std::vector<double> strains = find_plastic_strains(scene.model, scene.state);
  double largest_strain = 0;
  for (std::size_t e = 0; e < strains.size(); ++e) {
    const Symmetric3<double> s = one_by_one.find_stress(e);
    const double row[6] = {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
    for (std::size_t k = 0; k < 6; ++k) ASSERT_EQ(stresses[6 * e + k], row[k]) << "element " << e;
    ASSERT_EQ(strains[e], one_by_one.find_strain(e));
    largest_strain = std::max(largest_strain, strains[e]);
  }
  EXPECT_GT(largest_strain, 1e-3);  // the comparison went through the plastic branch
}

}  // namespace

TEST(AdvanceElements, GivesTheBitsOfTheElementFunctionWithStiffnessHourglassControl) {
  compare_steps<HexKind::stiffness>("{hourglass: {kind: stiffness, coefficient: 0.1}}");
}

TEST(AdvanceElements, GivesTheBitsOfTheElementFunctionWithViscousHourglassControl) {
  compare_steps<HexKind::viscous>("{hourglass: {kind: viscous, coefficient: 0.1}}");
}

TEST(AdvanceElements, GivesTheBitsOfTheElementFunctionWithAssumedStrainHourglassControl) {
  compare_steps<HexKind::assumed_strain>("{}");
}

TEST(AdvanceElements, GivesTheBitsOfTheElementFunctionWithFullIntegration) {
  compare_steps<HexKind::full>("{integration: full}");
}

TEST(AdvanceElements, GivesTheBitsOfTheElementFunctionOfThickShells) {
  compare_steps<HexKind::thick3>("{integration: {kind: thick_shell, points: 3}}");
  compare_steps<HexKind::thick5>("{integration: {kind: thick_shell, points: 5}}");
}

TEST(NodeSlots, HoldEverySlotOfANodeOnceInAscendingOrder) {
  const Scene scene(make_launcher_text("{}") +
                    "loads: {pressure: [{faces: tough/x_min, value: 1}, {faces: tough, value: 2}]}\n");
  const Model& model = scene.model;
  const auto first = to_host(model.nodes_to_slots.first);
  const auto slots = to_host(model.nodes_to_slots.slots);
  const auto slots_to_nodes = to_host(model.chunks.slots_to_nodes);
  const auto faces = to_host(model.pressure_faces.nodes);
  ASSERT_EQ(model.slot_count, static_cast<int>(slots.extent(0)));
  ASSERT_EQ(model.pressure_faces.first_slot, static_cast<int>(slots_to_nodes.extent(0)));
  const auto find_node = [&](int s) {
    const int f = s - model.pressure_faces.first_slot;
    return f < 0 ? slots_to_nodes(static_cast<std::size_t>(s))
                 : faces(static_cast<std::size_t>(f / 4), static_cast<std::size_t>(f % 4));
  };
  std::vector<int> seen(slots.extent(0), 0);
  for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n) {
    for (int i = first(n); i < first(n + 1); ++i) {
      const int s = slots(static_cast<std::size_t>(i));
      EXPECT_EQ(find_node(s), static_cast<int>(n));
      if (i > first(n)) {
        EXPECT_GT(s, slots(static_cast<std::size_t>(i - 1)));
      }
      ++seen[static_cast<std::size_t>(s)];
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size()));
}

}  // namespace percuss::test
