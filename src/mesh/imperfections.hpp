#pragma once
// Imperfections of the deck: nodes are displaced before anything else looks at the mesh.
//
// What a node gets follows from its place, its id and the deck alone, and normals of shells are added up as integers:
// every copy of a node has the same bits, on any number of ranks.

#include "src/mesh/ordering.hpp"

namespace percuss {

/// Displaces the nodes of a share by all entries of Deck::imperfections, each seeing the places without any of them.
/// Adds a line for each to Mesh::notes. Collective over ranks. Throws InputError, the same on all ranks: unknown sets,
/// values that are not finite, a normal where there are no shells.
void apply_imperfections(const Deck& deck, const Communicator& ranks, Mesh& mesh);

/// Noise from -1 to 1 at a place: random values on a grid of the spacing `length`, joined smoothly. It has no value
/// beyond 1 and is 0 on average.
double find_noise(const Vec3& at, double length, std::uint64_t seed);

/// Noise of a node on its own: independent of all others.
double find_noise(std::int64_t node_id, std::uint64_t seed);

}  // namespace percuss
