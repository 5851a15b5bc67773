#include "src/step/fluids/build_fluids.hpp"

#include <algorithm>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// The centroid of a tetrahedron is the mean of its corners, where lumped masses have its weight anyway.
bool has_own_centroid(const Deck& deck, const ElementBlock& block) {
  const ElementFamily family = find_topology(block.topology).family;
  const bool is_listed =
      family == ElementFamily::hexahedra || family == ElementFamily::wedges || family == ElementFamily::pyramids;
  return is_listed && !deck.parts[at(block.part)].rigid &&
         find_traits(deck.materials[at(block.material)]).needs_equation_of_state;
}

/// After a relaxation, or with the pressure of its depth; another fluid begins to fall.
bool rests_at_start(const Deck& deck, const std::string& part) {
  return deck.start.relaxation || deck.start.find_hydrostatic(part) != nullptr;
}

/// One more than the largest of all ranks.
std::int64_t find_next_order(const LocalSlots& slots, const Communicator& ranks) {
  std::int64_t order = 0;
  for (const std::int64_t other : slots.orders) order = std::max(order, other + 1);
  all_reduce(ranks, Reduce::largest, order);
  return order;
}

}  // namespace

void build_fluids(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model) {
  const std::vector<ElementBlock>& blocks = chunked.mesh.elements.blocks;  // all ranks know them all
  model.has_fluids =
      std::any_of(blocks.begin(), blocks.end(), [&](const auto& block) { return has_own_centroid(deck, block); });
  if (!model.has_fluids) return;
  const std::int64_t order = find_next_order(slots, model.ranks);
  const auto nodes = to_host(model.chunks.slots_to_nodes);
  const auto first_slot = to_host(model.chunks.first_slot);
  std::vector<int> list, elements{0}, own_slots;
  std::vector<double> moduli, weights;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    const ElementBlock& block = find_block(chunked, chunk);
    if (!has_own_centroid(deck, block)) continue;
    list.push_back(static_cast<int>(c));
    elements.push_back(elements.back() + chunk.element_count);
    own_slots.push_back(static_cast<int>(slots.nodes.size()));
    weights.push_back(rests_at_start(deck, deck.parts[at(block.part)].name) ? 1 : 0);
    moduli.push_back(find_moduli(deck.materials[at(block.material)]).lambda);
    slots.nodes.insert(slots.nodes.end(), &nodes(at(first_slot(c))), nodes.data() + first_slot(c + 1));
    slots.orders.resize(slots.nodes.size(), order + chunk.number);
  }
  model.fluids = {to_view("percuss::fluid_chunks", list), to_view("percuss::first_fluid_elements", elements),
                  to_view("percuss::first_fluid_slots", own_slots), to_view("percuss::fluid_moduli", moduli),
                  to_view("percuss::fluid_weights", weights)};
}

}  // namespace percuss
