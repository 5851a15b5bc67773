#pragma once
// The area of the tied surface that each of its nodes holds at the start.

#include <cstdint>
#include <vector>

#include "src/contact/ties/ties.hpp"

namespace percuss {

/// [numbers] of nodes that this rank owns, ascending. Of ties that can fail and begin with the run; each is added up in
/// the order of its faces. Collective.
std::vector<double> sum_tie_areas(const TieScene& scene, const TiedSurfaces& ties,
                                  const std::vector<std::int64_t>& numbers);

}  // namespace percuss
