#pragma once
// The contact nodes that a rank owns: nodes of faces of all ranks, particles and ends of beams, each with what lies
// around it and the surfaces that it is on.

#include <vector>

#include "comm/exchange/unstructured_exchange.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Surfaces by class, and the class of the surfaces of each part: those of its particles and beams.
struct NamedSurfaces {
  const SurfaceClasses& classes;
  const std::vector<int>& of_parts;
};

/// Lists the nodes with the faces of other ranks around them, and beams of this rank that touch. springs: [faces of the
/// share] stiffness of each [force/length]. Returns the surfaces of each node: those of all faces around it, of a
/// particle or a beam those of its parts. Collective.
std::vector<SurfaceSet> list_contact_nodes(const ChunkedMesh& chunked, const Deck& deck,
                                           const std::vector<double>& springs, const NamedSurfaces& surfaces,
                                           UnstructuredExchange& exchange, SurfaceShare& share);

/// Changes `sets`, the surfaces of each node, where ties hold nodes or have let them go.
void adjust_for_ties(const Deck& deck, const TiedSurfaces& ties, const OwnedContactNodes& nodes,
                     std::vector<SurfaceSet>& sets);

}  // namespace percuss
