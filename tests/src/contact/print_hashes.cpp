// Prints the state hash of scenes with much contact: compare_threads runs it with several numbers of threads.

#include <fmt/format.h>

#include "tests/src/step/scene.hpp"

namespace {

const std::string steel =
    "\nmaterials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

// Enough nodes, pairs and rows for every kernel of contact to use threads.
const std::string wall = R"(
time: {end: 1}
parts:
  ball: {sphere: {radius: 0.08, cells: 6}, at: [-0.0803, 0.2, 0.12], material: steel}
  bricks: {box: {size: [0.1, 0.2, 0.06], cells: [3, 6, 3]}, array: {count: [1, 3, 7], pitch: [0.1, 0.2, 0.06], stagger: 0.5}, material: steel}
initial: [{part: ball, velocity: [80, 10, 0], angular_velocity: [100, 0, 200]}]
walls: [{point: [0.1001, 0, 0], normal: [-1, 0, 0], friction: 0.3}]
contact: {surfaces: all, friction: 0.3})";

const std::string drop = R"(
time: {end: 1}
parts:
  floor: {box: {size: [0.4, 0.4, 0.1], cells: [8, 8, 2]}, at: [-0.2, -0.2, -0.1], material: steel}
  cube: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [0.013, 0.017, 0.0006], material: steel}
initial: [{part: cube, velocity: [3, 0, -20]}]
contact: {surfaces: all, friction: 0.2})";

void print_hash(const std::string& name, const std::string& text, int steps) {
  percuss::test::Scene scene(text + steel);
  scene.contact.prepare(scene.state.x, scene.state.v);
  scene.run(steps);
  fmt::print("{} {:016x}\n", name, percuss::hash_state(scene.model, scene.state));
}

}  // namespace

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  const Kokkos::ScopeGuard kokkos(argc, argv);
  print_hash("wall", wall, 60);
  print_hash("drop", drop, 60);
}
