#pragma once
// The deck in the words of JSON Schema, for editors.

#include <string>

namespace percuss {

/// A schema (draft 2020-12) of all decks that the reader takes, and of some that it refuses: it knows the keys, which
/// of them must be there, and the form of every value. From the tables of keys and the rows of docs/deck.md.
std::string write_deck_schema();

}  // namespace percuss
