#include "kernels/element/elastic_operator.hpp"

#include "kernels/element/chunk_records.hpp"
#include "kernels/element/hex8/hex_record.hpp"

namespace percuss {

namespace {

constexpr int width = pack_size<Real>;

template <class Material, HexKind Kind>
struct ProbeChunk {
  ElementChunks chunks;
  HexBlock<Material, Kind> block;
  ElasticProbe probe;
  Array<Real> state;
  ChunkResults results;
  Rows3<double> slot_force;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = block.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c);
    const int slot_count = chunks.first_slot(c + 1) - first_slot;
    const HexScratch scratch(member, slot_count);
    Real* const nodes = scratch.nodes;
    double* const forces = scratch.forces;
    const std::size_t middle = 3 * static_cast<std::size_t>(chunks.slots_to_nodes(first_slot + slot_count / 2));
    for (int s = 0; s < slot_count; ++s) {
      const std::size_t n = 3 * static_cast<std::size_t>(chunks.slots_to_nodes(first_slot + s));
      fill_row(probe.x.data() + n, probe.x.data() + middle, nodes + node_record * s);
      fill_row(probe.u.data() + n, probe.u.data() + middle, nodes + node_record * s + 4);
      clear_record(forces + force_record * s);
    }
    // A called material gives its moduli with the bound only.
    const bool knows_bound_only = is_called<Material> || results.stable_step(c) > probe.coarse || resists_folding(c);
    if (knows_bound_only) add_bound(c, forces);
    if constexpr (!is_called<Material>) {
      if (!knows_bound_only) probe_packs(c, nodes, forces);
    }
    copy_force_rows(forces, slot_count, &slot_force(first_slot, 0));
  }

  /// Its resistance is in the bound, not in the operator.
  KOKKOS_FUNCTION bool resists_folding(int c) const {
    return chunks.fold_threshold.extent(0) > 0 && results.resists(c) != 0;
  }

  KOKKOS_FUNCTION const Real* find_record(int c, int pack) const {
    return &state(chunks.first_state(c)) + static_cast<std::size_t>(pack * chunks.record_size(c) * width);
  }
  KOKKOS_FUNCTION const std::uint16_t* find_corners(int c, int pack) const {
    return &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c) + pack) * 8 * width);
  }

  static KOKKOS_FUNCTION Symmetric3<HexLanes> load_tensor(const Real* at) {
    return {load_pack(at),
            load_pack(at + width),
            load_pack(at + 2 * width),
            load_pack(at + 3 * width),
            load_pack(at + 4 * width),
            load_pack(at + 5 * width)};
  }
  /// The largest of the points of an elastic element.
  static KOKKOS_FUNCTION HexLanes find_pressure(const Real* record) {
    HexLanes largest(0);
    if constexpr (is_elastic<Material>) {
      for (int p = 0; p < hex_points<Kind>; ++p)
        largest = larger(largest, bound_pressure(load_tensor(record + (HexRecord::stress + 6 * p) * width)));
    }
    return largest;
  }

  KOKKOS_FUNCTION void probe_packs(int c, const Real* nodes, double* forces) const {
    const SolidParameters<Material> parameters = block.parameters(chunks.parameters(c));
    const int count = chunks.first_element(c + 1) - chunks.first_element(c);
    for (int i = 0; i * width < count; ++i) {
      const std::uint16_t* corners = find_corners(c, i);
      VectorModes<HexLanes> a, u;
      gather_modes(nodes, corners, a);
      gather_modes(nodes + 4, corners, u);
      const Real* record = find_record(c, i);
      const ProbedElement<HexLanes> element{load_pack(record + HexRecord::mass * width),
                                            load_pack(record + HexRecord::viscous_pressure * width),
                                            HexLanes(static_cast<Real>(probe.step)),
                                            load_tensor(record + HexRecord::stretch * width), find_pressure(record)};
      HexLanes f[3][8];
      probe_hex8<Kind>(parameters, a, u, element, {f[0], f[1], f[2]});
      scatter_forces(f, corners, count - i * width < width ? count - i * width : width, forces);
    }
  }

  /// Each corner has an eighth of its element's mass.
  KOKKOS_FUNCTION void add_bound(int c, double* forces) const {
    const double ratio = probe.step / results.stable_step(c);
    const int count = chunks.first_element(c + 1) - chunks.first_element(c);
    for (int e = 0; e < count; ++e) {
      const double share = 0.125 * ratio * ratio * find_record(c, e / width)[HexRecord::mass * width + e % width];
      for (int i = 0; i < 8; ++i) {
        const int s = find_corners(c, e / width)[i * width + e % width];
        const std::size_t n = static_cast<std::size_t>(chunks.slots_to_nodes(chunks.first_slot(c) + s));
        for (int k = 0; k < 3; ++k) forces[force_record * s + k] -= share * probe.u(n, k);
      }
    }
  }
};

template <class Material, HexKind Kind>
void probe_block(const ExecSpace& space, const ElementChunks& chunks, const HexBlock<Material, Kind>& block,
                 const ElasticProbe& probe, const ChunkFields& fields) {
  const int count = static_cast<int>(block.chunks.extent(0));
  if (count == 0) return;
  using Kernel = ProbeChunk<Material, Kind>;
  const ChunkPolicy policy = HexScratch::make_policy(space, count, chunks.largest_slot_count);
  Kokkos::parallel_for("percuss::apply_elastic_operator", policy,
                       Kernel{chunks, block, probe, fields.state, fields.results, fields.slot_force});
}

}  // namespace

void apply_elastic_operator(const ExecSpace& space, const ElementChunks& chunks, const HexBlocks& blocks,
                            const ElasticProbe& probe, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (probe_block(space, chunks, block, probe, fields), ...); }, blocks);
}

}  // namespace percuss
