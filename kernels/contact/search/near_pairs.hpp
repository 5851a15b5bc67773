#pragma once
// Candidate pairs that can come into contact soon: the others are left out of the check until surfaces have moved.
//
// A capture box is axis-aligned, wide where a face is oblique, and its margin lasts for many steps. Most candidate
// pairs are therefore out of reach of each other for long, as the two sides of a thin wall are. A node that is farther
// from a face than the reach of the check, in some direction, stays so while neither moves by more than its part of
// what is left: a guarantee, as that of capture_boxes.hpp, by a shorter way and in directions of the face's own.

#include "kernels/contact/search/pair_search.hpp"

namespace percuss {

/// Memory kept between lists.
struct NearScratch {
  ConcernedScratch concerned;
  Array<int> count = Array<int>("contact::near_count", 0);        // [contact nodes]
  Rows4<double> slabs = Rows4<double>("contact::face_slabs", 0);  // [5 faces] five rows a face
  Array<int> nearness = Array<int>("contact::nearness", 0);       // [pairs]
};

/// Limits of a list of near pairs.
struct NearLimits {
  double travel = 0;      // of any node, those behind faces too, from its place of now [length]
  double most_pairs = 0;  // of which it still is worth it
};

/// Fills `near` with the pairs of `all` that the check could accept before some node has gone farther than the travel
/// from its place at n, and with those of a node and a face that pushed it in the last step, whose place the check asks
/// for. Where thickness lets nodes with a history be deeper, pairs that come near in no other way are marked. Returns
/// whether there are at most `most_pairs`; otherwise they are not listed. inputs.faces: of update_faces() for `all`.
bool list_near_pairs(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all,
                     const NearLimits& limits, NearScratch& scratch, CandidateList& near);

}  // namespace percuss
