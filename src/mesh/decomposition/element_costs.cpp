#include "src/mesh/decomposition/element_costs.hpp"

#include "src/deck/laws/law_traits.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Only the nodes of a rigid body move.
constexpr int rigid_cost = 9;

/// Cost in thirty-seconds of a hexahedron; called: more, where packs call the law instead of having it in their body.
struct KindCost {
  int own, called;
};

KindCost find_kind_cost(TopologyKind kind, const ElementDeck& settings) {
  switch (kind) {
    case TopologyKind::hex8:
      if (settings.integration == ElementDeck::Integration::thick_shell) return KindCost{190, 180};
      return settings.integration == ElementDeck::Integration::full ? KindCost{76, 90} : KindCost{hexahedron_cost, 18};
    case TopologyKind::quad4:
    case TopologyKind::tri3:
      return {43, 0};
    case TopologyKind::tet4:
      return {34, 12};
    case TopologyKind::wedge6:
      return {36, 18};
    case TopologyKind::pyramid5:
      return {26, 18};
    case TopologyKind::line2:
      break;
  }
  return {50, 0};
}

}  // namespace

int find_element_cost(const Deck& deck, const ElementBlock& block) {
  if (is_uncomputed(deck, at(block.part))) return rigid_cost;
  const KindCost cost = find_kind_cost(block.topology, deck.find_elements(at(block.part)));
  const bool is_compiled_in = find_traits(deck.materials[at(block.material)]).is_compiled_in;
  return is_compiled_in ? cost.own : cost.own + cost.called;
}

}  // namespace percuss
