#pragma once
// Parts that may touch each other and walls, by what the deck names.

#include <cstddef>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// Parts by their number that something holds for.
using Marks = std::vector<bool>;

/// Adds the parts that a selector may mean.
void mark(const Deck& deck, const Selector& where, Marks& marks);

/// The parts that have someone to touch after a time, by the deck: a surface or a tie.
Marks mark_touching(const Deck& deck, double time = 0);

/// The parts that entries of `contact.surfaces` and ties name.
Marks mark_named_surfaces(const Deck& deck, double time = 0);

/// The parts that something but contact may connect to others or to the ground, by the deck: ties, welds, springs,
/// constraints, joints, rigid sets and embedded nodes.
Marks mark_connected(const Deck& deck);

/// Adds the parts of the bodies that joints hold.
void mark_jointed(const Deck& deck, Marks& marks);

/// The parts that a wall stops.
Marks mark_stopped(const Deck& deck, const WallDeck& wall);

/// Whether a spring is between two parts: then neither flies freely.
bool are_sprung(const Deck& deck, std::size_t part, std::size_t other);

}  // namespace percuss
