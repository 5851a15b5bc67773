#include "kernels/one_point/one_point_chunks.hpp"
#include "kernels/tet/tet_packs.hpp"

namespace percuss {

namespace {

/// A pack of wedges or pyramids in the third pass (ForcePass).
template <class Shape>
struct OnePointForces {
  CornerGradient<Lanes, Shape> g;
  HourglassVectors<Lanes, Shape> gamma;
  ModeVectors<Lanes, Shape> q;  // forces of the modes
  Lanes mass;

  KOKKOS_FUNCTION OnePointForces(const SolidScratch& scratch, const ChunkPack& pack) {
    CornerField<Lanes, Shape> x;
    scratch.gather(0, pack.corners, x.at);
    g = find_corner_gradient(x);
    gamma = find_hourglass_vectors(x, g);
    const auto* const record = reinterpret_cast<const double*>(pack.record);
    mass = load_pack(record);
    const double* mode = record + OnePointRecord<Shape>::hourglass * solid_width;
    for (auto& of : q.at) {
      of = {load_pack(mode), load_pack(mode + solid_width), load_pack(mode + 2 * solid_width)};
      mode += 3 * solid_width;
    }
  }

  KOKKOS_FUNCTION const Lanes& volume() const { return g.volume; }
  /// The bound of the element with the moduli that it feels (kernels/tet/mixing.hpp).
  KOKKOS_FUNCTION Lanes find_step(const TetStiffness<Lanes>& felt, const double* scalars) const {
    const Lanes lambda = larger(felt.bulk - Lanes(2.0 / 3.0) * felt.shear, Lanes(0.0));
    return find_one_point_step(
        find_gradient_sizes(g, gamma), g.volume, mass,
        {lambda, felt.shear, load_pack(scalars + TetPasses::hourglass * solid_width), felt.tangent});
  }
  KOKKOS_FUNCTION void scale(const Lanes& share) {
    for (auto& mode : q.at) mode = share * mode;
  }
  KOKKOS_FUNCTION void find_forces(const Symmetric3<Lanes>& stress, CornerField<Lanes, Shape>& f) const {
    find_corner_forces(stress, q, g, gamma, f);
  }
};

}  // namespace

void advance_plain(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                   const ElementMotion& motion, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_plain_of(space, chunks, block, motion, fields); });
}

void sum_rates(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks, const TetStep& step,
               const ChunkFields& fields) {
  sum_rates_of(space, chunks, blocks, step, fields);
}

void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                      const TetStep& step, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_stresses_of(space, chunks, block, step, fields); });
}

void sum_forces(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks, const TetStep& step,
                const ChunkFields& fields) {
  sum_forces_of<OnePointForces>(space, chunks, blocks, step, fields);
}

}  // namespace percuss
