#pragma once
// Decks that must be refused, each with the place and the words of its message. They are tried twice: through
// parse_deck (wrong_decks_test.cpp) and as files through the executable (tests/src/app).

#include <string>
#include <vector>

namespace percuss {

struct WrongDeck {
  std::string name;     // CamelCase: the test's name
  std::string text;     // the whole file
  std::string place;    // "LINE:COLUMN", or empty if the message is about the file
  std::string message;  // what the message says
  int errors = 1;       // how many lines of messages there are
};

/// All of them; the same every time.
const std::vector<WrongDeck>& wrong_decks();

// The parts of the table, one file each.
std::vector<WrongDeck> wrong_yaml_decks();        // not YAML, not text, too large
std::vector<WrongDeck> wrong_value_decks();       // values of the wrong type or range
std::vector<WrongDeck> wrong_key_decks();         // keys missing, unknown or at odds with each other
std::vector<WrongDeck> wrong_part_decks();        // parts that are made of parts, placed and joined
std::vector<WrongDeck> wrong_material_decks();    // constants of materials
std::vector<WrongDeck> wrong_connection_decks();  // welds, joints, springs of turns, rigid sets
std::vector<WrongDeck> wrong_load_decks();        // sensors and what they switch, pressures, the start
std::vector<WrongDeck> wrong_output_decks();      // fields and history

/// A right deck of five lines; every wrong one differs from it in one thing.
extern const std::string right_deck;

/// right_deck with one text replaced (it must be there), and with more lines after the fifth.
std::string change(const std::string& from, const std::string& to);
std::string append(const std::string& lines);

}  // namespace percuss
