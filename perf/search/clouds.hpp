#pragma once
// Contact surfaces of about as many faces as nodes, with face edges of length 1, for timing searches.

#include <array>
#include <string>
#include <vector>

namespace percuss::perf {

struct Cloud {
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::array<int, 4>> faces;
};

/// Names of clouds: a sheet folded to four layers, loose bricks of 3 x 3 x 3 elements in a wall, a sheet crumpled by
/// waves of random directions, a long square rod.
const std::vector<std::string>& cloud_names();

/// A cloud of about so many nodes.
Cloud make_cloud(const std::string& name, int num_nodes);

}  // namespace percuss::perf
