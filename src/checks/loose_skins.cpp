#include "src/checks/loose_skins.hpp"

#include <algorithm>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

bool is_skin(const Deck& deck, std::size_t part) { return is_uncomputed(deck, part) && !deck.parts[part].rigid; }

void add_end(const SpringEndDeck& end, std::vector<Selector>& chosen) {
  if (!end.point) chosen.push_back(end.where);
}

/// Selectors of nodes that follow something else than their elements.
std::vector<Selector> list_holders(const Deck& deck) {
  std::vector<Selector> chosen;
  for (const RigidSetDeck& set : deck.rigid_sets) chosen.push_back(set.where);
  for (const ConditionDeck& condition : deck.conditions) chosen.push_back(condition.where);
  for (const EmbeddedDeck& embedded : deck.embedded) chosen.push_back(embedded.nodes);
  for (const TieDeck& tie : deck.contact.ties) chosen.insert(chosen.end(), {tie.a, tie.b});
  for (const SpringDeck& spring : deck.springs)
    for (const SpringEndDeck& end : spring.between) add_end(end, chosen);
  for (const WeldDeck& weld : deck.welds)
    for (const SpringEndDeck& end : weld.between) add_end(end, chosen);
  for (const ConstraintDeck& constraint : deck.constraints) {
    if (constraint.nodes) chosen.push_back(*constraint.nodes);
    if (constraint.between)
      for (const SpringEndDeck& end : *constraint.between) add_end(end, chosen);
    for (const EquationTermDeck& term : constraint.equation) add_end(term.of, chosen);
  }
  return chosen;
}

/// [nodes] whether an element of no skin has the node, on this rank, or a holder.
std::vector<bool> find_taken(const Deck& deck, const Mesh& mesh, const std::vector<bool>& skins) {
  std::vector<bool> taken(mesh.nodes.size(), false);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (skins[at(mesh.part_of(e))]) continue;
    for (const int node : mesh.corners(e)) taken[at(node)] = true;
  }
  for (const Selector& selector : list_holders(deck))
    for (const int node : select_nodes(mesh, deck, selector)) taken[at(node)] = true;
  return taken;
}

/// Adds what elements of other ranks take: their nodes that a skin has, by their numbers in the whole mesh.
void share_taken(const Mesh& mesh, const std::vector<bool>& skins, std::vector<bool>& taken) {
  std::vector<std::int64_t> numbers;
  std::vector<int> nodes;
  for (std::size_t p = 0; p < skins.size(); ++p) {
    if (!skins[p]) continue;
    const auto& own = mesh.node_sets.at(mesh.parts[p].name);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  for (const int node : nodes)
    if (taken[at(node)]) numbers.push_back(mesh.node_numbers[at(node)]);
  std::vector<std::int64_t> all = gather_items(*mesh.ranks, numbers);
  std::sort(all.begin(), all.end());
  for (const int node : nodes)
    if (std::binary_search(all.begin(), all.end(), mesh.node_numbers[at(node)])) taken[at(node)] = true;
}

}  // namespace

std::vector<std::int64_t> count_loose_nodes(const Deck& deck, const ChunkedMesh& chunked,
                                            const std::vector<bool>& owned) {
  const Mesh& mesh = chunked.mesh;
  std::vector<std::int64_t> counts(mesh.parts.size(), 0);
  std::vector<bool> skins;
  for (std::size_t p = 0; p < counts.size(); ++p) skins.push_back(is_skin(deck, p));
  if (std::none_of(skins.begin(), skins.end(), [](bool is) { return is; })) return counts;
  std::vector<bool> taken = find_taken(deck, mesh, skins);
  const bool is_shared = mesh.ranks && mesh.ranks->size() > 1;
  if (is_shared) share_taken(mesh, skins, taken);
  for (std::size_t p = 0; p < counts.size(); ++p) {
    if (!skins[p]) continue;
    for (const int node : mesh.node_sets.at(mesh.parts[p].name)) counts[p] += owned[at(node)] && !taken[at(node)];
  }
  if (is_shared) all_reduce(*mesh.ranks, Reduce::sum, counts);
  return counts;
}

}  // namespace percuss
