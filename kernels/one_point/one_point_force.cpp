#include "kernels/element/solid_packs.hpp"
#include "kernels/one_point/one_point_chunks.hpp"
#include "kernels/tet/tet_packs.hpp"

namespace percuss {

namespace {

/// Third pass of the mixed form. L: Lanes.
template <class L, class Shape>
struct FindOnePointForces : ForcePass<L, Shape> {
  using Base = ForcePass<L, Shape>;
  using Base::chunks;
  using Base::fields;
  using Base::launch;
  using Base::motion;
  using typename Base::Living;
  using typename Base::Scratch;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->sum_chunk(member, [&](const SolidPack& on, const Living& living, SolidSums& sums, const Scratch& scratch) {
      leave_pack(on, living, sums, scratch);
    });
    if (motion.watch.bound.extent(0) > 0) motion.watch.growth(this->list(member.league_rank())) = 0;
  }

  /// Forces by the shares of the lanes; others' stresses act in full on a lane that lives.
  KOKKOS_FUNCTION void leave_pack(const SolidPack& on, const Living& living, SolidSums& sums,
                                  const Scratch& scratch) const {
    CornerField<Lanes, Shape> x, f;
    gather_corners<Shape::corners>(scratch.nodes, node_record, on.corners, x);
    const CornerGradient<Lanes, Shape> g = find_corner_gradient(x);
    const HourglassVectors<Lanes, Shape> gamma = find_hourglass_vectors(x, g);
    const TetMeans<Lanes> means = TetGather{scratch.means}.template find_means<Shape::corners>(on.corners);
    const double* const record = find_pack_record(chunks, fields.state, on.chunk.c, on.pack);
    OwnStress own(find_scalars(chunks, launch.passes, on.chunk.c, on.pack));
    ModeVectors<Lanes, Shape> q = load_modes(record);
    Lanes step = find_step(on, g, gamma, means, load_pack(record)), volume = g.volume, share(1.0);
    if (living.can_fail()) {
      share = living.take_force_share(step, volume);
      own.scale(share);
      for (auto& mode : q.at) mode = share * mode;
    }
    find_corner_forces(find_mixed_stress(own.stress, means.stress, own.guard, own.viscous_pressure), q, g, gamma, f);
    if (living.can_fail()) {
      settle_forces<Shape::corners>(select(share < Lanes(0.0), share, Lanes(1.0)), f);
      settle_step(share, step, volume);
    }
    Base::leave_forces(f, scratch.find_given(on.pack));
    on.take_step(step, volume, sums);
    on.leave_bound(motion.watch, step);
  }

  static PERCUSS_FORCE_INLINE ModeVectors<Lanes, Shape> load_modes(const double* record) {
    ModeVectors<Lanes, Shape> q;
    const double* mode = record + OnePointRecord<Shape>::hourglass * solid_width;
    for (auto& of : q.at) {
      of = {load_pack(mode), load_pack(mode + solid_width), load_pack(mode + 2 * solid_width)};
      mode += 3 * solid_width;
    }
    return q;
  }

  /// The bound of the element with the moduli that it feels (kernels/tet/mixing.hpp).
  KOKKOS_FUNCTION Lanes find_step(const SolidPack& on, const CornerGradient<Lanes, Shape>& g,
                                  const HourglassVectors<Lanes, Shape>& gamma, const TetMeans<Lanes>& means,
                                  const Lanes& mass) const {
    const double* const scalars = find_scalars(chunks, launch.passes, on.chunk.c, on.pack);
    const auto load = [&](int k) { return load_pack(scalars + k * solid_width); };
    const TetStiffness<Lanes> felt = mix_moduli({Lanes(0.0), load(TetPasses::shear), load(TetPasses::tangent)}, means,
                                                load(TetPasses::guard_modulus));
    const Lanes lambda = larger(felt.bulk - Lanes(2.0 / 3.0) * felt.shear, Lanes(0.0));
    return find_one_point_step(find_gradient_sizes(g, gamma), g.volume, mass,
                               {lambda, felt.shear, load(TetPasses::hourglass), felt.tangent});
  }
};

template <class Run>
void for_each_block(const OnePointBlocks& blocks, const Run& run) {
  std::apply([&](const auto&... block) { (run(block), ...); }, blocks);
}

template <class Material, class Shape>
void sum_rates(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlock<Material, Shape>& block,
               const TetStep& step, const ChunkResults& results) {
  if constexpr (!is_single_precision) {
    launch_pass("percuss::sum_one_point_rates", space, chunks, block.chunks,
                SumRates<Lanes, Shape>{chunks, block.chunks, step.motion, step.launch, results});
  }
}

template <class Material, class Shape>
void sum_forces(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlock<Material, Shape>& block,
                const TetStep& step, const ChunkFields& fields) {
  if constexpr (!is_single_precision) {
    launch_pass("percuss::sum_one_point_forces", space, chunks, block.chunks,
                FindOnePointForces<Lanes, Shape>{{chunks, block.chunks, step.motion, step.launch, fields}});
  }
}

}  // namespace

void advance_one_points(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_block(space, chunks, block, motion, fields); });
}

void sum_one_point_rates(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                         const TetStep& step, const ChunkResults& results) {
  for_each_block(blocks, [&](const auto& block) { sum_rates(space, chunks, block, step, results); });
}

void advance_one_point_stresses(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                                const TetStep& step, const Array<Real>& state, const ChunkResults& results) {
  for_each_block(blocks, [&](const auto& block) { advance_stresses(space, chunks, block, step, state, results); });
}

void sum_one_point_forces(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                          const TetStep& step, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { sum_forces(space, chunks, block, step, fields); });
}

}  // namespace percuss
