#pragma once
// The static decomposition of the elements (section 3 of the paper): whole chunks to ranks, equal in cost, with as few
// shared nodes as can be. METIS takes the place of the paper's CHACO.

#include <stdexcept>
#include <vector>

#include "comm/communicator.hpp"

namespace percuss {

/// METIS failed; what() says why.
class PartitionError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An undirected graph: each edge is listed at both its ends, with the same weight.
struct Graph {
  std::vector<int> first;           // [vertices + 1] into neighbours
  std::vector<int> neighbours;      // ascending at each vertex
  std::vector<int> edge_weights;    // [neighbours] what cutting the edge costs, at least 1
  std::vector<int> vertex_weights;  // [vertices] cost of the vertex, at least 1
};

/// An edge of a graph, of which there is one between two vertices.
struct GraphEdge {
  int a = 0, b = 0;  // vertices, a < b
  int weight = 1;
  friend bool operator==(const GraphEdge&, const GraphEdge&) = default;
};

/// The graph of some edges, ascending by (a, b). costs: [vertices] at least 1.
Graph build_graph(const std::vector<GraphEdge>& edges, std::vector<int> costs);

/// The part of each vertex, and the quality of the partition.
struct Partition {
  std::vector<int> parts;  // [vertices] 0 <= part < the number requested
  int empty_parts = 0;     // parts without a vertex: there are fewer vertices than parts, and the caller tells its user
  double imbalance = 1;    // cost of the heaviest part over the mean of all parts, empty ones included
  long long cut = 0;       // weight of the edges between parts
};

/// Divides the graph in parts of equal cost with a small cut. The same on every call: METIS is seeded, and its
/// imbalance is corrected greedily in a fixed order. With at most as many vertices as parts, each vertex is a part of
/// its own. Throws PartitionError; std::invalid_argument if part_count is not positive.
Partition partition_graph(const Graph& graph, int part_count);

/// partition_graph on rank 0, as many parts as ranks; all get the result, so that none depends on its own libraries.
/// graph: only that of rank 0 counts. Throws on every rank what rank 0 throws. Collective.
Partition partition_for_ranks(const Communicator& ranks, const Graph& graph);

}  // namespace percuss
