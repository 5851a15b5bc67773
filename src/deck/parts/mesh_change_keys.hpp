#pragma once
// Keys of `join` and `imperfections`: what changes the meshes of parts.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// `join`: true for all parts, or a list of maps.
struct JoinValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<JoinDeck>& out) const;
  Form form() const;
  std::string takes() const { return "true | false or a list of maps"; }
};

MapValue<ImperfectionDeck> imperfection_value();

}  // namespace percuss
