#pragma once
// What a rank holds of the contact surface in the FE decomposition: the faces of its elements, and the contact nodes
// that it owns with all faces around them, also those of other ranks. Beams that touch add nodes and edges. Const after
// set-up.

#include <cstdint>
#include <vector>

#include "comm/exchange/unstructured_exchange.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "src/contact/surface/feature_edges.hpp"
#include "src/contact/surface/surface_classes.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// A place of a deck or mesh as kernels take it.
inline Point3 to_point(const Vec3& x) { return {x[0], x[1], x[2]}; }

/// A contact face in messages between ranks.
struct FaceTopology {
  std::int64_t number = -1;   // find_face_number()
  std::int64_t corners[4]{};  // node numbers, outward by the right-hand rule
  std::int64_t backs[4]{};    // nodes of the element behind the face, opposite each corner
  int body = 0;               // connected body
  int part = 0;               // index into Mesh::parts
  int surface_class = 0;      // which of the named surfaces it lies on, as a class
  double offset = 0;          // half the thickness of a shell at time 0, 0 of a solid's face [length]
};

/// Contact nodes that this rank owns; a contact node is named by its place here, in the order of node numbers.
struct OwnedContactNodes {
  std::vector<int> mesh_nodes;        // ascending
  std::vector<std::int64_t> numbers;  // ascending
  std::vector<std::int64_t> ids;      // the user's
  std::vector<int> classes;           // as FaceTopology::surface_class
  std::vector<int> parts;             // index into Mesh::parts
  std::vector<double> sizes;          // shortest edge of the faces around each at time 0 [length]
  std::vector<double>
      springs;  // stiffness of each (kernels/contact/enforcement/springs.hpp) [force/length]; 0: its rows have none
  std::vector<int> first_face;  // [nodes + 1] into faces
  std::vector<int> faces;       // around each node, ascending number: SurfaceShare::face(); a free particle has none
  std::vector<char> searched;   // whether it may touch any face
  std::vector<double> radii;  // of the thickest beam at each, 0: of none that touches; empty: no beam of any rank does
  std::vector<int> beams;     // one at each, as a face of SurfaceShare::face(), or -1; empty likewise

  int count() const { return static_cast<int>(mesh_nodes.size()); }
};

struct SurfaceShare {
  OwnedContactNodes nodes;
  std::vector<FaceTopology> faces;  // of this rank's elements, ascending number
  std::vector<FaceTopology>
      foreign_faces;                // of others' elements at nodes of this rank; of particles and beams, number -1
  std::vector<char> face_searched;  // whether it may be touched by any node
  std::vector<std::array<int, 4>> face_corners, face_backs;  // mesh nodes of this rank
  int num_classes = 1;
  Array<const double> pair_friction;          // [class of node * num_classes + class of face]; negative: may not touch
  Array<const int> pair_number;               // likewise: which of the deck's pairs; -1: none
  std::vector<EdgeTopology> edges;            // feature edges whose home this rank is, ascending number; those searched
  std::vector<std::array<int, 2>> edge_ends;  // mesh nodes of this rank
  double edge_piece = 0;                      // longest of the pieces by which edges are searched [length]
  std::vector<double> passing_lengths;        // find_feature_edges()
  std::int64_t total_edges = 0;               // of all ranks
  std::int64_t total_nodes = 0, total_faces = 0, total_searched_faces = 0;  // of all ranks

  SurfaceClasses classes;            // what surface_class of faces, nodes and edges names
  std::vector<SurfaceSet> own_sets;  // of this rank's nodes and all ranks' faces: edges may add others

  std::vector<FoundEdge> beams;  // of this rank's elements that touch
  bool has_beams = false;        // whether some of any rank do

  double largest_offset = 0;  // of any face or node of any rank that may touch [length]; 0: no shells or beams do
  SpringRows springs = SpringRows::none;  // which contacts give way

  // For kernels over the share.
  Array<const int> node_list;       // [owned contact nodes] mesh nodes
  Array<const int> watched_list;    // mesh nodes on which places and sizes of faces depend: node_list, and behind faces
  Rows4<const int> corner_list;     // [searched faces] corners as mesh nodes
  std::vector<int> searched_faces;  // places in `faces`
  Array<const double> reach_list{};  // [searched faces] BoundedFaces::offset

  ActiveContact active{};  // by which pair_friction was found

  /// A face that OwnedContactNodes::faces names: one of `faces`, or beyond these of `foreign_faces`.
  const FaceTopology& face(int place) const {
    const auto i = static_cast<std::size_t>(place);
    return i < faces.size() ? faces[i] : foreign_faces[i - faces.size()];
  }
  BoundedFaces bounded_faces() const { return {corner_list, reach_list}; }

  /// A face around an owned node, or a beam at it; null: it is a free particle.
  const FaceTopology* find_around(std::size_t node) const {
    if (nodes.first_face[node] < nodes.first_face[node + 1])
      return &face(nodes.faces[static_cast<std::size_t>(nodes.first_face[node])]);
    return nodes.beams.empty() || nodes.beams[node] < 0 ? nullptr : &face(nodes.beams[node]);
  }
  double find_radius(std::size_t node) const { return nodes.radii.empty() ? 0 : nodes.radii[node]; }

  /// Whether anything may touch but walls.
  bool may_touch() const { return total_searched_faces > 0 || has_beams; }
};

/// Whether edges touch edges at all.
inline bool has_edge_contact(const ContactDeck& contact) {
  return contact.edges && contact.surfaces != ContactDeck::Surfaces::none;
}

/// (1.1) Define contact surface: finds that of the mesh. active: which pairs may touch. folds: of
/// find_feature_edges(). Throws InputError for unknown surfaces. Collective.
SurfaceShare build_surface_share(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                                 UnstructuredExchange& exchange, const std::vector<EdgeEnds>& folds = {},
                                 const ActiveContact& active = {});

/// Makes `share`, of the same mesh and ties, what build_surface_share() would make with other folds. Returns whether
/// all but its edges stayed as it was, as almost always. Collective.
bool change_folds(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                  UnstructuredExchange& exchange, const std::vector<EdgeEnds>& folds, SurfaceShare& share);

/// The deck's rigid walls with the owned nodes that those of them that act stop, inside bodies and on their surfaces.
/// Throws InputError, on all ranks, for unknown selections. Collective over Mesh::ranks.
WallPairs build_walls(const ChunkedMesh& chunked, const Deck& deck, const SurfaceShare& share);

}  // namespace percuss
