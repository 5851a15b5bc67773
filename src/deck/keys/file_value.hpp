#pragma once
// Files that a deck names.

#include <string>

#include "src/deck/keys/values.hpp"

namespace percuss {

/// A file that the deck names: relative paths are relative to the deck.
struct FileValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const;
  std::string takes() const { return "a file, relative to the deck"; }
  Form form() const { return TextValue{}.form(); }
};

}  // namespace percuss
