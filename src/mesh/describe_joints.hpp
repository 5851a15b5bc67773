#pragma once
// What parts have in common, in words.

#include <string>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// "'rail' and 'plate' share 25 nodes (merged from up to 1e-9 apart)", a pair of parts each; of many the first ones.
std::vector<std::string> describe_joints(const Mesh& mesh);

}  // namespace percuss
