#include "src/step/elements/build_tets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"

namespace percuss {

namespace {

/// What its elements are called in messages; null: hexahedra, or no solids.
const char* name_small_solids(const ElementBlock& block) {
  switch (find_topology(block.topology).family) {
    case ElementFamily::tetrahedra:
      return "tetrahedra";
    case ElementFamily::wedges:
      return "wedges";
    case ElementFamily::pyramids:
      return "pyramids";
    default:
      return nullptr;
  }
}

[[noreturn]] void refuse_small_solids(const Deck& deck, const ElementBlock& block, const std::string& what) {
  const PartDeck& part = deck.parts[static_cast<std::size_t>(block.part)];
  throw InputError(fmt::format("{}: error: part '{}' has {} ({}", deck.where(part.place), part.name,
                               name_small_solids(block), what));
}

/// Material of each slot of such elements, counted from 1, those of other ranks included; of other slots 0.
Rows3<double> find_slot_materials(const ChunkedMesh& chunked, const Model& model) {
  const Rows3<double> slots("percuss::slot_materials", static_cast<std::size_t>(model.slot_count));
  const auto host = Kokkos::create_mirror_view(slots);
  const auto first_slot = to_host(model.chunks.first_slot);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    if (name_small_solids(find_block(chunked, chunked.chunks[c])) == nullptr) continue;
    for (int s = first_slot(c); s < first_slot(c + 1); ++s)
      host(static_cast<std::size_t>(s), 0) = 1 + find_block(chunked, chunked.chunks[c]).material;
  }
  Kokkos::deep_copy(slots, host);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), slots);
  swap.end();
  return slots;
}

}  // namespace

void check_small_solids(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (name_small_solids(block) == nullptr) continue;
    if (is_single_precision)
      refuse_small_solids(
          deck, block,
          "this build is in single precision, but these need double): use a build with PERCUSS_PRECISION=double");
    if (deck.time.step_estimate == TimeDeck::StepEstimate::global)
      refuse_small_solids(deck, block,
                          "time.step_estimate: global supports hexahedra only): leave time.step_estimate out");
  }
}

void build_tet_nodes(const ChunkedMesh& chunked, const SlotLists& nodes_to_slots, Model& model) {
  const auto materials = to_host(find_slot_materials(chunked, model));
  const auto first_slot = to_host(model.chunks.first_slot);
  const int own_slots = first_slot(chunked.chunks.size());
  std::vector<int> first{0}, slots, slots_to_records(static_cast<std::size_t>(own_slots), -1), here;
  for (std::size_t n = 0; n + 1 < nodes_to_slots.first.size(); ++n) {
    const auto begin = nodes_to_slots.slots.begin() + nodes_to_slots.first[n],
               end = nodes_to_slots.slots.begin() + nodes_to_slots.first[n + 1];
    const auto material_of = [&](int slot) { return static_cast<int>(materials(static_cast<std::size_t>(slot), 0)); };
    here.clear();
    std::transform(begin, end, std::back_inserter(here), material_of);
    std::sort(here.begin(), here.end());
    here.erase(std::unique(here.begin(), here.end()), here.end());
    for (const int material : here) {
      if (material == 0) continue;
      for (auto slot = begin; slot != end; ++slot) {
        if (material_of(*slot) != material) continue;
        slots.push_back(*slot);
        if (*slot < own_slots) slots_to_records[static_cast<std::size_t>(*slot)] = static_cast<int>(first.size()) - 1;
      }
      first.push_back(static_cast<int>(slots.size()));
    }
  }
  model.tet_nodes = {static_cast<int>(first.size()) - 1, to_view("percuss::first_tet_slot", first),
                     to_view("percuss::tet_slots", slots), to_view("percuss::tet_records", slots_to_records)};
}

}  // namespace percuss
