#include "tests/verification/support/shell_rest.hpp"

#include <fmt/format.h>

#include <cmath>

namespace percuss::test {

namespace {

std::size_t find_node(const Scene& scene, std::int64_t id) {
  const auto& ids = scene.chunked.mesh.node_ids;
  return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
}

double find_kinetic_energy(const Scene& scene) {
  const auto v = to_host(scene.state.v), w = to_host(scene.state.w);
  const auto mass = to_host(scene.model.mass), inertia = to_host(scene.model.inertia);
  double energy = 0;
  for (std::size_t n = 0; n < mass.extent(0); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      energy += 0.5 * (mass(n) * v(n, k) * v(n, k) + inertia(n) * w(n, k) * w(n, k));
    }
  }
  return energy;
}

/// The impulses of the loads over the step that comes, into the velocities that it starts from.
void push(Scene& scene, const std::vector<NodeLoad>& loads, double share) {
  const auto v = scene.state.v;
  const auto inverse_mass = scene.model.inverse_mass;
  const double dt = 0.5 * (scene.state.dt + scene.state.next_dt);
  for (const NodeLoad& load : loads) {
    const std::size_t n = find_node(scene, load.node_id);
    for (std::size_t k = 0; k < 3; ++k) v(n, k) += share * load.force[k] * inverse_mass(n, k) * dt;
  }
}

}  // namespace

std::string make_static_deck(const std::string& file, double young, double poisson, double thickness,
                             const std::string& conditions) {
  return fmt::format(R"yaml(
time: {{end: 1e9}}
parts: {{shell: {{exodus: {{file: {}}}, thickness: {}, points: 2, material: elastic}}}}
materials: {{elastic: {{model: elastic, density: 1, youngs_modulus: {}, poissons_ratio: {}}}}}
conditions: {}
)yaml",
                     file, thickness, young, poisson, conditions);
}

Vec3 bring_to_rest(Scene& scene, const std::vector<NodeLoad>& loads, std::int64_t watched, const RestOptions& options) {
  const std::size_t node = find_node(scene, watched);
  const auto find_displacement = [&] {
    Vec3 u{};
    for (std::size_t k = 0; k < 3; ++k) u[k] = scene.state.x(node, k) - scene.model.start(node, k);
    return u;
  };
  Vec3 before{};
  double energy = 0;
  int peaks = 0;
  scene.stepper.start(scene.state);
  for (int step = 1; step <= options.steps && peaks < options.peaks; ++step) {
    push(scene, loads, std::min(1.0, double(step) / options.ramp));
    scene.stepper.advance(scene.state);
    const double now = find_kinetic_energy(scene);
    if (step > options.ramp && now < energy) {
      Kokkos::deep_copy(scene.state.v, 0.0);
      Kokkos::deep_copy(scene.state.w, 0.0);
      const Vec3 u = find_displacement();
      const double change = std::hypot(u[0] - before[0], u[1] - before[1], u[2] - before[2]);
      if (change < options.tolerance * std::hypot(u[0], u[1], u[2])) break;
      before = u;
      ++peaks;
      energy = 0;
    } else {
      energy = now;
    }
  }
  return find_displacement();
}

}  // namespace percuss::test
