#pragma once
// What the tests of meshes measure: volumes by an independent rule, worst shapes, decks of a few parts.

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/mesh.hpp"
#include "src/mesh/part_mesh.hpp"
#include "src/mesh/shapes/shape_source.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::testing_mesh {

inline PartDeck make_part_deck(std::string name, Shape shape) {
  PartDeck part;
  part.name = std::move(name);
  part.shape = std::move(shape);
  part.material = "steel";
  part.place = {3, 5};
  return part;
}

inline Deck make_deck(std::vector<PartDeck> parts) {
  Deck deck;
  deck.file = "deck.yaml";
  deck.parts = std::move(parts);
  deck.materials.push_back({"steel", 7850, {}, {}, {}, {}, {}});
  return deck;
}

/// A generated shape, all of it.
inline PartMesh make_part_mesh(const Shape& shape) {
  const std::unique_ptr<ShapeSource> source = make_source(shape);
  const std::vector<std::string> names = side_names(shape);
  PartMesh mesh;
  mesh.elements.blocks.resize(1);
  mesh.elements.blocks[0].topology = source->topology();
  for (int n = 0; n < source->node_count(); ++n) mesh.nodes.push_back(source->place(n));
  for (int e = 0; e < source->element_count(); ++e) {
    mesh.elements.add(0, source->corners(e));
    const ShapeSource::FaceSides sides = source->face_sides(e);
    for (int f = 0; f < static_cast<int>(most_faces); ++f) {
      const int side = sides[static_cast<std::size_t>(f)];
      if (side != ShapeSource::interior) mesh.side_sets[names[static_cast<std::size_t>(side)]].push_back({e, f});
    }
  }
  return mesh;
}

template <class AnyMesh>
ElementCorners corners_of(const AnyMesh& mesh, std::size_t element) {
  return gather_corners(mesh.elements, element, mesh.nodes);
}

/// Volume by 2 x 2 x 2 Gauss points: exact for the trilinear map, and nothing that the code under test uses.
inline double gauss_volume(const ElementCorners& x) {
  constexpr double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  const double g = 1 / std::sqrt(3.0);
  double volume = 0;
  for (const auto& at : sign) {
    std::array<Vec3, 3> jacobian{};
    for (std::size_t n = 0; n < 8; ++n) {
      for (std::size_t d = 0; d < 3; ++d) {
        double slope = sign[n][d] / 8;
        for (std::size_t o = 0; o < 3; ++o) {
          if (o != d) slope *= 1 + sign[n][o] * at[o] * g;
        }
        for (std::size_t i = 0; i < 3; ++i) jacobian[d][i] += slope * x[n][i];
      }
    }
    volume += triple_product(jacobian[0], jacobian[1], jacobian[2]);
  }
  return volume;
}

template <class AnyMesh>
double total_volume(const AnyMesh& mesh) {
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) volume += gauss_volume(corners_of(mesh, e));
  return volume;
}

/// Volume as the mesh itself finds it, for elements of any kind.
inline double own_volume(const Mesh& mesh) {
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) volume += find_element_volume(mesh, e);
  return volume;
}

/// The mesh of a deck whose one part is this file.
inline Mesh read_mesh_text(const std::string& text, const std::string& name) {
  const std::string path = write_bytes(text, name);
  Mesh mesh = build_mesh(make_deck({make_part_deck("p", FileMesh{path, {}, 1, false})}));
  std::remove(path.c_str());
  return mesh;
}

/// Least corner Jacobian over the product of its edges; 1 for a brick.
template <class AnyMesh>
double worst_scaled_jacobian(const AnyMesh& mesh) {
  double worst = 1;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (int c = 0; c < 8; ++c) {
      const CornerJacobian jacobian = find_corner_jacobian(hex8_topology, corners_of(mesh, e), c);
      worst = std::min(worst, jacobian.value / jacobian.edge_product);
    }
  }
  return worst;
}

/// The places of the nodes, to compare meshes whatever their numbering. -0 counts as 0.
inline std::vector<Vec3> sorted_places(std::vector<Vec3> nodes) {
  for (Vec3& x : nodes) {
    for (double& c : x) c += 0.0;
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Places after a map of coordinates.
template <class Map>
std::vector<Vec3> mapped_places(std::vector<Vec3> nodes, const Map& map) {
  for (Vec3& x : nodes) x = map(x);
  return sorted_places(std::move(nodes));
}

template <class AnyMesh>
std::vector<ElementFace> join_side_sets(const AnyMesh& mesh) {
  std::vector<ElementFace> all;
  for (const auto& [name, faces] : mesh.side_sets) all.insert(all.end(), faces.begin(), faces.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace percuss::testing_mesh
