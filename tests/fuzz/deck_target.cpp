// Decks as text.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "src/deck/reading/deck_keys.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/src/deck/wrong_decks.hpp"

namespace percuss::fuzz {

void try_bytes(const std::string& bytes) {
  try {
    parse_deck(bytes, "deck.yaml");
  } catch (const InputError&) {
  }
}

std::vector<std::string> make_seeds() {
  std::vector<std::string> seeds{right_deck, "title: \"a\\uFFFEb\\e[2J\"\n" + std::string(right_deck)};
  for (const WrongDeck& deck : wrong_decks()) {
    if (deck.text.size() < 20000) seeds.push_back(deck.text);  // a few are large on purpose
  }
  std::set<std::filesystem::path> scenes;
  for (const auto& scene : std::filesystem::directory_iterator(PERCUSS_SOURCE_DIR "/inputs")) scenes.insert(scene);
  for (const auto& scene : scenes) {
    std::ifstream stream(scene / "deck.yaml", std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return seeds;
}

/// Every key, and what YAML and the values' readers look at.
std::vector<std::string> make_words() {
  std::set<std::string> words{": ",   "- ",  "{",    "}",    "[",   "]",  "? ",   "&a",  "*a",       "!!str ",
                              "<<: ", "|\n", ">\n",  "---",  "...", "#",  "'",    "\"",  "\n  ",     "~",
                              "null", "yes", ".inf", ".nan", "1e9", "-1", "1e-9", "0x1", "elastic",  "j2_plasticity",
                              "all",  "x",   "true", "sin(", "t",   "^",  "/",    "pi",  "velocity", "\xef\xbb\xbf"};
  for (const DeckKey& key : list_deck_keys()) {
    std::istringstream path(key.path);
    for (std::string part; std::getline(path, part, '.');) words.insert(part + ": ");
  }
  return {words.begin(), words.end()};
}

}  // namespace percuss::fuzz
