#pragma once
// Keys of `materials`: `model` says which law.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// A material: `model` says which table its other keys come from.
struct MaterialValue {
  bool read_inside(const Reader& reader, const Node& node, MaterialDeck& out) const;
  Form form() const;
};

}  // namespace percuss
