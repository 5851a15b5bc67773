// How large a generated mesh will be, known before any memory is asked for.

#include <algorithm>

#include "src/mesh/part_mesh.hpp"
#include "src/mesh/rounded_lattice.hpp"

namespace percuss {
namespace {

MeshCount count(const BoxShape& box) {
  const double x = box.cells[0], y = box.cells[1], z = box.cells[2];
  return {(x + 1) * (y + 1) * (z + 1), x * y * z};
}

MeshCount count(const CylinderShape& cylinder) {
  const RoundSplit split = split_round(cylinder.across);
  const double core = split.core, rings = split.rings, along = cylinder.along;
  return {((core + 1) * (core + 1) + 4 * core * rings) * (along + 1), (core * core + 4 * core * rings) * along};
}

MeshCount count(const TubeShape& tube) {
  const double wall = tube.cells[0], around = tube.cells[1], along = tube.cells[2];
  return {(wall + 1) * around * (along + 1), wall * around * along};
}

MeshCount count(const SphereShape& sphere) {
  const RoundSplit split = split_round(sphere.across);
  const double core = split.core, shells = split.rings;
  return {(core + 1) * (core + 1) * (core + 1) + (6 * core * core + 2) * shells,
          core * core * core + 6 * core * core * shells};
}

MeshCount count(const ExodusMesh&) { return {}; }  // its file says

}  // namespace

MeshCount count_mesh(const Shape& generated) {
  return std::visit([](const auto& shape) { return count(shape); }, generated);
}

}  // namespace percuss
