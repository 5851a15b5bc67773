#include "kernels/shell/shell_force.hpp"

#include "kernels/element/chunk_launcher.hpp"
#include "kernels/shell/called_layer.hpp"
#include "kernels/shell/shell_corners.hpp"

namespace percuss {

/// A block of layers that are called.
template <>
struct ShellBlock<CalledLayer> {
  Array<int> chunks;
  AnyShell first;  // of the parameters

  KOKKOS_FUNCTION ShellParameters<CalledLayer> parameters(int row) const {
    ShellParameters<CalledLayer> of;
    first.visit([&](const auto* rows) { of = call_layers(rows[row]); });
    return of;
  }
};

namespace {

/// Cosine between the normal of a corner and that of its element, slope 10, at which an element that can fail counts as
/// folded, and dies. One that cannot goes on.
constexpr double shell_folded_cosine = 0.0995;

/// Body of ElementKernel. IsPlain: no chunk can fail, and no element is a triangle.
template <class Layer, bool IsPlain>
struct ShellBody {
  using Block = ShellBlock<Layer>;
  using Parameters = const ShellParameters<Layer>;  // a copy, which nothing else writes to, is faster
  using Scratch = ShellScratch;
  using Sums = ChunkSums<double>;
  using Lives = LivingLanes<double, !IsPlain>;
  static constexpr int width = shell_width;
  static constexpr int most_points = std::is_same_v<Layer, CalledLayer> ? most_layers : most_thickness_points;
  static constexpr int largest_record = find_shell_record_size(most_points, Layer::most_history) * width;
  const BlockStep<Block>& of;
  const TeamChunk& chunk;
  const Scratch& scratch;

  PERCUSS_FORCE_INLINE ShellBody(const BlockStep<Block>& of_step, const TeamChunk& of_team, const Scratch& own)
      : of(of_step), chunk(of_team), scratch(own) {}

  KOKKOS_FUNCTION static ShellParameters<Layer> find_parameters(const BlockStep<Block>& of, int c) {
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
    if (lives.can_fail()) {
      if constexpr (!IsPlain) {
        result = advance_shapes(parameters, corners, pack, find_layers(pack.first, parameters.points.count), {f, m});
        const auto is_open = Lanes(shell_folded_cosine) < result.least_cosine;
        lives.settle(result, select(is_open, result.size, Lanes(0.0)), f, m);
      }
    } else {
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
    if (parameters.is_membrane)
      return advance_membrane(call_layers(parameters), corners, stored, out, layers, find_shapes(pack.corners));
    if constexpr (IsPlain)
      return advance_shell4(parameters, corners, stored, out, layers, Quadrilaterals{});
    else
      return advance_shell4(parameters, corners, stored, out, layers, find_shapes(pack.corners));
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
  constexpr bool is_compiled_in = std::is_same_v<Layer, ElasticLayer> || std::is_same_v<Layer, J2Layer>;
  if constexpr (!is_compiled_in)
    launch_elements<ShellBody<CalledLayer, false>>(
        label, space, chunks, ShellBlock<CalledLayer>{block.chunks, AnyShell(block.parameters.data())}, motion, fields);
  else if (motion.failing.first_layer.extent(0) > 0 || block.has_triangles)
    launch_elements<ShellBody<Layer, false>>(label, space, chunks, block, motion, fields);
  else
    launch_elements<ShellBody<Layer, true>>(label, space, chunks, block, motion, fields);
}

}  // namespace

void advance_shells(const ExecSpace& space, const ElementChunks& chunks, const ShellBlocks& blocks,
                    const ElementMotion& motion, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (advance_block(space, chunks, block, motion, fields), ...); }, blocks);
}

}  // namespace percuss
