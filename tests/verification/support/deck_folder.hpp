#pragma once
// A folder with decks and the files that they read.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {

class DeckFolder {
 public:
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  void add(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  Deck parse(const std::string& text) const { return parse_deck(text, path("deck.yaml"), {}); }
  /// With its results in a folder of this one.
  HistoryTable run_into(const std::string& text, const std::string& results) const {
    std::filesystem::create_directory(path(results));
    run_scene(parse(text), {path(results), Progress::Style::quiet});
    return HistoryTable(path(results + "/history.csv"));
  }
  Outcome run(const std::string& text) const { return run_deck(parse(text)); }
  /// The message with which the run is refused; empty if it is not.
  std::string find_error(const std::string& text) const {
    try {
      run(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace percuss::test
