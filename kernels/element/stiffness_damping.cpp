#include "kernels/element/stiffness_damping.hpp"

#include "kernels/element/damping_launcher.hpp"
#include "kernels/element/hex_packs.hpp"

namespace percuss {

namespace {

struct HexDamping {
  using Damped = DampedSolids;
  using Scratch = HexScratch;
  const DampingStep<DampedSolids>& of;
  const TeamChunk& chunk;
  const HexScratch& scratch;

  KOKKOS_FUNCTION void damp() const {
    LivingLanes<Real> living(of.motion.failing, of.motion.lives, chunk.c);
    chunk.for_each_pack(living, nullptr, 0, [&](const ChunkPack& pack) {
      VectorModes<HexLanes> a, v;
      gather_modes(scratch.nodes, pack.corners, a);
      gather_modes(scratch.nodes + 4, pack.corners, v);
      HexLanes f[3][8];
      find_forces(a, v, {f[0], f[1], f[2]});
      if (living.can_fail()) settle_forces(living.load_force_share(), f);
      scatter_forces(f, pack.corners, pack.lanes, scratch.forces);
    });
  }

  KOKKOS_FUNCTION void find_forces(const VectorModes<HexLanes>& a, const VectorModes<HexLanes>& v,
                                   const CornerForces<HexLanes>& out) const {
    const DampingModuli moduli{of.damped.lambda(chunk.c), of.damped.mu(chunk.c)};
    const DampedKind kind = of.damped.kind(chunk.c);
    if (kind == DampedKind::full)
      find_full_damping(moduli, a, v, out);
    else if (kind == DampedKind::thick)
      find_thick_damping(moduli, a, v, out);
    else
      find_mean_damping(moduli, a, v, out);
  }
};

}  // namespace

void damp_solids(const ExecSpace& space, const ElementChunks& chunks, const DampedSolids& damped,
                 const ElementMotion& motion, const DampingFields& fields) {
  launch_damping<HexDamping>("percuss::damp_solids", space, chunks, damped, motion, fields);
}

}  // namespace percuss
