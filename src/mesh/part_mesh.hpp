#pragma once
// The mesh of one part before it joins the others, and the generators that make it. All generators work in the local
// coordinates that deck.hpp gives for each shape; place_part() turns them into those of the scene.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Nodes and hexahedra of one part; indexes are 0-based and count within the part.
struct PartMesh {
  std::vector<Vec3> nodes;                   // [length]
  std::vector<std::array<int, 8>> elements;  // corners, Exodus II HEX8 order
  std::vector<std::int64_t> node_ids;        // ids of the file; empty for a generated mesh, which counts from 1
  std::vector<std::int64_t> element_ids;     // likewise
  std::map<std::string, std::vector<int>> node_sets;          // by the name without the part's; ascending, unique
  std::map<std::string, std::vector<ElementFace>> side_sets;  // likewise; generated meshes have only these
  std::vector<std::string> warnings;
};

/// Rectangular block of cells[0] x cells[1] x cells[2] equal elements. Nodes and elements count along x first.
PartMesh make_box(const BoxShape& shape);

/// Solid cylinder: every section is a core of square topology and rings around it. The nodes of the side lie at the
/// radius; each section is symmetric to the last bit under quarter turns and under reflection in x, y and x = y.
PartMesh make_cylinder(const CylinderShape& shape);

/// Hollow cylinder; the first of the `around` node lines lies at +x. Symmetric to the last bit under reflection in x
/// (and, as far as `around` divides, in y and under quarter turns).
PartMesh make_tube(const TubeShape& shape);

/// Solid ball: a core of cube topology and shells around it. The nodes of the surface lie at the radius; symmetric to
/// the last bit under the 48 symmetries of the cube.
PartMesh make_sphere(const SphereShape& shape);

/// Copies (array), rotates and translates the part, in this order.
void place_part(PartMesh& mesh, const PartDeck& part);

}  // namespace percuss
