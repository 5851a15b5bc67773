#pragma once
// Reads a deck: strict YAML, every error with its place, all of them at once.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// Reads and checks a deck. `overrides` are the `--set` arguments, "path.to.key=value" in YAML.
/// Throws InputError with every message ("file:line:column: error: ..."), SystemError if the file cannot be read.
Deck read_deck(const std::string& file, const std::vector<std::string>& overrides = {});

/// Reads a deck from text; `file` only names it in messages and anchors relative paths.
Deck parse_deck(const std::string& text, const std::string& file, const std::vector<std::string>& overrides = {});

}  // namespace percuss
