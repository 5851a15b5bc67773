#pragma once
// Tied surfaces (contact.ties of the deck): which nodes are tied where. Found once, in the mesh of time 0, and again
// from the same mesh after a restart: const after set-up.

#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

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
