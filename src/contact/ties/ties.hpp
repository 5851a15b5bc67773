#pragma once
// Tied surfaces (contact.ties of the deck): which nodes are tied where. Those of the start are found in the mesh of
// time 0, and again from the same mesh after a restart; late_ties.hpp has the others.

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

/// Where the nodes of a mesh are at a moment.
struct TieScene {
  const ChunkedMesh& chunked;
  const Deck& deck;
  const Communicator& ranks;
  const std::vector<Vec3>& places;  // [mesh nodes]
};

/// Ties the nodes of tie t of the deck there, as find_ties() does at the start. Collective.
void add_tied_nodes(const TieScene& scene, std::size_t t, TiedSurfaces& ties);

/// Ties some nodes of its side a alone, which this rank owns; ascending numbers. Collective.
void stick_nodes(const TieScene& scene, std::size_t t, const std::vector<std::int64_t>& numbers, TiedSurfaces& ties);

/// Faces of this rank on both sides of tie t, from the mesh as it is: those of side a that have a node of `tied`, which
/// are numbers, ascending; and side b. Of shells both sides of each. Collective.
std::array<std::vector<ElementFace>, 2> list_tied_faces(const TieScene& scene, std::size_t t,
                                                        const std::vector<std::int64_t>& tied);

/// Ties that remain on an eroded mesh: a tie is removed with the element behind its face, and with the last element
/// that holds its node. Collective.
TiedSurfaces keep_living_ties(const ChunkedMesh& chunked, const TiedSurfaces& ties, const Communicator& ranks);

/// How many nodes are tied, how many not, the largest offset.
std::string describe_tie(const Deck& deck, const TiedSurfaces& ties, std::size_t t);

/// One line for each tie, of what is known of it at the start.
std::vector<std::string> describe_ties(const Deck& deck, const TiedSurfaces& ties);

}  // namespace percuss
