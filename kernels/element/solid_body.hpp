#pragma once
// What bodies of solids share (chunk_launcher.hpp), and the body of those other than hexahedra that average nothing.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include "kernels/element/chunk_launcher.hpp"
#include "kernels/element/internal_force.hpp"

namespace percuss {

/// The material of a chunk.
template <class Block>
struct SolidMaterial {
  using Material = typename Block::Material;

  KOKKOS_FUNCTION static SolidParameters<Material> find_parameters(const BlockStep<Block>& of, int c) {
    SolidParameters<Material> parameters = of.block.parameters(of.chunks.parameters(c));
    parameters.time = of.motion.time;
    return parameters;
  }
  KOKKOS_FUNCTION static bool may_rest(const BlockStep<Block>& of, int c) {
    return !changes_at_rest(of.block.parameters(of.chunks.parameters(c)).material);
  }
};

inline constexpr int solid_width = pack_size<double>;
using SolidScratch = ChunkScratch<2, 1>;
using SolidSums = ChunkSums<double>;
using LivingSolids = LivingLanes<double>;

/// The step bounds of the elements of a pack, if they are watched.
KOKKOS_INLINE_FUNCTION void leave_bound(const StepWatch& watch, const TeamChunk& chunk, int first, const Lanes& step) {
  if (watch.bound.extent(0) == 0) return;
  alignas(64) double steps[solid_width];
  store_pack(steps, step);
  Real* const bound = &watch.bound(static_cast<std::size_t>(chunk.chunks.first_pack(chunk.c)) * solid_width +
                                   static_cast<std::size_t>(first));
  for (int lane = 0; lane < solid_width; ++lane) bound[lane] = static_cast<Real>(steps[lane]);
}
/// Their growth, which is that of hexahedra alone.
KOKKOS_INLINE_FUNCTION void leave_growth(const StepWatch& watch, int c) {
  if (watch.bound.extent(0) > 0) watch.growth(c) = 0;
}

/// The mean of the corners x, into the history of a material that asks for it.
template <class Material, class Field, class State>
PERCUSS_FORCE_INLINE void leave_place([[maybe_unused]] const Material& material, [[maybe_unused]] const Field& x,
                                      [[maybe_unused]] State& state) {
  if constexpr (is_called<Material>) {
    if (material.place < 0) return;
    constexpr int corners = sizeof(x.at) / sizeof(x.at[0]);
    Vector3<Lanes> sum = x.at[0];
    for (int i = 1; i < corners; ++i) sum = sum + x.at[i];
    const Lanes share(1.0 / corners), place[3] = {share * sum.x, share * sum.y, share * sum.z};
    for (int k = 0; k < 3; ++k) state.history.value[material.place + k][0] = place[k];
  }
}

/// Body of ElementKernel. Block: with its State, whose numbers lie like those of a record, the Field of its corners,
/// and a function advance_solid() for these.
template <class Block_>
struct SolidBody : SolidMaterial<Block_> {
  using Block = Block_;
  using Parameters = const SolidParameters<typename Block::Material>;
  using Scratch = SolidScratch;
  using Sums = SolidSums;
  using Lives = LivingSolids;
  static constexpr int largest_record = sizeof(typename Block::State) / sizeof(Real);
  const BlockStep<Block>& of;
  const TeamChunk& chunk;
  const Scratch& scratch;

  KOKKOS_FUNCTION SolidBody(const BlockStep<Block>& of_step, const TeamChunk& of_team, const Scratch& own)
      : of(of_step), chunk(of_team), scratch(own) {}

  KOKKOS_FUNCTION int find_record_size() const { return chunk.chunks.record_size(chunk.c) * solid_width; }

  PERCUSS_FORCE_INLINE void advance(Parameters& parameters, const ChunkPack& pack, const Lives& lives,
                                    Sums& sums) const {
    const int size = find_record_size();
    typename Block::Field x, v, f;
    pack.fetch_third(size, 0);
    scratch.gather(0, pack.corners, x.at);
    pack.fetch_third(size, 1);
    scratch.gather(1, pack.corners, v.at);
    pack.fetch_third(size, 2);
    auto& state = *reinterpret_cast<typename Block::State*>(pack.record);
    leave_place(parameters.material, x, state);
    auto result = advance_solid(parameters, x, v, Lanes(of.motion.dt), state, f);
    if (lives.can_fail()) lives.settle(result, result.size, f.at);
    scratch.scatter(0, f.at, pack);
    sums.take(result, pack);
    leave_bound(of.motion.watch, chunk, pack.first, result.stable_step);
  }

  KOKKOS_FUNCTION void leave() const { leave_growth(of.motion.watch, chunk.c); }
};

}  // namespace percuss
