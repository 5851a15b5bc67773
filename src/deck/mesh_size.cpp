#include "src/deck/mesh_size.hpp"

#include <algorithm>

namespace percuss {
namespace {

// A disc or ball of `across` cells on its diameter: a core of core cells an edge, and rings around it (CylinderShape).
struct Rings {
  double rings, core;
};

Rings split(int across) {
  const int rings = std::max(1, across / 4);
  return {static_cast<double>(rings), static_cast<double>(across - 2 * rings)};
}

MeshSize count(const BoxShape& box) {
  const double x = box.cells[0], y = box.cells[1], z = box.cells[2];
  return {x * y * z, (x + 1) * (y + 1) * (z + 1)};
}

MeshSize count(const CylinderShape& cylinder) {
  const auto [rings, core] = split(cylinder.across);
  const double along = cylinder.along;
  return {(core * core + 4 * core * rings) * along, ((core + 1) * (core + 1) + 4 * core * rings) * (along + 1)};
}

MeshSize count(const TubeShape& tube) {
  const double through = tube.cells[0], around = tube.cells[1], along = tube.cells[2];
  const double lines = tube.arc < 360 ? around + 1 : around;  // of nodes; those at both ends of a full turn are one
  return {through * around * along, (through + 1) * lines * (along + 1)};
}

MeshSize count(const SphereShape& sphere) {
  const auto [rings, core] = split(sphere.across);
  const double shell = 6 * core * core;  // faces of the core's surface, which has two nodes more
  return {core * core * core + shell * rings, (core + 1) * (core + 1) * (core + 1) + (shell + 2) * rings};
}

MeshSize count(const ShellPlateShape& plate) {
  const double x = plate.cells[0], y = plate.cells[1];
  return {x * y, (x + 1) * (y + 1)};
}

MeshSize count(const ShellTubeShape& tube) {
  const double around = tube.cells[0], along = tube.cells[1];
  return {around * along, (tube.arc < 360 ? around + 1 : around) * (along + 1)};
}

MeshSize count(const ShellSphereShape& sphere) {
  const double faces = 6.0 * sphere.cells * sphere.cells;
  return {faces, faces + 2};
}

MeshSize count(const ShellBoxTubeShape& tube) {
  const double around = 2.0 * (double(tube.cells[0]) + tube.cells[1]), along = tube.cells[2];
  const double x = tube.cells[0], y = tube.cells[1], plates = int(tube.has_start()) + int(tube.has_end());
  return {around * along + plates * x * y, around * (along + 1) + plates * (x - 1) * (y - 1)};
}

MeshSize count(const LineShape& line) { return {double(line.cells), double(line.cells) + 1}; }

MeshSize count(const FileMesh&) { return {}; }

}  // namespace

MeshSize count_cells(const PartDeck& part) {
  MeshSize size = std::visit([](const auto& shape) { return count(shape); }, part.shape);
  if (part.elements == PartDeck::Elements::tetrahedra)  // one of each half of a face, and a node in the middle
    size = {12 * size.elements, size.nodes + size.elements};
  if (part.elements == PartDeck::Elements::six_tetrahedra) size.elements *= 6;
  if (part.elements == PartDeck::Elements::five_tetrahedra) size.elements *= 5;
  if (part.elements == PartDeck::Elements::pyramids) size = {6 * size.elements, size.nodes + size.elements};
  if (part.elements == PartDeck::Elements::wedges) size.elements *= 2;
  if (part.array) {
    for (const int copies : part.array->count) {
      size.elements *= copies;
      size.nodes *= copies;
    }
  }
  return size;
}

}  // namespace percuss
