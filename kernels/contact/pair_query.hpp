#pragma once
// What a search for pairs of points and boxes is asked, and the list that it answers with.

#include "kernels/contact/contact_state.hpp"
#include "kernels/contact/edge_surface.hpp"

namespace percuss {

/// Candidate pairs by node, faces ascending: the pair list sorted by (node, face).
struct CandidateList {
  int num_pairs = 0;
  int num_nodes = 0;                                               // nodes with candidates
  int num_faces = 0;                                               // faces whose geometry the detailed check reads
  Array<int> offset = Array<int>("contact::candidate_offset", 0);  // [contact nodes + 1]
  Array<int> face = Array<int>("contact::candidate_face", 0);      // [pairs]
  Array<int> nodes = Array<int>("contact::candidate_nodes", 0);    // [num_nodes] contact nodes, ascending
  Array<int> faces = Array<int>("contact::candidate_faces", 0);    // [num_faces] ascending
};

/// Points and boxes by the names that hits give them.
struct PointQuery {
  Rows3<const double> x;
  Array<const int> points;       // rows of x
  Array<const int> point_names;  // [points], no name twice
  Array<const int> box_names;    // [boxes]
  int num_names = 0;             // of points
};

/// Which nodes make pairs with which faces.
struct NodeFaceRule {
  ContactSurface surface;

  KOKKOS_INLINE_FUNCTION bool operator()(int node, int face) const {
    return find_friction(surface, node, face) >= 0 && !shares_element(surface, node, face);
  }
};

}  // namespace percuss
