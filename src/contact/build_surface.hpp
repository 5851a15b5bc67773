#pragma once
// From mesh and deck to the contact surface: exterior faces, their nodes, and who may touch whom.

#include "kernels/contact/contact_surface.hpp"
#include "kernels/contact/row_system.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// All exterior faces of the mesh and the pair table of the deck. With named surfaces the first pair of the deck that
/// fits a node and a face decides their friction. Throws InputError for unknown surfaces.
ContactSurface build_surface(const Mesh& mesh, const Deck& deck);

/// The deck's rigid walls with the contact nodes that may touch them. Throws InputError for unknown selections and for
/// one without a contact node.
WallPairs build_walls(const Mesh& mesh, const Deck& deck, const ContactSurface& surface);

}  // namespace percuss
