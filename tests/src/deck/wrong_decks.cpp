#include "tests/src/deck/wrong_decks.hpp"

#include <stdexcept>

namespace percuss {

const std::string right_deck =
    "time: {end: 1.0, step_scale: 0.9}\n"
    "parts:\n"
    "  rod: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}\n"
    "materials:\n"
    "  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}\n";

std::string change(const std::string& from, const std::string& to) {
  std::string text = right_deck;
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("right_deck holds no '" + from + "'");
  return text.replace(at, from.size(), to);
}

std::string append(const std::string& lines) { return right_deck + lines + "\n"; }

const std::vector<WrongDeck>& wrong_decks() {
  static const std::vector<WrongDeck> all = [] {
    std::vector<WrongDeck> decks;
    for (const auto& part :
         {wrong_yaml_decks(), wrong_value_decks(), wrong_key_decks(), wrong_part_decks(), wrong_material_decks(),
          wrong_connection_decks(), wrong_load_decks(), wrong_output_decks()}) {
      decks.insert(decks.end(), part.begin(), part.end());
    }
    return decks;
  }();
  return all;
}

}  // namespace percuss
