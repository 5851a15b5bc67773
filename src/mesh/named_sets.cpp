#include "src/mesh/named_sets.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace percuss {
namespace {

using Names = std::set<std::string>;

void add_conditions_and_loads(const Deck& deck, Names& names) {
  for (const InitialDeck& entry : deck.initial) names.insert(entry.where.name);
  for (const ConditionDeck& entry : deck.conditions) names.insert(entry.where.name);
  for (const PressureDeck& entry : deck.pressures) names.insert(entry.where.name);
  for (const NodalLoadDeck& entry : deck.nodal_loads) names.insert(entry.where.name);
  for (const AddedMassDeck& entry : deck.added_masses) names.insert(entry.where.name);
  for (const DampingDeck& entry : deck.dampings) names.insert(entry.where.name);
  for (const RigidSetDeck& entry : deck.rigid_sets) names.insert(entry.where.name);
}

void add_surfaces(const Deck& deck, Names& names) {
  for (const WallDeck& wall : deck.walls) {
    for (const Selector& nodes : wall.nodes) names.insert(nodes.name);
  }
  for (const SurfacePairDeck& pair : deck.contact.pairs) names.insert({pair.a.name, pair.b.name});
  for (const TieDeck& tie : deck.contact.ties) names.insert({tie.a.name, tie.b.name});
  for (const PairFrictionDeck& pair : deck.contact.frictions) {
    names.insert(pair.a.name);
    if (pair.b) names.insert(pair.b->name);
  }
  for (const ForceDeck& force : deck.output.forces) {
    names.insert(force.where.name);
    for (const Selector& side : force.on) names.insert(side.name);
    for (const Selector& side : force.from) names.insert(side.name);
    if (force.nodes) names.insert(force.nodes->name);
  }
  for (const SpringDeck& spring : deck.springs) {
    for (const SpringEndDeck& end : spring.between) names.insert(end.where.name);
  }
  for (const WeldDeck& weld : deck.welds) {
    for (const SpringEndDeck& end : weld.between) names.insert(end.where.name);
  }
  for (const ConstraintDeck& constraint : deck.constraints) {
    if (constraint.nodes) names.insert(constraint.nodes->name);
    for (std::size_t i = 0; constraint.between && i < 2; ++i) names.insert((*constraint.between)[i].where.name);
  }
}

/// Parts whose mesh is that of a file.
Names list_parts_of_files(const Deck& deck) {
  Names parts;
  for (const PartDeck& part : deck.parts) {
    if (std::holds_alternative<FileMesh>(part.shape)) parts.insert(part.name);
  }
  return parts;
}

/// named: by the deck, with the part's name or without.
template <class Sets>
std::vector<std::string> choose(const Sets& sets, const Names& named, const Names& parts_of_files) {
  std::vector<std::string> chosen;
  for (const auto& [name, members] : sets) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) continue;
    if (parts_of_files.contains(name.substr(0, slash)) || named.contains(name) ||
        named.contains(name.substr(slash + 1)))
      chosen.push_back(name);
  }
  return chosen;
}

}  // namespace

NamedSets find_named_sets(const Deck& deck, const Mesh& mesh) {
  Names named;
  add_conditions_and_loads(deck, named);
  add_surfaces(deck, named);
  const Names parts_of_files = list_parts_of_files(deck);
  return {choose(mesh.node_sets, named, parts_of_files), choose(mesh.side_sets, named, parts_of_files)};
}

}  // namespace percuss
