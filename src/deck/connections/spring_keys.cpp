#include "src/deck/connections/spring_keys.hpp"

#include "src/deck/connections/spring_end_value.hpp"
#include "src/deck/keys/force_table_value.hpp"

namespace percuss {
namespace {

const Keys<SpringDeck>& spring_failure_keys() {
  static const Keys<SpringDeck> keys = {
      may("force", &SpringDeck::largest_force, NumberValue{positive}),
      may("elongation", &SpringDeck::largest_elongation, NumberValue{positive}),
  };
  return keys;
}

const Keys<SpringDeck>& spring_keys() {
  using Acts = SpringDeck::Acts;
  static const Keys<SpringDeck> keys = {
      need("between", &SpringDeck::between, TupleValue<SpringEndValue, 2>{}),
      may("stiffness", &SpringDeck::stiffness, NumberValue{positive}),
      may("table", &SpringDeck::table, ForceTableValue{"elongation", "force"}),
      may("damping", &SpringDeck::damping, NumberValue{positive}),
      may("acts", &SpringDeck::acts,
          ChoiceValue<Acts>{{{"both", Acts::both}, {"tension", Acts::tension}, {"compression", Acts::compression}}}),
      may("rest_length", &SpringDeck::rest_length, NumberValue{not_negative}),
      group<SpringDeck>("failure", MapValue<SpringDeck>{spring_failure_keys}),
  };
  return keys;
}

bool check_spring(const Reader& reader, const Node& node, SpringDeck& spring) {
  const Node* table = node.find("table");
  if (table != nullptr && spring.stiffness) {
    reader.error(table->key, fmt::format("{} has both stiffness and table (must have one of them)", reader.self()));
    return false;
  }
  if (table != nullptr || spring.stiffness || spring.damping > 0) return true;
  reader.error(node.spot, fmt::format("{} does nothing (must have stiffness, table or damping)", reader.self()));
  return false;
}

}  // namespace

NamedMapValue<SpringDeck, MapValue<SpringDeck>> springs_value() { return {"spring", {spring_keys, check_spring}}; }

}  // namespace percuss
