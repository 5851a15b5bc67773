#pragma once
// The form of a deck's values as data, given by the same objects that read them. From it come the list of keys that
// docs/deck.md is checked against (deck_keys.cpp) and the JSON Schema for editors (deck_schema.cpp). A form accepts all
// that its reader accepts. Checks that concern several values, or names that must exist, are left to the reader.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/deck/range.hpp"

namespace percuss {

struct FormKey;

/// A case of a map in which one key says which others go with it: the keys that go with one of its words.
struct FormCase {
  std::string word;
  std::vector<std::string> keys;      // all that the map may then hold
  std::vector<std::string> required;  // of these, what it must hold
};

struct Form {
  enum class Kind { text, number, integer, boolean, word, list, tuple, map, named_maps, any_of };
  Form(Kind of = Kind::text);  // below, where a key is known

  Kind kind;
  Range range = {};                           // of a number or an integer
  std::vector<std::string> words = {};        // of which a word is one
  std::vector<Form> inner = {};               // list, named_maps: of every item; tuple: of each; any_of: the choices
  std::size_t least = 0;                      // items of a list, keys of a map
  std::vector<FormKey> keys;                  // of a map
  std::vector<std::string> exactly_one = {};  // keys of which a map has exactly one
  std::string chooser = {};                   // key of a map that tells the cases apart
  std::vector<FormCase> cases = {};           // at least one where there is a chooser
  std::optional<std::string> listed_as = {};  // where the list of keys has those of this map, once for all places; "":
                                              // nowhere, because words say which they are
};

struct FormKey {
  std::string name;
  bool required = false;
  std::string takes;
  Form form;
  bool by_case = false;  // not in every case, nor required in every one
};

inline Form::Form(Kind of) : kind(of) {}

Form number_form(Range range = {});
Form word_form(std::vector<std::string> words);
Form list_form(Form item, std::size_t least = 0);
Form tuple_form(std::vector<Form> items);
Form any_form(std::vector<Form> choices);
Form map_form(std::vector<FormKey> keys);

}  // namespace percuss
