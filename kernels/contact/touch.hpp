#pragma once
// What the detailed check finds. How it finds it is in pair_check.hpp and node_check.hpp, which few need.

#include "kernels/contact/contact_limits.hpp"
#include "kernels/contact/point3.hpp"

namespace percuss {

/// One node on one face.
struct Touch {
  int face = -1;
  int record = -1;          // history slot of the node (0 to 2) that this contact continues; -1: new
  bool same_face = false;   // the record is of this very face
  bool opposed = true;      // whether some face of the node looks against this one
  bool beside = false;      // behind the face since the start, but beside it then: it came in through another face
  bool owes_start = false;  // gap_start is still to be found: nothing but the row of an obeyed touch asks for it
  float offset = 0;         // distance that the node keeps from the face of the mesh by thickness, for limits
  double weight[4] = {0, 0, 0, 0};
  Point3 normal{};        // push direction of the node
  Point3 gap_gradient{};  // how the gap changes with the place of the node; its part along the push direction is 1
  double gap_start = 0;   // distance along the normal at n, negative behind the face [length]; see owes_start
  double gap_end = 0;     // the same at the predicted place
  double off = 0;         // distance beside the face
  double tau = 0;         // when a new contact begins, share of the step; 0: touching since the start
  double size = 0;        // h of the face
};

/// Up to three touches that the node obeys.
struct NodeTouches {
  int count = 0;
  Touch touch[contact_limits::max_touches];
};

}  // namespace percuss
