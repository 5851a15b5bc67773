#pragma once
// Ends of springs, welds and constraints.

#include <string>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// One node by its place or id, or a selector.
struct SpringEndValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, SpringEndDeck& out) const;
  std::string takes() const { return "a node as {near: [x, y, z]} or {id: n}, or a selector"; }
  Form form() const;
};

}  // namespace percuss
