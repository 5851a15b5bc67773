#include "kernels/element/stiffness_damping.hpp"

#include "kernels/element/chunk_records.hpp"
#include "kernels/element/living_lanes.hpp"

namespace percuss {

namespace {

constexpr int width = pack_size<Real>;

struct DampSolidChunk {
  ElementChunks chunks;
  DampedSolids damped;
  ElementMotion motion;
  DampingFields fields;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = damped.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c);
    const int slot_count = chunks.first_slot(c + 1) - first_slot;
    const HexScratch scratch(member, slot_count);
    const int* const slots_to_nodes = &chunks.slots_to_nodes(first_slot);
    const std::size_t middle = 3 * static_cast<std::size_t>(slots_to_nodes[slot_count / 2]);
    const double* const x = motion.x.data();
    const double* const v = motion.v.data();
    for (int s = 0; s < slot_count; ++s) {
      const std::size_t n = 3 * static_cast<std::size_t>(slots_to_nodes[s]);
      fill_row(x + n, x + middle, scratch.nodes + node_record * s);
      fill_row(v + n, v + middle, scratch.nodes + node_record * s + 4);
      clear_record(scratch.forces + force_record * s);
    }
    damp_packs(c, scratch.nodes, scratch.forces);
    const double power = set_damping(motion.v, {slots_to_nodes, first_slot, slot_count}, {scratch.forces, force_record},
                                     fields.force, fields.slot_force);
    fields.work(c, viscous_work) -= 0.5 * motion.dt * power;
  }

  KOKKOS_FUNCTION void damp_packs(int c, const Real* nodes, double* forces) const {
    const DampingModuli moduli{damped.lambda(c), damped.mu(c)};
    const DampedKind kind = damped.kind(c);
    const int first = chunks.first_element(c), end = chunks.first_element(c + 1);
    const std::uint16_t* next_corners =
        &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * 8 * width);
    LivingLanes living(motion.failing, motion.lives, c);
    for (int e = first; e < end; e += width, next_corners += 8 * width) {
      const int lanes = end - e < width ? end - e : width;
      const std::uint16_t* corners = next_corners;
      if (living.can_fail() && !living.take_pack(corners)) continue;
      VectorModes<HexLanes> a, v;
      gather_modes(nodes, corners, a);
      gather_modes(nodes + 4, corners, v);
      HexLanes f[3][8];
      if (kind == DampedKind::full)
        find_full_damping(moduli, a, v, CornerForces<HexLanes>{f[0], f[1], f[2]});
      else if (kind == DampedKind::thick)
        find_thick_damping(moduli, a, v, CornerForces<HexLanes>{f[0], f[1], f[2]});
      else
        find_mean_damping(moduli, a, v, CornerForces<HexLanes>{f[0], f[1], f[2]});
      if (living.can_fail()) {
        const HexLanes none(0);
        HexResult<HexLanes> result{{none, none, none, none}, HexLanes(beyond_all<Real>), HexLanes(1), HexLanes(1)};
        living.settle(result, f);
      }
      scatter_forces(f, corners, lanes, forces);
    }
  }
};

}  // namespace

void damp_solids(const ExecSpace& space, const ElementChunks& chunks, const DampedSolids& damped,
                 const ElementMotion& motion, const DampingFields& fields) {
  const int count = static_cast<int>(damped.chunks.extent(0));
  if (count == 0) return;
  const ChunkPolicy policy = HexScratch::make_policy(space, count, chunks.largest_slot_count);
  Kokkos::parallel_for("percuss::damp_solids", policy, DampSolidChunk{chunks, damped, motion, fields});
}

}  // namespace percuss
