#pragma once
// The contact surface as search and detailed check see it: nodes, faces, how they are connected, and who may touch
// whom.
//
// On one rank the whole surface of the scene; on several, in the contact decomposition, what concerns the nodes that a
// rank owns there. A contact node is named by its place in `nodes`, a contact face by its place in `face_corners`, both
// in the order of their global numbers, so that every choice by order is the same on any rank.

#include "kernels/contact/surface/surface_offsets.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

struct ContactSurface {
  int num_nodes = 0;
  int num_faces = 0;
  Array<const int> nodes;                  // [contact nodes] mesh node
  Array<const int> nodes_to_faces_offset;  // [contact nodes + 1]
  Array<const int> nodes_to_faces;         // faces that hold the node, ascending
  Rows4<const int> face_corners;           // [faces][4] contact nodes, outward by the right-hand rule
  // [faces][4] mesh nodes of the element behind the face, opposite each corner, of a shell these themselves; -1: not
  // here, for no node here has the face for a candidate
  Rows4<const int> face_backs;
  Array<const int> node_body;   // [contact nodes] connected body
  Array<const int> face_body;   // [faces] connected body
  Array<const int> node_class;  // [contact nodes] which of the named surfaces it lies on, as a class
  Array<const int> face_class;  // [faces] likewise
  int num_classes = 1;
  Array<const int> searched_nodes;    // contact nodes that may touch some face, ascending
  Array<const int> searched_faces;    // faces that may touch some node, ascending
  Array<const double> pair_friction;  // [classes of nodes * classes of faces] friction; negative: may not touch
  Array<const int> pair_number;       // likewise: which of the deck's pairs
  SurfaceOffsets offsets;             // the thickness of shells
};

/// Coulomb friction between a node and a face, negative if the pair may not touch.
KOKKOS_INLINE_FUNCTION double find_friction(const ContactSurface& surface, int node, int face) {
  return surface.pair_friction(surface.node_class(node) * surface.num_classes + surface.face_class(face));
}

/// The pair of the deck that lets a node touch a face.
KOKKOS_INLINE_FUNCTION int find_pair(const ContactSurface& surface, int node, int face) {
  return surface.pair_number(surface.node_class(node) * surface.num_classes + surface.face_class(face));
}

/// Whether the face holds the node or belongs to an element of which the node is a corner opposite the face.
KOKKOS_INLINE_FUNCTION bool shares_element(const ContactSurface& surface, int node, int face) {
  const int mesh_node = surface.nodes(node);
  for (int i = 0; i < 4; ++i)
    if (surface.face_corners(face, i) == node || surface.face_backs(face, i) == mesh_node) return true;
  return false;
}

/// Whether two faces have a corner in common.
KOKKOS_INLINE_FUNCTION bool share_corner(const ContactSurface& surface, int a, int b) {
  int shared = 0;  // without an unpredictable branch
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) shared |= surface.face_corners(a, i) == surface.face_corners(b, j) ? 1 : 0;
  return shared != 0;
}

}  // namespace percuss
