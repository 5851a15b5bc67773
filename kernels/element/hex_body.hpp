#pragma once
// The hexahedra of a chunk in a step.
//
// The body of an element is compiled for each compiled-in material and each kind of element (advance_hexahedra.cpp);
// every other material shares one body and is called.

#include "kernels/element/chunk_launcher.hpp"
#include "kernels/element/hex8/fold_resistance.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/hex_packs.hpp"
#include "kernels/element/solid_body.hpp"

namespace percuss {

/// A pack whose elements may resist folding: what its own body need not keep for that.
struct FoldingPack {
  const Real* nodes;
  const std::uint16_t* corners;
  Real dt, modulus, threshold;
  bool is_near;  // whether an element is known to be near folding
};

/// Adds the resistance of a pack to its forces, if an element is near folding. A call that gathers the motion anew: the
/// body of the element keeps its registers.
PERCUSS_NO_INLINE inline FoldResult<HexLanes> resist_folding_of_pack(const FoldingPack& pack, const HexLanes& mass,
                                                                     const HexLanes& stable_step, HexLanes (&f)[3][8]) {
  VectorModes<HexLanes> a, v;
  gather_modes(pack.nodes, pack.corners, a);
  const HexLanes threshold(pack.threshold);
  if (!pack.is_near && !is_near_folding(threshold, a, find_volume_gradient(a).volume))
    return {HexLanes(0), stable_step, false, false};
  gather_modes(pack.nodes + 4, pack.corners, v);
  return add_fold_resistance(FoldRule<HexLanes>{HexLanes(pack.modulus), threshold},
                             FoldMotion<HexLanes>{a, v, HexLanes(pack.dt)}, mass, stable_step, f);
}

/// Largest growth of the lanes; NaN if the first one's is.
PERCUSS_FORCE_INLINE double reduce_growth(const HexLanes& value) {
  constexpr int width = pack_size<Real>;
  alignas(64) Real row[width];
  store_pack(row, value);
  Real largest = row[0];
  for (int lane = 1; lane < width; ++lane) largest = larger(largest, row[lane]);
  return largest;
}

/// Place of point p in the coordinates of the element.
template <HexKind Kind>
PERCUSS_FORCE_INLINE GaussPoint find_hex_point(int p) {
  GaussPoint at = find_gauss_point(is_thick<Kind> ? p % 4 : p);
  if constexpr (is_thick<Kind>) at.zeta = LayerRule<layers_of<Kind>>::place[p / 4];
  if constexpr (hex_points<Kind> == 1) at = {0, 0, 0};
  return at;
}

/// Where the points are in space, into the history of a material that asks for it. a: modes of the places.
template <HexKind Kind, class T, class State>
PERCUSS_NO_INLINE void leave_places(const CalledMaterial& material, const Vector3<T>& center, const VectorModes<T>& a,
                                    State& state) {
  const T eighth = number<T>(0.125);
  for (int p = 0; p < hex_points<Kind>; ++p) {
    const auto [xi, eta, zeta] = find_hex_point<Kind>(p);
    const double phi[7] = {xi, eta, zeta, eta * zeta, zeta * xi, xi * eta, xi * eta * zeta};
    Vector3<T> x = center;
    for (int m = 1; m <= 7; ++m) x = x + (eighth * number<T>(phi[m - 1])) * a[m];
    const T place[3] = {x.x, x.y, x.z};
    for (int k = 0; k < 3; ++k) {
      state.history.value[material.place + k][p] = place[k];
      if constexpr (is_short<T>) state.history.value[material.count_history() + material.place + k][p] = T(0);
    }
  }
}

/// Body of ElementKernel. Packs resist folding that are oblique, and all while an element of the chunk resists, whose
/// work of the step needs the force at n.
template <class Material, HexKind Kind>
class HexBody : public SolidMaterial<HexBlock<Material, Kind>> {
 public:
  using Block = HexBlock<Material, Kind>;
  using Parameters = const SolidParameters<Material>;
  using Scratch = HexScratch;
  using Sums = ChunkSums<Real>;
  using Lives = LivingLanes<Real>;
  using Of = BlockStep<Block>;
  static constexpr int largest_record = hex_record_size<Material, Kind> * TeamChunk::width;

  PERCUSS_FORCE_INLINE HexBody(const Of& of, const TeamChunk& chunk, const Scratch& scratch)
      : of_(of), chunk_(chunk), scratch_(scratch), watches_step_(of.motion.watch.bound.extent(0) > 0) {
    if (of.chunks.fold_threshold.extent(0) == 0) return;
    fold_threshold_ = of.chunks.fold_threshold(chunk.c);
    resisted_ = of.fields.results.resists(chunk.c) != 0;
  }

