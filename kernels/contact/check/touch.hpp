#pragma once
// What the detailed check finds. How it finds it is in pair_check.hpp and node_check.hpp, which few need.

#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/point3.hpp"

namespace percuss {

/// One node on one face, begun by start_touch(). Without initial values: lists of them are made for every node.
struct Touch {
  int face;
  int record;       // history slot of the node (0 to 2) that this contact continues; -1: new
  bool same_face;   // the record is of this very face
  bool opposed;     // whether some face of the node looks against this one
  bool beside;      // behind the face since the start, but beside it then: it came in through another face
  bool owes_start;  // gap_start is still to be found: nothing but the row of an obeyed touch asks for it
  float offset;     // distance that the node keeps from the face of the mesh by thickness, for limits
  double weight[4];
  Point3 normal;        // push direction of the node
  Point3 gap_gradient;  // how the gap changes with the place of the node; its part along the push direction is 1
  double gap_start;     // distance along the normal at n, negative behind the face [length]; see owes_start
  double gap_end;       // the same at the predicted place
  double off;           // distance beside the face
  double tau;           // when a new contact begins, share of the step; 0: touching since the start
  double size;          // h of the face
};

KOKKOS_INLINE_FUNCTION void start_touch(int face, double size, double offset, Touch& touch) {
  touch.face = face;
  touch.record = -1;
  touch.opposed = true;
  touch.same_face = touch.beside = touch.owes_start = false;
  touch.offset = static_cast<float>(offset);
  touch.gap_start = touch.gap_end = touch.off = touch.tau = 0;
  touch.size = size;
}

/// Up to three touches that the node obeys.
struct NodeTouches {
  int count = 0;
  Touch touch[contact_limits::max_touches];
};

}  // namespace percuss
