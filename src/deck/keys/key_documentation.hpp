#pragma once
// What docs/deck.md says of the keys. The page is built into the program.

#include <map>
#include <string>

namespace percuss {

/// A row of the page's tables, as plain text: without the marks of links and escapes.
struct KeyDocumentation {
  std::string takes, otherwise, unit, meaning;  // `otherwise`: the default, or "required"
};

extern const char* const deck_page;

/// The rows of a page by the paths of their keys ("parts.NAME.box.size").
std::map<std::string, KeyDocumentation> read_key_documentation(const std::string& page);

}  // namespace percuss
