#pragma once
// Keys of `parts.NAME.rigid` and of `rigid_sets`.

#include <optional>
#include <string>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// `rigid` of a part: true, or a map.
struct RigidValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::optional<RigidDeck>& out) const;
  Form form() const;
  std::string takes() const { return "true | false or a map"; }
};

NamedMapValue<RigidSetDeck, MapValue<RigidSetDeck>> rigid_sets_value();

/// Checks what rigid parts and sets must have in common, and what they exclude.
void check_rigid(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
