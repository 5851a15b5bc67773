#pragma once
// Keys of `parts`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// A part: one shape, where it stands, its copies and its material.
struct PartValue {
  bool read_inside(const Reader& reader, const Node& node, PartDeck& out) const;
  Form form() const;
};

}  // namespace percuss
