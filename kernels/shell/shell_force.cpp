#include "kernels/shell/shell_force.hpp"

#include "kernels/element/chunk_launcher.hpp"
#include "kernels/shell/membrane.hpp"
#include "kernels/shell/shell_corners.hpp"

namespace percuss {

namespace {

/// Cosine between the normal of a corner and that of its element, slope 10, at which an element that can fail counts as
/// folded, and dies. One that cannot goes on.
constexpr double shell_folded_cosine = 0.0995;

/// Body of ElementKernel. CanFail: some chunks can; HasTriangles: some elements are triangles. Bodies of elements that
/// can fail always look for triangles: a body without would take longer to compile than it saves in a step (2 %).
template <class Layer, bool CanFail, bool HasTriangles>
struct ShellBody {
  using Block = ShellBlock<Layer>;
  // A copy, which nothing else writes to, is faster; that of a laminate is too large.
  using Parameters = std::conditional_t<has_plies<Layer>, const ShellParameters<Layer>&, const ShellParameters<Layer>>;
  using Scratch = ShellScratch;
  using Sums = ChunkSums<double>;
  using Lives = LivingLanes<double, CanFail>;
  static constexpr int width = shell_width;
  static constexpr int most_points = has_plies<Layer> ? most_layers : most_thickness_points;
  static constexpr int largest_record = find_shell_record_size(most_points, Layer::most_history) * width;
  const BlockStep<Block>& of;
  const TeamChunk& chunk;
  const Scratch& scratch;

  PERCUSS_FORCE_INLINE ShellBody(const BlockStep<Block>& of_step, const TeamChunk& of_team, const Scratch& own)
      : of(of_step), chunk(of_team), scratch(own) {}

  KOKKOS_FUNCTION static const ShellParameters<Layer>& find_parameters(const BlockStep<Block>& of, int c) {
    return of.block.parameters(of.chunks.parameters(c));
  }
  KOKKOS_FUNCTION static bool may_rest(const BlockStep<Block>&, int) { return true; }
  KOKKOS_FUNCTION int find_record_size() const { return chunk.chunks.record_size(chunk.c) * width; }

  KOKKOS_FUNCTION void advance(const ShellParameters<Layer>& parameters, const ChunkPack& pack, const Lives& lives,
                               Sums& sums) const {
    const GatheredShells gathered(scratch, pack.corners);
    const CornerMotion<Lanes> corners{find_differences(gathered.x), find_differences(gathered.v), gathered.w,
                                      Lanes(of.motion.dt)};
    Vector3<Lanes> f[4], m[4];
    ShellResult<Lanes> result;
    if constexpr (CanFail) {
      if (lives.can_fail()) {
        result = advance_shapes(parameters, corners, pack, find_layers(pack.first, parameters.points.count), {f, m});
        const auto is_open = Lanes(shell_folded_cosine) < result.least_cosine;
        lives.settle(result, select(is_open, result.size, Lanes(0.0)), f, m);
      } else {
        result = advance_shapes(parameters, corners, pack, WholeLayers{}, {f, m});
      }
    } else {  // a body for layers that fail is not compiled
      result = advance_shapes(parameters, corners, pack, WholeLayers{}, {f, m});
    }
    scratch.scatter(0, f, pack);
    scratch.scatter(1, m, pack);
    sums.take(result, pack);
    if (of.motion.bound.extent(0) > 0) leave_bounds(pack, result.stable_step);
  }

  template <class Layers>
  PERCUSS_FORCE_INLINE static ShellResult<Lanes> advance_shapes(const ShellParameters<Layer>& parameters,
                                                                const CornerMotion<Lanes>& corners,
                                                                const ChunkPack& pack, const Layers& layers,
                                                                const CornerLoads<Lanes>& out) {
    static_assert(sizeof(ShellState<Lanes>) == ShellRecord::layers * sizeof(Lanes),
                  "its scalars lie like the record's");
    auto* const record = reinterpret_cast<Lanes*>(pack.record);
    const StoredShell<Lanes> stored{*reinterpret_cast<ShellState<Lanes>*>(record), record + ShellRecord::layers};
    if constexpr (HasTriangles) {
      return advance_stored(parameters, corners, stored, out, layers, find_shapes(pack.corners));
    } else {
      return advance_stored(parameters, corners, stored, out, layers, Quadrilaterals{});
    }
  }

  template <class Layers, class Shapes>
  PERCUSS_FORCE_INLINE static ShellResult<Lanes> advance_stored(const ShellParameters<Layer>& parameters,
                                                                const CornerMotion<Lanes>& corners,
                                                                const StoredShell<Lanes>& stored,
                                                                const CornerLoads<Lanes>& out, const Layers& layers,
                                                                const Shapes& shapes) {
    if constexpr (!is_fabric<Layer>) {
      if (!parameters.is_membrane) return advance_shell4(parameters, corners, stored, out, layers, shapes);
    }
    return advance_membrane(parameters, corners, stored, out, layers, shapes);
  }

  /// Layers of a pack that can fail. first: its first element.
  KOKKOS_FUNCTION FailingLayers<Lanes> find_layers(int first, int points) const {
    double* const rows = &of.motion.lives.layers(of.motion.failing.first_layer(chunk.c));
    return {reinterpret_cast<Lanes*>(rows + first * LayerLives::count_rows(points))};
  }

  KOKKOS_FUNCTION void leave_bounds(const ChunkPack& pack, const Lanes& step) const {
    alignas(64) double steps[width];
    store_pack(steps, step);
    for (int lane = 0; lane < pack.lanes; ++lane)
      of.motion.bound(chunk.first_element + pack.first + lane) = steps[lane];
  }

  KOKKOS_FUNCTION void leave() const {}
};

template <class Layer>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const ShellBlock<Layer>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  constexpr const char* label = "percuss::advance_shells";
  if (motion.failing.first_layer.extent(0) > 0)
    launch_elements<ShellBody<Layer, true, true>>(label, space, chunks, block, motion, fields);
  else if (block.has_triangles)
    launch_elements<ShellBody<Layer, false, true>>(label, space, chunks, block, motion, fields);
  else
    launch_elements<ShellBody<Layer, false, false>>(label, space, chunks, block, motion, fields);
}

}  // namespace

void advance_shells(const ExecSpace& space, const ElementChunks& chunks, const ShellBlocks& blocks,
                    const ElementMotion& motion, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (advance_block(space, chunks, block, motion, fields), ...); }, blocks);
}

}  // namespace percuss
