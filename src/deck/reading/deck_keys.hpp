#pragma once
// The keys of a deck, with those of its sections. A new key is one row in the table of its section, a member of its
// struct (src/deck/deck.hpp) and a row in docs/deck.md.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// The deck itself.
const Keys<Deck>& deck_keys();

/// A key that a deck may hold, from the tables that the reader works by.
struct DeckKey {
  std::string path;   // "time.end"; NAME stands for a name that the user gives, N for a place in a list
  std::string takes;  // "a number, positive"
  bool required = false;
};

/// Every key, in the order of the tables.
std::vector<DeckKey> list_deck_keys();

}  // namespace percuss
