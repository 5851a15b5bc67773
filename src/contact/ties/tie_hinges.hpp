#pragma once
// Rows of shell nodes that a tie holds in place and lets turn: hinges, where a clamp may be meant.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// A row of tied nodes on a straight line, each of which shares a shell with another.
struct TieHinge {
  int tie = 0;             // index into ContactDeck::ties
  std::int64_t nodes = 0;  // of the row
  std::int64_t first = 0;  // the user's ids of the nodes at its ends
  std::int64_t last = 0;
};

/// The hinges of ties without rotations, by tie, then along the mesh: rows of which nothing else holds a rotation about
/// their line, be it a condition, a rigid body, a tie with rotations, or another row of the same body in the tie. The
/// same on all ranks. Collective.
std::vector<TieHinge> find_tie_hinges(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                                      const Communicator& ranks);

}  // namespace percuss
