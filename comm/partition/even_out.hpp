#pragma once
// Corrects the balance of a partition: METIS trades it against the cut, and with few vertices a part it leaves parts
// empty or far too heavy. Both functions are greedy and take ties in ascending order, so they are deterministic.

#include <vector>

#include "comm/partition/graph_partition.hpp"

namespace percuss {

/// A partition is even enough when its heaviest part costs at most this times the mean.
inline constexpr double even_enough = 1.02;

/// Gives each empty part the vertex of the heaviest part of several vertices that adds least to the cut.
/// assignment: [vertices] part of each, in and out; at least as many vertices as parts.
void fill_empty_parts(const Graph& graph, int part_count, std::vector<int>& assignment);

/// Moves vertices out of the heaviest part while that makes it lighter, cheapest for the cut first, until the parts are
/// even enough or no single move helps. assignment: [vertices] in and out.
void even_out(const Graph& graph, int part_count, std::vector<int>& assignment);

}  // namespace percuss
