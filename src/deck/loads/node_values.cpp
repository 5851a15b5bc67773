#include "src/deck/loads/node_values.hpp"

#include "src/deck/rigid_bodies.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {

bool BodyValue::read(const Reader& reader, const std::string& name, const Node& node, Selector& out) const {
  out.place = node.spot.place;
  std::string body;
  if (!NameValue{}.read(reader, name, node, body)) return false;
  out.name = body_prefix + body;
  return true;
}

bool check_nodes_or_body(const Reader& reader, const Node& node) {
  const bool has_nodes = node.find("nodes") != nullptr, has_body = node.find("body") != nullptr;
  if (has_nodes != has_body) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have exactly one of nodes, body)", reader.self(),
                                      has_nodes ? "nodes and body" : "no nodes"));
  return false;
}

void check_body_names(const Deck& deck, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  const auto check = [&](const Selector& where) {
    const std::string body = find_body(where);
    if (body.empty() || names.find(body) >= 0) return;
    reading.errors.add({where.place, -1}, fmt::format("there is no rigid body '{}' (a rigid part, its rigid.body, or a "
                                                      "rigid set){}",
                                                      body, name_hint(body, names.bodies)));
  };
  for (const InitialDeck& initial : deck.initial) check(initial.where);
  for (const ConditionDeck& condition : deck.conditions) check(condition.where);
  for (const NodalLoadDeck& load : deck.nodal_loads) check(load.where);
}

Form directions_form(const std::vector<std::string>& names) {
  Form form = map_form({});
  for (const std::string& name : names) form.keys.push_back({name, false, CurveValue{}.takes(), CurveValue{}.form()});
  form.least = 1;
  form.listed_as = "";
  return form;
}

}  // namespace percuss
