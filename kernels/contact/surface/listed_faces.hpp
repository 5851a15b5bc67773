#pragma once
// Faces of a list, one a lane: for kernels that measure every one of them.

#include "kernels/contact/geometry/packed_point.hpp"
#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

/// Faces of a list; lanes to spare have the first of them once more.
struct ListedFaces {
  static constexpr int lanes = packed_lanes;
  int count = 0;  // faces
  int face[lanes];
  bool is_candidate[lanes];  // others are no candidates: only their normals are read
  bool any_candidate = false;
  int corner[4][lanes];  // mesh nodes

  static int count_packs(int faces) { return (faces + lanes - 1) / lanes; }

  /// The faces of this pack of the first `num_faces` of a list.
  KOKKOS_INLINE_FUNCTION ListedFaces(const ContactSurface& surface, const Array<const int>& list,
                                     const Array<const int>& candidates, int pack, int num_faces) {
    const int first = pack * lanes;
    count = num_faces - first < lanes ? num_faces - first : lanes;
    for (int lane = 0; lane < lanes; ++lane) {
      const int i = lane < count ? first + lane : first;
      face[lane] = list(i);
      is_candidate[lane] = candidates(i) != 0;
      any_candidate = any_candidate || is_candidate[lane];
      for (int k = 0; k < 4; ++k) corner[k][lane] = surface.nodes(surface.face_corners(face[lane], k));
    }
  }
};

/// Rows of node data at the corners.
PERCUSS_FORCE_INLINE FaceOf<Packed> load_corners(const Rows3<const double>& rows, const int (&node)[4][packed_lanes]) {
  FaceOf<Packed> face;
  for (int k = 0; k < 4; ++k) face.corner[k] = load_points(rows, node[k]);
  return face;
}

/// Corners relative to the first one.
PERCUSS_FORCE_INLINE FaceOf<Packed> find_relative(const FaceOf<Packed>& face) {
  FaceOf<Packed> relative;
  for (int k = 0; k < 4; ++k) relative.corner[k] = face.corner[k] - face.corner[0];
  return relative;
}

}  // namespace percuss
