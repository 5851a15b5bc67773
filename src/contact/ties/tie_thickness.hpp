#pragma once
// The thickness of shells between tied surfaces: what is in reach is decided by the gap between surfaces, not between
// the meshes.

#include <vector>

#include "comm/exchange/item_exchange.hpp"
#include "src/contact/ties/tie_search.hpp"
#include "src/mesh/ordering.hpp"
#include "src/mesh/surface_nodes.hpp"

namespace percuss {

/// Half the thickness of a shell, 0 of a solid's face [length].
double find_half_thickness(const Mesh& mesh, const ElementFace& face);

/// Half the thickness of any shell of the scene [length], the same on all ranks; 0: there are none.
double find_largest_half_thickness(const Mesh& mesh);

/// [side.nodes] half the thickness of the thickest shell of the side around each node, on any rank; empty in a scene
/// without shells. Collective. Throws MpiError.
std::vector<double> find_node_thickness(const ChunkedMesh& chunked, const SurfaceNodes& side, ItemExchange& exchange);

/// Unties nodes that only thickness lets in, beyond the tie's distance from the mesh, behind another node of their
/// element: what stands on a thick shell, or begins at its middle, is held by the nodes that are closest to it, however
/// fine its mesh. answers: those of the search, the same on all ranks that have a node. Collective. Throws
/// MpiError.
void leave_out_what_lies_behind(const ChunkedMesh& chunked, const TieSearch& search, std::vector<ClosestFace>& answers,
                                ItemExchange& exchange);

/// The faces with those on the other sides of their shells, ascending.
std::vector<ElementFace> add_other_sides(const Mesh& mesh, std::vector<ElementFace> faces);

}  // namespace percuss
