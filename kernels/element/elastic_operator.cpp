#include "kernels/element/elastic_operator.hpp"

#include "kernels/element/element_records.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/hex_packs.hpp"

namespace percuss {

namespace {

constexpr int width = pack_size<Real>;

template <class Material, HexKind Kind>
struct ProbeChunk {
  using Scratch = HexScratch;
  ElementChunks chunks;
  HexBlock<Material, Kind> block;
  ElasticProbe probe;
  ChunkFields fields;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const TeamChunk chunk(chunks, block.chunks(member.league_rank()));
    const HexScratch scratch(member, chunk.slot_count);
    scratch.fill_rows(chunk, probe.x.data(), probe.u.data());
    scratch.clear(chunk);
    // A called material gives its moduli with the bound only.
    const bool knows_bound_only =
        is_called<Material> || fields.results.stable_step(chunk.c) > probe.coarse || resists_folding(chunk.c);
    if (knows_bound_only) add_bound(chunk, scratch.forces);
    if constexpr (!is_called<Material>) {
      if (!knows_bound_only) probe_packs(chunk, scratch);
    }
    scratch.leave(chunk, fields.slot_force, {});
  }

  /// Its resistance is in the bound, not in the operator.
  KOKKOS_FUNCTION bool resists_folding(int c) const {
    return chunks.fold_threshold.extent(0) > 0 && fields.results.resists(c) != 0;
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

  KOKKOS_FUNCTION void probe_packs(const TeamChunk& chunk, const HexScratch& scratch) const {
    const SolidParameters<Material> parameters = block.parameters(chunks.parameters(chunk.c));
    WholeLanes whole;
    chunk.for_each_pack(whole, &fields.state(chunks.first_state(chunk.c)), chunks.record_size(chunk.c) * width,
                        [&](const ChunkPack& pack) {
                          VectorModes<HexLanes> a, u;
                          gather_modes(scratch.nodes, pack.corners, a);
                          gather_modes(scratch.nodes + 4, pack.corners, u);
                          const Real* const record = pack.record;
                          const ProbedElement<HexLanes> element{load_pack(record + HexRecord::mass * width),
                                                                load_pack(record + HexRecord::viscous_pressure * width),
                                                                HexLanes(static_cast<Real>(probe.step)),
                                                                load_tensor(record + HexRecord::stretch * width),
                                                                find_pressure(record)};
                          HexLanes f[3][8];
                          probe_hex8<Kind>(parameters, a, u, element, {f[0], f[1], f[2]});
                          scatter_forces(f, pack.corners, pack.lanes, scratch.forces);
                        });
  }

  /// Each corner has an eighth of its element's mass.
  KOKKOS_FUNCTION void add_bound(const TeamChunk& chunk, double* forces) const {
    const double ratio = probe.step / fields.results.stable_step(chunk.c);
    for (int e = 0; e < chunk.count; ++e) {
      const ElementRecord record = find_record(chunks, fields.state, chunk.c, e);
      const double share = 0.125 * ratio * ratio * record.get(HexRecord::mass);
      for (int i = 0; i < 8; ++i) {
        const int s = find_corner_slot(chunks, chunk.c, e, i);
        for (int k = 0; k < 3; ++k) forces[HexScratch::force_size * s + k] -= share * probe.u(chunk.nodes()[s], k);
      }
    }
  }
};

template <class Material, HexKind Kind>
void probe_block(const ExecSpace& space, const ElementChunks& chunks, const HexBlock<Material, Kind>& block,
                 const ElasticProbe& probe, const ChunkFields& fields) {
  launch_chunks("percuss::apply_elastic_operator", space, chunks, block.chunks,
                ProbeChunk<Material, Kind>{chunks, block, probe, fields});
}

}  // namespace

void apply_elastic_operator(const ExecSpace& space, const ElementChunks& chunks, const HexBlocks& blocks,
                            const ElasticProbe& probe, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (probe_block(space, chunks, block, probe, fields), ...); }, blocks);
}

}  // namespace percuss
