#pragma once
// The smallest gap between each two parts that lie within reach of each other at the start.

#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// The gap between two parts, or two bodies of one part: from a contact node to the closest face.
struct PartGap {
  int part = 0, other = 0;  // part <= other
  double gap = 0;           // [length]; 0: they touch
};

/// Of the candidate pairs, by (part, other). face_part: [faces]. motion: with dt = 0.
std::vector<PartGap> measure_gaps(const SurfaceMotion& motion, CheckSpace& check, const std::vector<int>& face_part);

/// The smallest of all ranks, by (part, other), on each. Collective.
std::vector<PartGap> gather_gaps(const Communicator& ranks, const std::vector<PartGap>& own);

/// "smallest gaps: 0.002 from 'a' to 'b', ...", smallest first, a few of them; empty if there are none.
std::string describe_gaps(std::vector<PartGap> gaps, const Mesh& mesh);

}  // namespace percuss
