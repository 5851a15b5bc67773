#pragma once
// Keys of `contact`.

#include <string>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// `contact`: a deck that has the section means all surfaces unless it says otherwise.
struct ContactValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ContactDeck& out) const;
  Form form() const;
  std::string takes() const { return "a map"; }
};

}  // namespace percuss
