#pragma once
// Keys of `output.history.forces`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/values.hpp"

namespace percuss {

/// An entry of `output.history.forces`: a name and one kind of force.
struct ForceValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ForceDeck& out) const;
  Form form() const;
  std::string takes() const { return "a map"; }
};

/// A part, an element block, an element set or a list of these.
struct ElementSetsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) const;
  std::string takes() const { return "a part, an element block, an element set or a list of these"; }
  Form form() const { return any_form({Form::Kind::text, list_form(Form::Kind::text, 1)}); }
};

/// Names of forces and of the walls that they name.
void check_forces(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
