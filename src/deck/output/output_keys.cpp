#include "src/deck/output/output_keys.hpp"

#include "src/deck/output/field_keys.hpp"
#include "src/deck/output/history_keys.hpp"

namespace percuss {
namespace {

const Keys<OutputDeck>& checkpoint_keys() {
  static const Keys<OutputDeck> keys = {
      may("every", &OutputDeck::checkpoint_every, NumberValue{positive}),
      may("wall", &OutputDeck::checkpoint_wall, NumberValue{positive}),
      may("at_end", &OutputDeck::checkpoint_at_end, BooleanValue{}),
  };
  return keys;
}

bool check_checkpoint(const Reader& reader, const Node& node, OutputDeck& output) {
  if (output.checkpoint_every || output.checkpoint_wall || node.find("at_end") != nullptr) return true;
  reader.error(node.spot, fmt::format("{} has none of every, wall and at_end (they say when to write)", reader.self()));
  return false;
}

const Keys<OutputDeck>& output_keys() {
  static const Keys<OutputDeck> keys = {
      may("fields", &OutputDeck::fields, fields_value()),
      may("field_outputs", &OutputDeck::field_outputs, field_outputs_value()),
      group<OutputDeck>("history", history_value()),
      group<OutputDeck>("checkpoint", MapValue<OutputDeck>{checkpoint_keys, check_checkpoint}),
  };
  return keys;
}

}  // namespace

MapValue<OutputDeck> output_value() { return {output_keys}; }

}  // namespace percuss
