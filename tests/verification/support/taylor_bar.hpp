#pragma once
// The copper Taylor bar, its foot held to the plane of impact as in the reference, or free to leave a rigid wall.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "tests/src/mesh/files/ten_nodes.hpp"
#include "tests/verification/support/mapped_mesh.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {

/// Shape of the bar at 80 us [m], and what it says about the elements.
struct TaylorShape {
  double length = 0;
  double foot_on_axes = 0;      // radius of the foot along the lattice of the core
  double foot_on_diagonal = 0;  // and along its diagonal
  double largest_foot = 0;      // of all nodes of the rim
  double smallest_foot = 0;
  double hourglass = 0;     // hourglass over internal energy
  double energy_error = 0;  // largest of the run

  double mean_foot() const { return 0.5 * (foot_on_axes + foot_on_diagonal); }
};

enum class TaylorFoot { held, on_wall };
/// Elements that the cells of its mesh become.
enum class TaylorCells { hexahedra, tetrahedra, tetrahedra_of_ten_nodes, wedges };

/// Runs a quarter of the bar between its planes of symmetry: 3 n^2 elements a section, 20 n sections; the mesh that a
/// generated cylinder with `cells: [4 n, 20 n]` has there.
inline TaylorShape run_taylor_bar(int n, TaylorFoot foot, const std::string& elements = "{}",
                                  TaylorCells cells = TaylorCells::hexahedra) {
  testing_mesh::WrittenMesh mesh = make_quarter_cylinder(3.2e-3, 32.4e-3, n, 20 * n);
  const bool have_ten = cells == TaylorCells::tetrahedra_of_ten_nodes;
  if (cells == TaylorCells::tetrahedra || have_ten) cut_into_tetrahedra(mesh);
  if (have_ten) testing_mesh::raise_to_ten_nodes(mesh);
  if (cells == TaylorCells::wedges) cut_into_wedges(mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "taylor_bar.exo"));
  const bool held = foot == TaylorFoot::held;
  const int core = (n + 1) * (n + 1), around = 2 * n + 1;
  std::string rim;
  for (int s = 0; s < around; ++s) {
    rim += fmt::format("      - {{name: rim{}, id: {}}}\n", s, core + (n - 1) * around + s + 1);
  }
  const Outcome run = run_deck(fmt::format(
      R"(
title: Taylor bar
time: {{end: 80e-6}}
parts: {{bar: {{exodus: {{file: {}}}, material: copper}}}}
materials:
  copper: {{model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 400e6, hardening_modulus: 100e6}}
elements: {}
initial: [{{part: bar, velocity: [0, 0, -227]}}]
conditions:
  - {{nodes: bar/x_plane, symmetry: x}}
  - {{nodes: bar/y_plane, symmetry: y}}
{}
output:
  history:
    every: 1e-6
    nodes:
      - {{name: top, near: [0, 0, 32.4e-3]}}
      - {{name: foot, near: [0, 0, 0]}}
{})",
      file.path(), elements, held ? "  - {nodes: bar/foot, fixed: [z]}" : "walls: [{normal: [0, 0, 1]}]", rim));
  const HistoryTable& h = run.history;
  TaylorShape shape;
  shape.length = h.last("top_z") - h.last("foot_z");
  const auto radius = [&](int s) {
    return std::hypot(h.last(fmt::format("rim{}_x", s)), h.last(fmt::format("rim{}_y", s)));
  };
  shape.foot_on_axes = 0.5 * (radius(0) + radius(2 * n));
  shape.foot_on_diagonal = shape.largest_foot = shape.smallest_foot = radius(n);
  for (int s = 0; s < around; ++s) {
    shape.largest_foot = std::max(shape.largest_foot, radius(s));
    shape.smallest_foot = std::min(shape.smallest_foot, radius(s));
  }
  shape.hourglass = h.last("hourglass") / h.last("internal");
  shape.energy_error = std::max(h.largest("energy_error"), -h.smallest("energy_error"));
  fmt::print(
      "n {}: L {:.3f} mm, R {:.3f} mm on the axes, {:.3f} mm on the diagonal, rim {:.3f} to {:.3f} mm, hourglass "
      "{:.2e} of internal, energy {:.1e}\n",
      n, 1e3 * shape.length, 1e3 * shape.foot_on_axes, 1e3 * shape.foot_on_diagonal, 1e3 * shape.smallest_foot,
      1e3 * shape.largest_foot, shape.hourglass, shape.energy_error);
  return shape;
}

// Two independent codes on several meshes give 21.42 +- 0.01 mm and 7.225 +- 0.008 mm.
inline constexpr double taylor_length = 21.42e-3, taylor_radius = 7.225e-3;

}  // namespace percuss::test
