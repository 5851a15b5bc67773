#pragma once
// Rigid bodies as the rows of a step see them. A node of a body does not move by its own mass: all impulses on the
// body together move all its nodes.

#include <vector>

#include "kernels/core/exact_sum.hpp"
#include "kernels/rigid/body_response.hpp"

namespace percuss {

/// The bodies of the scene in this step; the same on all ranks but for of_node.
struct BodyInputs {
  int count = 0;
  Array<const int> of_node;             // [mesh nodes] body, -1: none; empty without bodies
  Array<const BodyResponse> responses;  // [count]
};

/// The bodies by the places of the rows, and what the iteration needs.
struct RowBodies {
  BodyInputs inputs;
  Array<int> of_place = Array<int>("contact::body_of_place", 0);            // [places] -1: none
  Array<int> places = Array<int>("contact::body_places", 0);                // body after body
  std::vector<int> first;                                                   // [count + 1] into places, on the host
  Array<BodyChange> change = Array<BodyChange>("contact::body_change", 0);  // of the iterate
  std::vector<Wrench> wrench;                                               // of all rows, of the iterate
  ExactSums<6> memory{"contact::body_sums"};
  // Scratch of the set-up.
  Array<int> key = Array<int>("contact::body_key", 0), index = Array<int>("contact::body_index", 0);
  Array<int> size = Array<int>("contact::body_size", 0), offset = Array<int>("contact::body_offset", 0);

  int count() const { return inputs.count; }
};

}  // namespace percuss
