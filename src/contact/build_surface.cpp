#include "src/contact/build_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "src/contact/host_copy.hpp"
#include "src/contact/surface_pairs.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// The three corners of a hexahedron that share an edge with each corner (Exodus II order).
constexpr int hex_neighbours[8][3] = {{1, 3, 4}, {0, 2, 5}, {1, 3, 6}, {0, 2, 7},
                                      {0, 5, 7}, {1, 4, 6}, {2, 5, 7}, {3, 4, 6}};

/// The corner across the element from a corner of a face.
int find_back_corner(int face, int corner) {
  const int* on_face = hex_faces[face];
  for (const int neighbour : hex_neighbours[corner])
    if (std::find(on_face, on_face + 4, neighbour) == on_face + 4) return neighbour;
  return corner;
}

/// Mesh node to contact node; -1 for interior nodes.
std::vector<int> number_contact_nodes(const Mesh& mesh, const std::vector<ElementFace>& faces,
                                      std::vector<int>& contact_nodes) {
  std::vector<int> number(mesh.nodes.size(), -1);
  for (const ElementFace& f : faces)
    for (const int corner : hex_faces[f.face])
      number[static_cast<std::size_t>(
          mesh.elements[static_cast<std::size_t>(f.element)][static_cast<std::size_t>(corner)])] = 0;
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] < 0) continue;
    number[node] = static_cast<int>(contact_nodes.size());
    contact_nodes.push_back(static_cast<int>(node));
  }
  return number;
}

/// Corners of the faces as contact nodes, and the mesh nodes behind them.
struct FaceCorners {
  std::vector<std::array<int, 4>> corners, backs;
};

FaceCorners list_corners(const Mesh& mesh, const std::vector<ElementFace>& faces, const std::vector<int>& number) {
  FaceCorners result;
  for (const ElementFace& f : faces) {
    const auto& element = mesh.elements[static_cast<std::size_t>(f.element)];
    std::array<int, 4> corners{}, backs{};
    for (std::size_t i = 0; i < 4; ++i) {
      const int corner = hex_faces[f.face][i];
      corners[i] = number[static_cast<std::size_t>(element[static_cast<std::size_t>(corner)])];
      backs[i] = element[static_cast<std::size_t>(find_back_corner(f.face, corner))];
    }
    result.corners.push_back(corners);
    result.backs.push_back(backs);
  }
  return result;
}

/// Faces around each node, ascending, as offsets and a list.
struct NodeFaces {
  std::vector<int> offset, faces;
};

NodeFaces list_node_faces(const std::vector<std::array<int, 4>>& corners, std::size_t num_nodes) {
  NodeFaces result;
  result.offset.assign(num_nodes + 1, 0);
  for (const auto& face : corners)
    for (const int node : face) ++result.offset[static_cast<std::size_t>(node) + 1];
  for (std::size_t n = 0; n < num_nodes; ++n) result.offset[n + 1] += result.offset[n];
  std::vector<int> next(result.offset.begin(), result.offset.end() - 1);
  result.faces.resize(static_cast<std::size_t>(result.offset.back()));
  for (std::size_t f = 0; f < corners.size(); ++f)
    for (const int node : corners[f])
      result.faces[static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++)] = static_cast<int>(f);
  return result;
}

/// Items whose class may touch some class.
std::vector<int> list_searched(const std::vector<int>& item_class, const std::vector<bool>& class_searched) {
  std::vector<int> searched;
  for (std::size_t i = 0; i < item_class.size(); ++i)
    if (class_searched[static_cast<std::size_t>(item_class[i])]) searched.push_back(static_cast<int>(i));
  return searched;
}

void set_pairs(const SurfacePairs& pairs, ContactSurface& surface) {
  const auto n = static_cast<std::size_t>(pairs.num_classes);
  std::vector<bool> nodes(n, false), faces(n, false);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (pairs.friction[a * n + b] >= 0) nodes[a] = faces[b] = true;
  surface.num_classes = pairs.num_classes;
  surface.node_class = copy_to_array("contact::node_class", pairs.node_class);
  surface.face_class = copy_to_array("contact::face_class", pairs.face_class);
  surface.pair_friction = copy_to_array("contact::pair_friction", pairs.friction);
  surface.searched_nodes = copy_to_array("contact::searched_nodes", list_searched(pairs.node_class, nodes));
  surface.searched_faces = copy_to_array("contact::searched_faces", list_searched(pairs.face_class, faces));
}

void set_bodies(const Mesh& mesh, const std::vector<ElementFace>& faces, const NodeFaces& node_faces,
                ContactSurface& surface) {
  const std::vector<int> element_body = find_bodies(mesh);
  std::vector<int> face_body, node_body;
  for (const ElementFace& f : faces) face_body.push_back(element_body[static_cast<std::size_t>(f.element)]);
  for (std::size_t n = 0; n + 1 < node_faces.offset.size(); ++n) {
    const int face = node_faces.faces[static_cast<std::size_t>(node_faces.offset[n])];
    node_body.push_back(face_body[static_cast<std::size_t>(face)]);
  }
  surface.face_body = copy_to_array("contact::face_body", face_body);
  surface.node_body = copy_to_array("contact::node_body", node_body);
}

}  // namespace

ContactSurface build_surface(const Mesh& mesh, const Deck& deck) {
  const std::vector<ElementFace> faces = find_exterior_faces(mesh);
  std::vector<int> contact_nodes;
  const std::vector<int> number = number_contact_nodes(mesh, faces, contact_nodes);
  const FaceCorners corners = list_corners(mesh, faces, number);
  const NodeFaces node_faces = list_node_faces(corners.corners, contact_nodes.size());
  ContactSurface surface;
  surface.num_nodes = static_cast<int>(contact_nodes.size());
  surface.num_faces = static_cast<int>(faces.size());
  surface.nodes = copy_to_array("contact::nodes", contact_nodes);
  surface.nodes_to_faces_offset = copy_to_array("contact::nodes_to_faces_offset", node_faces.offset);
  surface.nodes_to_faces = copy_to_array("contact::nodes_to_faces", node_faces.faces);
  surface.face_corners = copy_to_rows("contact::face_corners", corners.corners);
  surface.face_backs = copy_to_rows("contact::face_backs", corners.backs);
  set_bodies(mesh, faces, node_faces, surface);
  set_pairs(find_surface_pairs(mesh, deck, faces, corners.corners, contact_nodes.size()), surface);
  return surface;
}

}  // namespace percuss
