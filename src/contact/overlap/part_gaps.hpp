#pragma once
// The smallest gap between each two parts that lie within reach of each other at the start.

#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// The smallest of all ranks, by (part, other), on each. Collective.
std::vector<PartGap> gather_gaps(const Communicator& ranks, const std::vector<PartGap>& own);

/// "smallest gaps: 0.002 from 'a' to 'b', ...", smallest first, a few of them; empty if there are none.
std::string describe_gaps(std::vector<PartGap> gaps, const Mesh& mesh);

}  // namespace percuss
