#include "src/step/elements/build_tets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/one_point/shapes.hpp"
#include "kernels/tet/geometry.hpp"
#include "kernels/tet/mixing.hpp"
#include "kernels/tet/tet_nodes.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/error.hpp"

namespace percuss {

namespace {

/// Name of the elements in messages; null: hexahedra, or no solids.
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

/// Corners of an element of the mixed form; 0: of another family.
int count_averaged_corners(ElementFamily family) {
  switch (family) {
    case ElementFamily::tetrahedra:
      return Tet4::corners;
    case ElementFamily::wedges:
      return Wedge6::corners;
    case ElementFamily::pyramids:
      return Pyramid5::corners;
    default:
      return 0;
  }
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
  copy_values(slots, host);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), slots);
  swap.end();
  return slots;
}

/// Corners of elements at the slots of chunks, in groups (TetNodes).
class CornerGroups {
 public:
  using Lists = std::vector<std::vector<std::uint16_t>>;

  /// Adds the slots of one chunk. beyond: the element past its lanes.
  void add(const Lists& slots, int beyond) {
    std::vector<std::size_t> order(slots.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return slots[a].size() > slots[b].size(); });
    for (std::size_t first = 0; first < order.size(); first += group_size)
      add_group(slots,
                {order.begin() + static_cast<std::ptrdiff_t>(first),
                 order.begin() + static_cast<std::ptrdiff_t>(std::min(first + group_size, order.size()))},
                beyond);
    first_group_.push_back(static_cast<int>(first_corner_.size()) - 1);
  }

  void store(TetNodes& nodes) const {
    nodes.first_group = to_view("percuss::first_tet_group", first_group_);
    nodes.group_slots = to_view("percuss::tet_group_slots", group_slots_);
    nodes.first_corner = to_view("percuss::first_tet_corner", first_corner_);
    nodes.corners = to_view("percuss::tet_corners", corners_);
  }

 private:
  static constexpr std::size_t group_size = TetNodes::group_size;

  /// of: the slots of the group, that with the longest list first.
  void add_group(const Lists& slots, const std::vector<std::size_t>& of, int beyond) {
    for (std::size_t k = 0; k < group_size; ++k)
      group_slots_.push_back(static_cast<std::uint16_t>(k < of.size() ? of[k] : TetNodes::no_slot));
    const std::size_t rows = slots[of[0]].size();
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < group_size; ++k) {
        const bool has_corner = k < of.size() && i < slots[of[k]].size();
        corners_.push_back(has_corner ? slots[of[k]][i] : static_cast<std::uint16_t>(8 * beyond));
      }
    }
    first_corner_.push_back(static_cast<int>(corners_.size() / group_size));
  }

  std::vector<int> first_group_{0}, first_corner_{0};
  std::vector<std::uint16_t> group_slots_, corners_;
};

/// The corners at each slot of chunks of such elements.
void list_corners(const ElementChunks& of, TetNodes& nodes) {
  const HostChunks chunks(of);
  const auto families = to_host(of.family);
  CornerGroups groups;
  CornerGroups::Lists here;
  for (int c = 0; c < of.count; ++c) {
    const int count = count_averaged_corners(families(static_cast<std::size_t>(c)));
    const int slots = chunks.first_slot(c + 1) - chunks.first_slot(c);
    here.assign(static_cast<std::size_t>(count > 0 ? slots : 0), {});
    for (int i = 0; count > 0 && i < count_elements(chunks, c); ++i)
      for (int corner = 0; corner < count; ++corner)
        here[static_cast<std::size_t>(find_corner_slot(chunks, c, i, corner))].push_back(
            static_cast<std::uint16_t>(8 * i + corner));
    groups.add(here, count_lanes(chunks, c));
    if (count > 0) nodes.largest_lane_count = std::max(nodes.largest_lane_count, count_lanes(chunks, c));
  }
  groups.store(nodes);
}

/// Shares of the averaged deviator by chunk: 0 of laws whose stress may be as large as their moduli.
Array<double> list_deviator_shares(const Deck& deck, const ChunkedMesh& chunked) {
  std::vector<double> shares;
  shares.reserve(chunked.chunks.size());
  for (const Chunk& chunk : chunked.chunks) {
    const auto material = static_cast<std::size_t>(find_block(chunked, chunk).material);
    shares.push_back(is_stretched_far(deck.materials[material]) ? 0.0 : tet_deviator_share);
  }
  return to_view("percuss::tet_deviator_shares", shares);
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

void build_tet_nodes(const Deck& deck, const ChunkedMesh& chunked, const SlotLists& nodes_to_slots, Model& model) {
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
  TetNodes& nodes = *model.tet_nodes;
  nodes.count = static_cast<int>(first.size()) - 1;
  nodes.first = to_view("percuss::first_tet_slot", first);
  nodes.slots = to_view("percuss::tet_slots", slots);
  nodes.slots_to_records = to_view("percuss::tet_records", slots_to_records);
  nodes.deviator_share = list_deviator_shares(deck, chunked);
  list_corners(model.chunks, nodes);
}

}  // namespace percuss
