// Decks cut short and damaged at random: refused or read, but never a crash, a hang or another kind of error.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/random.hpp"

namespace percuss {
namespace {

// One of everything, in block and flow style.
const std::string full_deck = R"yaml(title: "Everything: \"at\" once"
units: 'm, kg, s'
time: {end: 2.0e-3, step_scale: 0.9, max_step: 1, max_steps: 10}  # comment
parts:
  rod:
    cylinder: {radius: 0.05, length: 0.4, cells: [8, 32]}
    axis: x
    rotate: [{axis: [0, 1, 1], angle: 30, center: [0, 0, 0]}]
    material: steel
  bricks: {box: {size: [0.2, 0.1, 0.06], cells: [6, 3, 3]}, array: {count: [1, 2, 2], pitch: [1, 1, 1]}, material: steel}
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 2e11, poissons_ratio: 0.3, yield_stress: 4e8}
initial:
- part: rod
  velocity: [200, 0, 0]
- {nodes: {name: bricks/x_min, inside: [[0, 0, 0], [1, 1, 1]]}, angular_velocity: [0, 0, 1]}
loads: {gravity: [0, 0, -9.81], pressure: [{faces: rod/start, value: {table: [[0, 0], [1, 2]]}}]}
conditions:
  - {nodes: rod/end, fixed: [x, y]}
  - nodes: rod/end
    velocity:
      z: {expression: "sin(2*pi*t)"}
walls: [{normal: z, friction: 0.1, nodes: [rod]}]
contact: {surfaces: [[rod, bricks], {a: rod, b: rod, friction: 1}], overlap: push_out, reuse_search: false}
output: {fields: {every: 1e-4, write: [velocity]}, history: {every: 0, nodes: [{name: a, near: [0, 0, 0]}]}}
audit: {max_energy_error: 0.1}
)yaml";

enum class Outcome { read, refused };

Outcome try_deck(const std::string& text) {
  try {
    parse_deck(text, "deck.yaml");
    return Outcome::read;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("deck.yaml"), std::string::npos) << error.what();
    return Outcome::refused;
  }
}

TEST(DamagedDeck, IsRightBeforeItIsDamaged) { EXPECT_EQ(try_deck(full_deck), Outcome::read); }

TEST(DamagedDeck, IsRefusedOrReadWhereverItIsCut) {
  int refused = 0;
  for (std::size_t length = 0; length < full_deck.size(); ++length) {
    if (try_deck(full_deck.substr(0, length)) == Outcome::refused) ++refused;
  }
  EXPECT_GT(refused, 600);  // up to the materials nothing is complete
}

TEST(DamagedDeck, SurvivesBytesInPlaceOfOthers) {
  test::RandomIndex random;
  const std::string bytes = "{}[]:,-?&*!|>'\"%@`#~ \t\n\r\\0e.\x00\x7f\xc3\xff<=";
  for (int i = 0; i < 3000; ++i) {
    std::string text = full_deck;
    for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) {
      text[random.below(text.size())] = bytes[random.below(bytes.size())];
    }
    try_deck(text);
  }
}

TEST(DamagedDeck, SurvivesPiecesMovedAndRepeated) {
  test::RandomIndex random;
  for (int i = 0; i < 2000; ++i) {
    const std::string piece = full_deck.substr(random.below(full_deck.size()), 1 + random.below(60));
    std::string text = full_deck;
    text.insert(random.below(text.size()), piece);
    text.erase(random.below(text.size()), random.below(40));
    try_deck(text);
  }
}

TEST(DamagedDeck, SurvivesWordsOfYamlAlone) {
  test::RandomIndex random;
  const std::vector<std::string> words = {"{",     "}",     "[",   "]",    ": ",    ", ", "- ", "? ",   "&a ",
                                          "*a",    "!t ",   "|\n", ">\n",  "'",     "\"", "\n", "\n  ", "%YAML 1.2\n",
                                          "---\n", "...\n", "a",   "time", "parts", "1",  "~",  "#",    "<<"};
  for (int i = 0; i < 5000; ++i) {
    std::string text;
    for (std::size_t n = random.below(24); n > 0; --n) text += words[random.below(words.size())];
    try_deck(text);
  }
}

}  // namespace
}  // namespace percuss
