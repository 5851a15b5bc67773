// docs/deck.md describes every key that the reader knows, and its decks are right.

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "src/deck/output/field_keys.hpp"
#include "src/deck/reading/deck_keys.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

std::string read_documentation() {
  std::ifstream stream(PERCUSS_SOURCE_DIR "/docs/deck.md");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The start of the row that describes a key: | `path` | takes | required |
std::string row_of(const DeckKey& key) {
  std::string takes;
  for (const char c : key.takes) takes += c == '|' ? std::string("\\|") : std::string(1, c);
  return "| `" + key.path + "` | " + takes + " | " + (key.required ? "required |" : "");
}

TEST(DeckDocumentation, DescribesEveryKey) {
  const std::string text = read_documentation();
  ASSERT_FALSE(text.empty());
  for (const DeckKey& key : list_deck_keys()) {
    const auto row = text.find(row_of(key));
    EXPECT_NE(row, std::string::npos) << row_of(key);
    if (row == std::string::npos || key.required) continue;
    EXPECT_NE(text.compare(row + row_of(key).size(), 8, "required"), 0) << key.path << " is not required";
  }
}

TEST(DeckDocumentation, DescribesNoOtherKey) {
  std::set<std::string> known;
  for (const DeckKey& key : list_deck_keys()) known.insert(key.path);
  std::istringstream text(read_documentation());
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("| `") || line.find("` | ") == std::string::npos) continue;
    const std::string path = line.substr(3, line.find('`', 3) - 3);
    if (path == "5.0" || path.starts_with("{")) continue;  // a form of a curve
    EXPECT_TRUE(known.count(path) == 1) << path;
  }
}

TEST(DeckDocumentation, NamesEveryField) {
  const std::string text = read_documentation();
  for (const std::string& field : field_names()) {
    if (field == "displacement") continue;  // always written
    int point = 1;
    for (const std::string_view quantity : point_quantities)
      point = std::max(point, find_field_number(field, quantity).value_or(1));
    point = std::max(point, find_field_number(field, state_variables).value_or(1));
    if (point > 1) continue;  // the first stands for all
    EXPECT_NE(text.find("`" + field + "`"), std::string::npos) << field;
  }
}

TEST(DeckDocumentation, BeginsWithADeckThatIsRight) {
  const std::string text = read_documentation();
  const std::string fence = "```yaml\n";
  const auto start = text.find(fence) + fence.size();
  EXPECT_NO_THROW(parse_deck(text.substr(start, text.find("```", start) - start), "deck.yaml"));
}

// All examples together are one deck, but for the mesh file that is not there.
TEST(DeckDocumentation, HasExamplesThatAreRight) {
  const std::string text = read_documentation();
  const std::string fence = "```yaml\n";
  std::string deck;
  for (auto at = text.find(fence, text.find("## The scene")); at != std::string::npos; at = text.find(fence, at + 1)) {
    const auto start = at + fence.size();
    const std::string example = text.substr(start, text.find("```", start) - start);
    if (!example.starts_with("nodes:")) deck += example;  // a selector alone
  }
  try {
    parse_deck(deck, "deck.yaml");
    FAIL() << "casing.e does not exist";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("exodus.file is 'casing.e'"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace percuss
