#pragma once
// The thickness of shells in contact: by how much the surface that is touched lies off the faces of the mesh.
//
// A shell gives two faces to the contact surface, its bottom and its top, with the same corners: its mid-surface. They
// are touched half a thickness away from it, and a node of shells touches with half its own thickness, so that a pair
// keeps the sum of both as its distance. For that the corners of a face are moved outward along directions that
// neighbours on one side of a surface share: the moved faces leave no cracks, whatever the curvature, and on each side
// lie as far from the mid-surface as they should. On this moved face the check is that of solids.

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// Whether a check looks at thickness: scenes without shells do not pay for it.
enum class Thickness { none, of_shells };

/// Thickness on a contact surface; a scene without shells has none.
struct SurfaceOffsets {
  double largest = 0;           // of any node of the scene [length]; 0: no shells, and nothing below
  Array<const double> face;     // [faces] half the thickness of a shell, 0 of a solid's face [length]
  Array<const double> node;     // [contact nodes] half the thickness of the thickest shell around it, 0: none
  Array<const int> ring_first;  // [4 faces + 1] into `ring`, by face and corner
  Array<const int> ring;        // the other faces around a corner that lie on the same side of the surface
  Array<const int> is_open;     // [4 faces] 1: the shell ends at the corner
};

/// Where a face lies along its normal at the predicted place, by its first corner: a look at these numbers rules out
/// nearly all pairs of a shell with itself.
template <class T>
struct FaceSlabOf {
  Vector3<T> origin{}, move{};    // place of the first corner at n and its displacement over the step
  T low_start{0}, high_start{0};  // least and greatest height of a corner at n
  T low_end{0}, high_end{0};      // and at the predicted place
  Vector3<T> normal_at_start{};   // outward unit normal at n
  T turn{0};                      // bound of what its turning raises or lowers moved corners by / offset
};
using FaceSlab = FaceSlabOf<double>;

/// No corner is moved by more than this times the offset: mitred at edges of up to a right angle, and by as much along
/// the face as away from it where a shell ends.
inline constexpr double longest_mitre = 1.4142135623730952;

/// The distance that a node and a face keep [length].
KOKKOS_INLINE_FUNCTION double find_offset(const SurfaceOffsets& offsets, int node, int face) {
  return offsets.largest > 0 ? offsets.node(node) + offsets.face(face) : 0;
}

/// Half the thickness of a node, and whether it is one of shells.
KOKKOS_INLINE_FUNCTION double find_node_offset(const SurfaceOffsets& offsets, int node) {
  return offsets.largest > 0 ? offsets.node(node) : 0;
}

/// Half the thickness of a face: 0 of solids.
KOKKOS_INLINE_FUNCTION double find_face_offset(const SurfaceOffsets& offsets, int face) {
  return offsets.largest > 0 ? offsets.face(face) : 0;
}

/// How far from a face of this offset any point of it moved outward for any node can be. largest: of any node.
KOKKOS_INLINE_FUNCTION double find_offset_reach(double face_offset, double largest) {
  return largest > 0 ? longest_mitre * (face_offset + largest) : 0;
}

/// The part along a face of the direction in which its corner is moved outward, as of a mitre. own: normal of the face;
/// sum: of the normals around the corner.
KOKKOS_INLINE_FUNCTION Point3 find_mitre(const Point3& own, const Point3& sum) {
  const double along = dot(sum, own);
  const Point3 across = sum - along * own;
  const double square = dot(across, across);
  if (!(square > 0)) return {};
  // A root is taken where it may be the larger.
  constexpr double clearly = 1.001;
  if (along > 0 && along * along > clearly * square) return (1 / along) * across;
  const double length = std::sqrt(square);
  return (along > length ? 1 / along : 1 / length) * across;
}

/// The direction in which a corner is moved outward: its part along the normal `own` is 1, so that a flat face stays
/// parallel to itself, that along the face at most 1.
KOKKOS_INLINE_FUNCTION Point3 find_outward(const Point3& own, const Point3& along_face) {
  const double square = dot(along_face, along_face);
  if (square <= 1) return own + along_face;
  const double length = std::sqrt(square);
  return own + (length > 1 ? 1 / length : 1) * along_face;
}

}  // namespace percuss
