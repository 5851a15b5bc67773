#pragma once
// Tied surfaces (contact.ties of the deck): which nodes are tied where. Found once, in the mesh of time 0, and again
// from the same mesh after a restart: const after set-up.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "kernels/contact/geometry/tie_geometry.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// A node of side a, tied to a face of side b.
struct TiedNode {
  std::int64_t node = -1;     // number
  std::int64_t face = -1;     // number
  std::int64_t corners[4]{};  // of the face: node numbers
  int tie = 0;                // index into ContactDeck::ties
  TieGeometry geometry;
};

/// What became of the nodes of one tie's side a, on all ranks.
struct TieCounts {
  std::int64_t tied = 0;
  std::int64_t apart = 0;    // farther from the surface of side b than the tie's distance
  std::int64_t joined = 0;   // nodes of side b as well: the mesh joins them already
  std::int64_t earlier = 0;  // tied by an earlier tie
  double farthest = 0;       // largest distance of a tied node from its face [length]
  double widest = 0;         // largest part of it beyond the thickness of shells [length]
};

struct TiedSurfaces {
  std::vector<TiedNode> nodes;  // those that this rank owns, ascending
  // [ties] exterior faces of this rank, ascending: those of side a with a node in reach, and side b; of shells both
  // sides of each.
  std::vector<std::array<std::vector<ElementFace>, 2>> faces;
  std::vector<TieCounts> counts;  // [ties]

  bool any() const { return !counts.empty(); }
};

/// Share of the shortest edge of a face within which nodes are tied to it where the deck names no distance.
inline constexpr double default_tie_distance = 0.05;

/// Finds the face that is closest to each node of side a; of equals the one with the lowest number. Throws InputError,
/// on all ranks, for unknown surfaces, a surface tied to itself and a tie that ties nothing. Collective.
TiedSurfaces find_ties(const ChunkedMesh& chunked, const Deck& deck, const Communicator& ranks);

/// What is left of the ties of a mesh that is eroded: a tie goes with the element behind its face, and with the last
/// element that holds its node. Collective.
TiedSurfaces keep_living_ties(const ChunkedMesh& chunked, const TiedSurfaces& ties, const Communicator& ranks);

/// One line for each tie: how many nodes are tied, how many not, the largest offset.
std::vector<std::string> describe_ties(const Deck& deck, const TiedSurfaces& ties);

}  // namespace percuss
