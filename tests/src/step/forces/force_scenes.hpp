#pragma once
// Scenes with forces in their history, and what tests ask of them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "comm/exact_reduction.hpp"
#include "src/step/forces/force_books.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {

/// Momentum of the nodes for which is_counted(x at time 0) holds, of all ranks.
template <class Counted>
Vec3 sum_momentum(const Scene& scene, const Counted& is_counted) {
  const auto v = to_host(scene.state.v), start = to_host(scene.model.start);
  const auto mass = to_host(scene.state.mass);
  std::array<ExactSum, 3> sums{};
  for (std::size_t n = 0; n < mass.extent(0); ++n) {
    if (!owns_node(scene.chunked, static_cast<int>(n)) || !is_counted(Vec3{start(n, 0), start(n, 1), start(n, 2)}))
      continue;
    for (std::size_t k = 0; k < 3; ++k) sums[k].add(mass(n) * v(n, k));
  }
  sum_over_ranks(scene.model.ranks, sums);
  return {sums[0].round(), sums[1].round(), sums[2].round()};
}

/// The values of a row of the history that are of actions, forces and accelerometers among them.
inline std::vector<double> take_values(Scene& scene) {
  std::vector<double> row;
  scene.stepper.append_values(scene.state, row);
  return row;
}

/// Values of a row by the headings of their columns.
inline std::map<std::string, double> take_row(Scene& scene) {
  const std::vector<HistoryColumn> columns = scene.stepper.list_columns();
  const std::vector<double> row = take_values(scene);
  EXPECT_EQ(row.size(), columns.size());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < row.size(); ++i) values[columns[i].name] = row[i];
  return values;
}

/// The values of a row by the headings of their columns, as impulses: mean times the time of the row, which of the
/// first ends half a step earlier.
inline std::map<std::string, double> take_impulses(Scene& scene, double since) {
  std::map<std::string, double> values = take_row(scene);
  const double passed = scene.state.time - since - (since == 0 ? 0.5 * scene.state.dt : 0);
  for (auto& [name, value] : values) value *= passed;
  return values;
}

inline Vec3 find_vector(const std::map<std::string, double>& values, char kind, const std::string& force) {
  Vec3 v{};
  for (std::size_t k = 0; k < 3; ++k) v[k] = values.at(std::string{kind, "xyz"[k], ':'} + force);
  return v;
}

inline void expect_near(const Vec3& a, const Vec3& b, double tolerance, int line = __builtin_LINE()) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "direction " << k << ", line " << line;
}

inline Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

inline std::string read_file(const std::string& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

/// Two boxes that meet askew before a wall, and a third that touches nothing.
inline std::string make_collision(const std::string& enforcement) {
  return R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 1, 1], cells: [5, 5, 5]}, at: [0.01, 0, 0], material: m}
  b: {box: {size: [1.3, 0.9, 1.1], cells: [6, 5, 5]}, at: [1.02, 0.3, 0.2], material: m}
  c: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [0, 5, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
initial: [{part: b, velocity: [-1, 0.3, 0]}, {part: c, velocity: [1, 0, 0]}]
walls: [{name: left, point: [0, 0, 0], normal: x}]
contact: {friction: 0.2, enforcement: )" +
         enforcement + R"(}
output:
  history:
    forces:
      - {name: ab, contact: [a, b]}
      - {name: ba, contact: [b, a], about: [1, 2, 3]}
      - {name: ba_origin, contact: [b, a]}
      - {name: a_all, contact: [a, all]}
      - {name: both, contact: [[a, b], all]}
      - {name: ca, contact: [c, [a, b]]}
      - {name: wall, wall: left}
)";
}

/// A block that presses flat on another by its speed, in uniaxial strain: areas stay.
struct Base {
  const char* shape;
  double place;
};
inline std::string make_flat(const char* friction, const Base& base) {
  return fmt::format(R"(
time: {{end: 1}}
parts:
  top: {{box: {{size: [0.6, 0.4, 1], cells: [3, 2, 10]}}, at: [0.2, 0.2, 1.001], material: m}}
  base: {{box: {{{}}}, at: [{}, {}, 0], material: m}}
materials: {{m: {{model: elastic, density: 4, youngs_modulus: 100, poissons_ratio: 0}}}}
initial: [{{part: top, velocity: [0, 0, -0.1]}}]
conditions: [{{nodes: top, fixed: [x, y]}}, {{nodes: base, fixed: [x, y]}}]
contact: {{friction: {}}}
output: {{history: {{forces: [{{name: top, contact: [top, base]}}, {{name: base, contact: [base, top]}}]}}}}
)",
                     base.shape, base.place, base.place, friction);
}
inline const Base equal_base{"size: [0.6, 0.4, 1], cells: [3, 2, 10]", 0.2};
inline const Base wide_base{"size: [1, 0.8, 1], cells: [5, 4, 10]", 0};

/// Means of a row over some time in which the block presses, and the force on it from its momentum.
inline std::map<std::string, double> press_flat(const std::string& deck, double& force) {
  Scene scene(deck);
  scene.stepper.start(scene.state);
  const auto is_top = [](const Vec3& x) { return x[2] > 1.0005; };
  while (scene.state.time < 0.05) scene.stepper.advance(scene.state);  // it has met the base
  const double since = scene.state.time;
  take_values(scene);
  const Vec3 before = sum_momentum(scene, is_top);
  while (scene.state.time < 0.2) scene.stepper.advance(scene.state);
  const double duration = scene.state.time - since;
  auto means = take_impulses(scene, since);
  for (auto& [name, mean] : means) mean /= duration;
  force = minus(sum_momentum(scene, is_top), before)[2] / duration;
  return means;
}

}  // namespace percuss::test
