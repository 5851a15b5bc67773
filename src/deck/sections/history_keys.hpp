#pragma once
// Keys of `output.history.blocks` and `output.history.accelerometers`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// Names of element blocks and element sets, each once.
struct BlocksValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) const;
  std::string takes() const { return "a list of element blocks or element sets"; }
  Form form() const { return list_form(Form::Kind::text, 1); }
};

ListValue<MapValue<AccelerometerDeck>> accelerometers_value();

/// Blocks whose names are those of parts, which have columns of their own.
void check_blocks(const Deck& deck, Reading& reading);

/// Names of accelerometers, and of the nodes that they have.
void check_accelerometers(const Deck& deck, Reading& reading);

}  // namespace percuss
