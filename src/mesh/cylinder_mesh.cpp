#include <cstddef>
#include <initializer_list>

#include "src/mesh/part_mesh.hpp"
#include "src/mesh/rounded_lattice.hpp"

namespace percuss {
namespace {

/// The section: quadrilaterals, counter-clockwise seen from +z. Outside, their edge 1-2 lies on the circle.
struct Disk {
  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<int, 4>> quads;  // core first, then ring after ring
  int first_outer_quad = 0;               // the quads from here on touch the circle
};

/// Core lattice points along its boundary, counter-clockwise from a corner.
std::vector<std::array<int, 2>> list_core_boundary(int core) {
  std::vector<std::array<int, 2>> points;
  for (int i = 0; i < core; ++i) points.push_back({i, 0});
  for (int i = 0; i < core; ++i) points.push_back({core, i});
  for (int i = 0; i < core; ++i) points.push_back({core - i, core});
  for (int i = 0; i < core; ++i) points.push_back({0, core - i});
  return points;
}

Disk make_disk(double radius, RoundSplit split) {
  const RoundedLattice<2> lattice(radius, split);
  const int core = split.core;
  const std::vector<std::array<int, 2>> boundary = list_core_boundary(core);
  const int around = static_cast<int>(boundary.size()), core_nodes = (core + 1) * (core + 1);
  const auto core_node = [&](int i, int j) { return i + (core + 1) * j; };
  const auto ring_node = [&](int ring, int place) {
    const auto [i, j] = boundary[static_cast<std::size_t>(place % around)];
    return ring == 0 ? core_node(i, j) : core_nodes + (ring - 1) * around + place % around;
  };
  Disk disk;
  for (int j = 0; j <= core; ++j) {
    for (int i = 0; i <= core; ++i) disk.nodes.push_back(lattice({i, j}, 0));
  }
  for (int ring = 1; ring <= split.rings; ++ring) {
    for (const auto& point : boundary) disk.nodes.push_back(lattice(point, ring));
  }
  for (int j = 0; j < core; ++j) {
    for (int i = 0; i < core; ++i) {
      disk.quads.push_back({core_node(i, j), core_node(i + 1, j), core_node(i + 1, j + 1), core_node(i, j + 1)});
    }
  }
  for (int ring = 0; ring < split.rings; ++ring) {
    disk.first_outer_quad = static_cast<int>(disk.quads.size());
    for (int p = 0; p < around; ++p) {
      disk.quads.push_back(
          {ring_node(ring, p), ring_node(ring + 1, p), ring_node(ring + 1, p + 1), ring_node(ring, p + 1)});
    }
  }
  return disk;
}

}  // namespace

PartMesh make_cylinder(const CylinderShape& shape) {
  const Disk disk = make_disk(shape.radius, split_round(shape.across));
  const int section_nodes = static_cast<int>(disk.nodes.size()), section_quads = static_cast<int>(disk.quads.size());
  PartMesh mesh;
  for (int k = 0; k <= shape.along; ++k) {
    const double z = shape.length * (double(k) / shape.along);
    for (const auto& [x, y] : disk.nodes) mesh.nodes.push_back({x, y, z});
  }
  for (int k = 0; k < shape.along; ++k) {
    for (const auto& q : disk.quads) {
      const int low = k * section_nodes, high = low + section_nodes;
      mesh.elements.push_back(
          {low + q[0], low + q[1], low + q[2], low + q[3], high + q[0], high + q[1], high + q[2], high + q[3]});
    }
  }
  auto &start = mesh.side_sets["start"], &end = mesh.side_sets["end"], &side = mesh.side_sets["side"];
  for (int q = 0; q < section_quads; ++q) {
    start.push_back({q, 4});
    end.push_back({(shape.along - 1) * section_quads + q, 5});
  }
  for (int k = 0; k < shape.along; ++k) {
    for (int q = disk.first_outer_quad; q < section_quads; ++q) side.push_back({k * section_quads + q, 1});
  }
  return mesh;
}

}  // namespace percuss