  /// Known to the compiler, except for called materials, each of which has its own number.
  KOKKOS_FUNCTION auto find_record_size() const {
    if constexpr (is_called<Material>) {
      return of_.chunks.record_size(chunk_.c) * TeamChunk::width;
    } else {
      return std::integral_constant<int, largest_record>();
    }
  }

  PERCUSS_FORCE_INLINE void advance(Parameters& parameters, const ChunkPack& pack, const Lives& lives, Sums& sums) {
    using State = HexState<HexLanes, Material, Kind>;
    static_assert(sizeof(State) == largest_record * sizeof(Real), "its scalars lie like the record's");
    constexpr int fetched =
        is_called<Material> ? HexRecord::history<Kind, Material> * TeamChunk::width : largest_record;
    VectorModes<HexLanes> a, v;
    pack.fetch_third(fetched, 0);
    gather_modes(scratch_.nodes, pack.corners, a);
    pack.fetch_third(fetched, 1);
    gather_modes(scratch_.nodes + 4, pack.corners, v);
    auto& state = *reinterpret_cast<State*>(pack.record);
    if constexpr (is_called<Material>) {
      const CalledMaterial& material = parameters.material;
      if (material.place >= 0) leave_places<Kind>(material, gather_center(scratch_.nodes, pack.corners), a, state);
    }
    HexLanes f[3][8];
    HexResult<HexLanes> result =
        advance_hex8(parameters, a, v, HexLanes(static_cast<Real>(of_.motion.dt)), state, {f[0], f[1], f[2]});
    pack.fetch_third(fetched, 2);
    const bool folds = resist_folding(parameters, pack, state.mass, f, result);
    if (lives.can_fail()) settle(lives, folds, f, result);
    scatter_forces(f, pack.corners, pack.lanes, scratch_.forces);
    sums.take(result, pack);
    if (folds) sums.take_work(WorkKind::folding, result.work.folding, pack.lanes);
    if (watches_step_) watch_step(pack, result.stable_step);
  }

  KOKKOS_FUNCTION void leave() const {
    if (fold_threshold_ > 0) of_.fields.results.resists(chunk_.c) = resists_ ? 1 : 0;
    if (watches_step_) of_.motion.watch.growth(chunk_.c) = reduce_growth(growth_);
  }

 private:
  /// Returns whether an element of the pack does.
  PERCUSS_FORCE_INLINE bool resist_folding(Parameters& parameters, const ChunkPack& pack, const HexLanes& mass,
                                           HexLanes (&f)[3][8], HexResult<HexLanes>& result) {
    if (!(fold_threshold_ > 0 && (resisted_ || any(result.obliqueness > HexLanes(Real(unfolded_obliqueness))))))
      return false;
    const auto modulus = static_cast<Real>(fold_stiffness * (parameters.lambda + 2 * parameters.mu));
    const HexLanes step = result.stable_step;
    const FoldResult<HexLanes> fold = resist_folding_of_pack(
        {scratch_.nodes, pack.corners, static_cast<Real>(of_.motion.dt), modulus, fold_threshold_, resisted_}, mass,
        step, f);
    result.stable_step = fold.stable_step;
    result.work.folding = fold.work;
    resists_ = fold.resists || resists_;
    return fold.acted;
  }

  KOKKOS_FUNCTION static void settle(const Lives& lives, bool folds, HexLanes (&f)[3][8], HexResult<HexLanes>& result) {
    const HexLanes share = lives.settle(result, result.size, f);
    if (folds) lives.take_work(share, WorkKind::folding, result.work.folding);
  }

  /// Follows the bounds of a pack: growth of the square of the element's frequency since the estimate, relative to it
  /// or to the square of the mesh's frequency, whichever is larger.
  PERCUSS_FORCE_INLINE void watch_step(const ChunkPack& pack, const HexLanes& bound) {
    const StepWatch& watch = of_.motion.watch;
    const auto lane = static_cast<std::size_t>(of_.chunks.first_pack(chunk_.c)) * TeamChunk::width +
                      static_cast<std::size_t>(pack.first);
    store_pack(&watch.bound(lane), bound);
    if (watch.step <= 0) return;
    const HexLanes reference = load_pack(&watch.reference(lane));
    const HexLanes ratio = reference / bound, share = HexLanes(static_cast<Real>(watch.step)) / reference;
    growth_ = larger(growth_, (ratio * ratio - HexLanes(1)) * smaller(HexLanes(1), share * share));
  }

  const Of& of_;
  const TeamChunk& chunk_;
  const Scratch& scratch_;
  bool watches_step_, resisted_ = false, resists_ = false;  // resisted: at n
  Real fold_threshold_ = 0;
  HexLanes growth_ = HexLanes(0);
};

template <class Material, HexKind Kind>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const HexBlock<Material, Kind>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  launch_elements<HexBody<Material, Kind>>("percuss::advance_elements", space, chunks, block, motion, fields);
}

}  // namespace percuss
