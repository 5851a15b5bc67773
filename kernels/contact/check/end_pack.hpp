#pragma once
// Push directions and gaps of a node on its candidate faces, one face a lane, each to the bits of one pair
// (pair_check.hpp).

#include "kernels/contact/surface/face_pack.hpp"

namespace percuss {

/// A face that looks away from the push direction by more than this cosine is seen along the push direction itself: no
/// gap is more than 1 / least_push_cosine times the distance.
inline constexpr double least_push_cosine = 0.5;

/// measure_distance() of faces at their closest points along push directions.
KOKKOS_FORCEINLINE_FUNCTION Packed measure_distances(const CornerPack& face, const ClosestPack& closest,
                                                     const PackedPoint& push) {
  const auto weighted = [&](int i) { return load_pack(closest.weight[i]) * load_point(face.of[i]); };
  const PackedPoint place = (weighted(0) + weighted(1)) + (weighted(2) + weighted(3));
  const PackedPoint normal = load_point(closest.normal);
  const Packed cosine = dot(normal, push);
  const auto is_facing = cosine > Packed(least_push_cosine);
  const Packed scale = Packed(1) / select(is_facing, cosine, Packed(1));
  return -dot(select_point(is_facing, scale * normal, push), place);
}

/// Vertex normals of a face at the corners that have a weight; at others anything that is finite.
KOKKOS_INLINE_FUNCTION CornerDirections find_directions(const ContactSurface& surface, const FaceState& faces, int face,
                                                        const double weight[4]) {
  if (faces.has_prepared(face)) return faces.vertex(face);
  return find_vertex_normals(surface, faces, face, [weight](int i) { return weight[i] != 0; });
}

/// Push directions and predicted gaps at the closest points of those faces whose vertex normals are set.
struct alignas(64) EndPack {
  static constexpr int lanes = packed_lanes;
  CornerPack vertex;  // vertex normals; of other lanes anything
  double normal[3][lanes], gap[lanes];

  KOKKOS_INLINE_FUNCTION void set(const MovingSurface& moving, int face, const FacePoint& closest, int lane) {
    const CornerDirections normals = find_directions(moving.surface, moving.faces, face, closest.weight);
    for (int i = 0; i < 4; ++i) vertex.set(lane, i, normals.of[i]);
  }

  KOKKOS_FORCEINLINE_FUNCTION void measure(const CornerPack& end, const ClosestPack& closest) {
    PackedPoint sum{Packed(0), Packed(0), Packed(0)};
    for (int i = 0; i < 4; ++i) sum = sum + load_pack(closest.weight[i]) * load_point(vertex.of[i]);
    const PackedPoint push = normalize(sum);
    store_point(normal, push);
    store_pack(gap, measure_distances(end, closest, push));
  }
};

}  // namespace percuss
