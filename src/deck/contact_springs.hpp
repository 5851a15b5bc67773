#pragma once
// Decks that have springs of contact.

#include <algorithm>

#include "src/deck/deck.hpp"

namespace percuss {

/// Whether springs may push rows of contact: all of them (penalty), or those of sheets, if the deck has any.
inline bool may_have_contact_springs(const Deck& deck) {
  using Enforcement = ContactDeck::Enforcement;
  if (deck.contact.enforcement == Enforcement::penalty) return true;
  if (deck.contact.enforcement != Enforcement::automatic || deck.contact.surfaces == ContactDeck::Surfaces::none)
    return false;
  return std::any_of(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) { return part.has_thickness(); });
}

}  // namespace percuss
