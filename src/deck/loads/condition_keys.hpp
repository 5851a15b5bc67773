#pragma once
// Keys of `conditions`.

#include <string>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// `conditions`: each entry holds nodes in one way.
struct ConditionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ConditionDeck& out) const;
  Form form() const;
  std::string takes() const { return "a map"; }
};

}  // namespace percuss
