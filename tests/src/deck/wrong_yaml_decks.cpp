// Decks that are no YAML, no text, or YAML that a deck does not take.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

using namespace std::string_literals;

std::string repeat(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

std::vector<WrongDeck> wrong_texts() {
  return {
      {"Empty", "", "1:1", "the deck is empty"},
      {"OnlyComments", "# nothing\n\n", "1:1", "the deck is empty"},
      {"OnlyNull", "~\n", "1:1", "the deck is empty"},
      {"BinaryJunk",
       "\x7f"
       "ELF\x02\x01\x01\x00\x00"s,
       "1:1", "control character 0x7f"},
      {"NulByte", "time: {end\0: 1}"s, "1:11", "NUL byte"},
      {"NotUtf8", "title: Sto\xdf\n", "1:11", "not UTF-8"},
      {"OverlongUtf8", "title: \xc0\xaf\n", "1:8", "not UTF-8"},
      {"CutUtf8", "title: \xe2\x82", "1:8", "not UTF-8"},
      {"Utf16", "\xff\xfet\0i\0"s, "1:1", "UTF-16"},
      {"OldMacLineEnds", "a: 1\rb: 2\r", "1:5", "carriage return"},
      {"LsDynaModel", "$ a car\n*KEYWORD\n*NODE\n       1 0 0 0\n*END\n", "",
       "this is an LS-DYNA or Abaqus model (percuss runs decks in YAML): percuss import "},
      {"AbaqusModel", "** Caf\xe9\n\n*Heading\n", "", "deck.yaml --out DIR"},
      {"TooLarge", "# " + std::string(std::size_t{5} << 20, 'x') + "\n", "", "larger than 4 MiB"},
      {"ManyValues", "a: [" + repeat("1,", 1'100'000) + "]\n", "1:1999999", "more than 1000000 values"},
      {"NestedTooDeep", "a: " + repeat("[", 40) + repeat("]", 40) + "\n", "1:35", "nested deeper than 32"},
      // Open to the end, so that yaml-cpp takes each bracket for a possible key: one level more.
      {"NestedVeryDeep", "a: " + repeat("[", 100'000), "1:20", "nested deeper than 32"},
      {"NestedMapsVeryDeep", repeat("{a: ", 100'000), "1:125", "nested deeper than 32"},
      {"NestedBlocksVeryDeep", repeat("- ", 100'000), "1:65", "nested deeper than 32"},
  };
}

std::vector<WrongDeck> wrong_syntax() {
  return {
      {"TopIsAList", "- time\n- parts\n", "1:1", "the deck is ['time', 'parts'] (must be a map"},
      {"TopIsAWord", "hello\n", "1:1", "the deck is 'hello' (must be a map"},
      {"UnclosedList", change("cells: [2, 2, 2]", "cells: [2, 2, 2"), "3:47", "one opened before it is still open"},
      {"UnclosedMap", "time: {end: 1\n", "2:1", "the '{' of line 1, column 7 is not closed"},
      {"StrayBracket", append("title: a]}\ncontact: {}}"), "7:12", "closes nothing"},
      {"UnclosedQuote", append("title: \"steel"), "6:8", "a quote is not closed"},
      {"TabIndent", "time:\n\tend: 1\n", "2:1", "a tab indents this line"},
      {"TabIndentInAMap", "time:\n  end: 1\nparts:\n  \trod: {}\n  a: 1\n", "4:3", "a tab indents this line"},
      {"ColonInValue", append("title: steel: on brick"), "6:13", "':' does not belong here"},
      {"ValueBeginsWithAt", append("title: @home"), "6:8", "put it in quotes"},
      {"NoSpaceAfterColon", change("end: 1.0", "end:1.0"), "1:8", "a space must follow the colon: 'end: 1.0'"},
      {"NoColonBeforeAMap", change("time: {end: 1.0, step_scale: 0.9}", "time {end: 1.0}"), "1:1",
       "unknown key 'time {end' (a colon is missing after 'time')"},
      {"NoColonBeforeALongMap", change("time: {", "time {"), "1:1", "not valid YAML (a colon is missing after 'time')"},
      {"NoColonBeforeAPart", change("rod: {", "rod {"), "3:3", "not valid YAML (a colon is missing after 'rod')"},
      {"DuplicateSection", append("time: {end: 2}"), "6:1", "key 'time' is given twice (first on line 1)"},
      {"DuplicateKey", change("end: 1.0", "end: 1.0, end: 2.0"), "1:18", "key 'end' is given twice"},
      {"DuplicatePart", change("materials:", "  rod: {}\nmaterials:"), "4:3",
       "key 'rod' is given twice (first on line 3)"},
      {"KeyIsAList", append("[a, b]: 1"), "6:1", "a key is ['a', 'b'] (must be a word)"},
      {"EmptyKey", append(": 1"), "6:1", "a key is empty"},
      {"TwoDocuments", append("---\ntime: {end: 2}"), "6:1", "a second document begins"},
      {"Anchor", change("rod: {", "rod: &r {"), "3:8", "anchors are not supported"},
      {"Alias", append("initial: [&v {velocity: [1, 0, 0]}, *v]"), "6:37", "aliases are not supported", 2},
      {"RecursiveAlias", append("initial: &loop [*loop]"), "6:17", "aliases are not supported", 2},
      {"AliasOfNothing", append("title: *nothing"), "6:8", "aliases are not supported"},
      {"MergeKey", append("initial: [{<<: {velocity: [1, 0, 0]}}]"), "6:12", "unknown key '<<'"},
      {"Tag", change("end: 1.0", "end: !!float 1.0"), "1:13", "tags are not supported"},
      {"LaterYamlVersion", "%YAML 3.0\n---\ntime: {end: 1}\n", "1:1", "not valid YAML"},
      {"BillionLaughs", "a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\n", "1:4", "anchors are not supported", 12},
  };
}

}  // namespace

std::vector<WrongDeck> wrong_yaml_decks() {
  std::vector<WrongDeck> all = wrong_texts();
  for (WrongDeck& deck : wrong_syntax()) all.push_back(deck);
  return all;
}

}  // namespace percuss
