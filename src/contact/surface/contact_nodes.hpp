#pragma once
// The contact nodes that a rank owns: nodes of faces of all ranks, particles and ends of beams, each with what lies
// around it and the surfaces that it is on.

#include "comm/exchange/unstructured_exchange.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Surfaces by class, and the class of each part's: of a particle or a beam.
struct NodeSurfaces {
  const SurfaceClasses& classes;
  const std::vector<int>& of_parts;
};

/// Lists them with the faces of other ranks around them, and beams of this rank that touch. springs: [faces of the
/// share] stiffness of each [force/length]. Returns the surfaces of each node: those of all faces around it, of a
/// particle or a beam those of its parts. Collective.
std::vector<SurfaceSet> list_contact_nodes(const ChunkedMesh& chunked, const Deck& deck,
                                           const std::vector<double>& springs, const NodeSurfaces& surfaces,
                                           UnstructuredExchange& exchange, SurfaceShare& share);

/// Changes the surfaces of nodes that ties hold or have let go.
void tie_nodes(const Deck& deck, const TiedSurfaces& ties, const OwnedContactNodes& nodes,
               std::vector<SurfaceSet>& sets);

}  // namespace percuss
