#pragma once
// Gaps at n of touches that were accepted without them (Touch::owes_start), of several nodes together: one touch a
// lane, each to the bits of measure_start() (pair_check.hpp).

#include "kernels/contact/check/node_check.hpp"

namespace percuss {

template <Thickness thickness>
struct OwedStarts {
  int count = 0;
  CornerPack start{};
  alignas(64) double push[3][CornerPack::lanes] = {};
  Touch* touch[CornerPack::lanes];

  /// Takes what the touches of a node owe. They must stay where they are until it is settled.
  KOKKOS_INLINE_FUNCTION void add(const MovingSurface& moving, int node, NodeTouches& touches) {
    for (int i = 0; i < touches.count; ++i) {
      if (!touches.touch[i].owes_start) continue;
      add_touch(moving, node, touches.touch[i]);
      if (count == CornerPack::lanes) settle();
    }
  }

  KOKKOS_INLINE_FUNCTION void settle() {
    if (count == 0) return;
    ClosestPack closest;
    find_closest_points(start, closest);
    const LaneValues gaps(measure_distances(start, closest, load_point(push)));
    for (int lane = 0; lane < count; ++lane) {
      touch[lane]->gap_start = gaps[lane];
      touch[lane]->owes_start = false;
    }
    count = 0;
  }

 private:
  KOKKOS_INLINE_FUNCTION void add_touch(const MovingSurface& moving, int node, Touch& owing) {
    const int lane = count++;
    const Point3 x = load_row(moving.motion.x, moving.surface.nodes(node));
    if constexpr (thickness == Thickness::of_shells) {
      const Point3 v = load_row(moving.motion.v, moving.surface.nodes(node));
      const double offset = find_offset(moving.surface.offsets, node, owing.face);
      const RelativeFace face = load_touched_face(moving, x, v, owing.face, offset);
      for (int i = 0; i < 4; ++i) start.set(lane, i, face.start.corner[i]);
    } else {
      for (int i = 0; i < 4; ++i) {
        const int corner = moving.surface.nodes(moving.surface.face_corners(owing.face, i));
        start.set(lane, i, load_row(moving.motion.x, corner) - x);
      }
    }
    push[0][lane] = owing.normal.x;
    push[1][lane] = owing.normal.y;
    push[2][lane] = owing.normal.z;
    touch[lane] = &owing;
  }
};

}  // namespace percuss
