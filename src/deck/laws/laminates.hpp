#pragma once
// Parts with plies: each gets a material of its own, whose density is the mean of its plies.

#include "src/deck/deck.hpp"

namespace percuss {

/// Adds the materials and gives them to the parts.
void lay_up_plies(Deck& deck);

/// Whether shells of the material have layers that differ.
bool is_laminate(const MaterialDeck& material);

/// The plies of a laminate: those that the deck lists, or the one of a material that is a ply itself.
std::vector<LaminatePly> list_plies(const MaterialDeck& material);

/// Points of each ply, of which a laminate has so many; asked: as the deck gives it, 0: not at all. yields: of a shell
/// of one metal.
int count_points_of_ply(std::size_t plies, int asked, bool yields = false);

}  // namespace percuss
