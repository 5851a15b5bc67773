#pragma once
// What search and check find of a scene at its start, on one process: pairs of nodes and faces and of edges, those of
// them that are near, and those that touch.

#include <array>
#include <vector>

#include "src/contact/check/check_space.hpp"
#include "src/contact/check/edge_space.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Faces of each contact node, as places in SurfaceShare::faces.
struct FacesOfNodes {
  std::vector<int> first, face;  // [contact nodes + 1], [pairs]

  bool has(int node) const { return first[static_cast<std::size_t>(node)] < first[static_cast<std::size_t>(node) + 1]; }
};

/// Pairs of edges, as places in SurfaceShare::edges.
using PairsOfEdges = std::vector<std::array<int, 2>>;

struct StartPairs {
  double margin = 0;            // by which capture boxes are wider than they must be [length]
  double steps_per_list = 1;    // for which a list of near pairs serves
  bool lists_near = false;      // whether near pairs are listed
  FacesOfNodes all, reachable;  // of the search; of these, what can come near before the next one
  FacesOfNodes near;            // of these, what can before the next list
  PairsOfEdges edges, near_edges;
  std::vector<EdgeTopology> divided_edges;         // SurfaceShare::edges, in pieces of the start
  std::vector<std::array<double, 6>> boxes;        // [searched faces] capture boxes: lowest x, y, z, highest x, y, z
  std::vector<std::array<double, 6>> edge_boxes;   // [edges] likewise
  std::vector<std::array<double, 3>> edge_points;  // of the pieces of each edge, one edge after the other
  std::vector<std::array<int, 2>> touches;         // contact node, face
  PairsOfEdges edge_touches;
};

/// motion: at the start, of the mesh nodes. steps_per_search: until candidate pairs are searched again. Throws RunError
/// if candidate pairs are absurdly many.
StartPairs find_start_pairs(const Deck& deck, const SurfaceShare& share, const SurfaceMotion& motion,
                            double steps_per_search);

/// Mesh nodes that have rows of walls at the start, once for each wall. motion: as above.
std::vector<int> find_walled_nodes(const ChunkedMesh& whole, const Deck& deck, const SurfaceShare& share,
                                   const SurfaceMotion& motion);

}  // namespace percuss
