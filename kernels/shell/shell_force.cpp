#include "kernels/shell/shell_force.hpp"

#include "kernels/element/chunk_rest.hpp"
#include "kernels/element/chunk_sums.hpp"
#include "kernels/shell/living_shells.hpp"
#include "kernels/shell/membrane.hpp"
#include "kernels/shell/shell_corners.hpp"

namespace percuss {

namespace {

constexpr int width = shell_width;

/// Those of the first `lanes` elements of a pack.
PERCUSS_NO_INLINE inline void store_bounds(const Lanes& step, int lanes, double* bounds) {
  alignas(64) double steps[width];
  store_pack(steps, step);
  for (int lane = 0; lane < lanes; ++lane) bounds[lane] = steps[lane];
}

/// CanFail: some chunks can; HasTriangles: some elements are; without them nobody asks. Those that can fail are asked
/// all the same: a body of their own would take longer to compile than it saves in a step (2 %).
template <class Layer, bool CanFail, bool HasTriangles>
struct AdvanceShellChunk {
  ElementChunks chunks;
  ShellBlock<Layer> block;
  ShellMotion motion;
  Array<Real> state;
  Rows3<double> slot_force, slot_moment;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = block.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c);
    const int slot_count = chunks.first_slot(c + 1) - first_slot;
    const int* const slots_to_nodes = &chunks.slots_to_nodes(first_slot);
    const ChunkRest rest(chunks, results, c, motion.skips_rest, motion.v, motion.w);
    if (rest.skips()) return;
    const ShellScratch scratch(member, slot_count);
    double* const nodes = scratch.nodes;
    double* const forces = scratch.forces;
    for (int s = 0; s < slot_count; ++s) {
      const std::size_t n = 3 * static_cast<std::size_t>(slots_to_nodes[s]);
      double* const node = nodes + shell_node_record * s;
      copy_row(motion.x.data() + n, node);
      copy_row(motion.v.data() + n, node + 4);
      copy_row(motion.w.data() + n, node + 8);
      for (int k = 0; k < shell_force_record; ++k) forces[shell_force_record * s + k] = 0;
    }
    rest.leave(advance_packs(c, scratch, rest.is_at_rest()));
    for (int s = 0; s < slot_count; ++s) {
      copy_row(forces + shell_force_record * s, &slot_force(first_slot + s, 0));
      copy_row(forces + shell_force_record * s + 4, &slot_moment(first_slot + s, 0));
    }
  }

  /// Returns whether a bit of the records has changed, if watched.
  KOKKOS_FUNCTION bool advance_packs(int c, const ShellScratch& scratch, bool watched) const {
    // A copy, which nothing else writes to, is faster; that of a laminate is too large.
    using Parameters =
        std::conditional_t<has_plies<Layer>, const ShellParameters<Layer>&, const ShellParameters<Layer>>;
    Parameters parameters = block.parameters(chunks.parameters(c));
    constexpr int most_points = has_plies<Layer> ? most_layers : most_thickness_points;
    constexpr int largest_record = find_shell_record_size(most_points, Layer::most_history) * width;
    const int record_size = chunks.record_size(c) * width;
    const int first = chunks.first_element(c), end = chunks.first_element(c + 1);
    auto* record = reinterpret_cast<double*>(&state(chunks.first_state(c)));
    const std::uint16_t* corners =
        &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * corners_of_shell_pack);
    ChunkSums<double> sums;
    RecordWatch<largest_record, double> watch(watched);
    [[maybe_unused]] LivingShells<Lanes> living(motion.failing, motion.lives, c, parameters.points.count);
    for (int e = first; e < end; e += width, record += record_size, corners += corners_of_shell_pack) {
      const int lanes = end - e < width ? end - e : width;
      const std::uint16_t* gathered = corners;
      if constexpr (CanFail) {
        if (living.can_fail() && !living.take_pack(gathered)) continue;
      }
      watch.keep(record, record_size);
      const ShellResult<Lanes> result = advance_pack(parameters, scratch, gathered, lanes, record, living);
      sums.take_work(result.work, lanes);
      sums.take_step(result.stable_step, result.area, e - first, lanes);
      if (motion.bound.extent(0) > 0) store_bounds(result.stable_step, lanes, &motion.bound(e));
      watch.compare(record, record_size);
    }
    sums.leave_work(c, results);
    sums.leave_step(c, first, end - first, results);
    return watch.has_changed();
  }

  KOKKOS_FUNCTION ShellResult<Lanes> advance_pack(const ShellParameters<Layer>& parameters, const ShellScratch& scratch,
                                                  const std::uint16_t* corners, int lanes, double* record,
                                                  [[maybe_unused]] const LivingShells<Lanes>& living) const {
    Vector3<Lanes> x[4], v[4], w[4], f[4], m[4];
    gather_corners(scratch.nodes, corners, x);
    gather_corners(scratch.nodes + 4, corners, v);
    gather_corners(scratch.nodes + 8, corners, w);
    auto& head = *reinterpret_cast<ShellState<Lanes>*>(record);  // its scalars lie like the record's
    static_assert(sizeof(ShellState<Lanes>) == ShellRecord::layers * sizeof(Lanes));
    auto* const layers = reinterpret_cast<Lanes*>(record + ShellRecord::layers * width);
    const auto advance = [&](const auto& lives) {
      const auto advance_shapes = [&](const auto& shapes) {
        const CornerMotion<Lanes> of_corners{find_differences(x), find_differences(v), w, Lanes(motion.dt)};
        if constexpr (is_fabric<Layer>) {
          return advance_membrane(parameters, of_corners, {head, layers}, {f, m}, lives, shapes);
        } else {
          if (parameters.is_membrane)
            return advance_membrane(parameters, of_corners, {head, layers}, {f, m}, lives, shapes);
          return advance_shell4(parameters, of_corners, {head, layers}, {f, m}, lives, shapes);
        }
      };
      if constexpr (HasTriangles) {
        return advance_shapes(find_shapes(corners));
      } else {
        return advance_shapes(Quadrilaterals{});
      }
    };
    ShellResult<Lanes> result;
    if constexpr (CanFail) {
      if (living.can_fail()) {
        result = advance(living.layers());
        living.settle(result, f, m);
      } else {
        result = advance(WholeLayers{});
      }
    } else {
      result = advance(WholeLayers{});
    }
    scatter_corners(f, corners, lanes, scratch.forces);
    scatter_corners(m, corners, lanes, scratch.forces + 4);
    return result;
  }
};

template <class Layer>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const ShellBlock<Layer>& block,
                   const ShellMotion& motion, const ChunkFields& fields) {
  const int count = static_cast<int>(block.chunks.extent(0));
  if (count == 0) return;
  const ChunkPolicy policy = ShellScratch::make_policy(space, count, chunks.largest_slot_count);
  const auto advance = [&]<bool CanFail, bool HasTriangles>(std::bool_constant<CanFail>,
                                                            std::bool_constant<HasTriangles>) {
    using Kernel = AdvanceShellChunk<Layer, CanFail, HasTriangles>;
    Kokkos::parallel_for(
        "percuss::advance_shells", policy,
        Kernel{chunks, block, motion, fields.state, fields.slot_force, fields.slot_moment, fields.results});
  };
  if constexpr (!is_single_precision) {
    if (motion.failing.first_layer.extent(0) > 0) return advance(std::true_type{}, std::true_type{});
  }
  if (block.has_triangles) return advance(std::false_type{}, std::true_type{});
  advance(std::false_type{}, std::false_type{});
}

}  // namespace

void advance_shells(const ExecSpace& space, const ElementChunks& chunks, const ShellBlocks& blocks,
                    const ShellMotion& motion, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (advance_block(space, chunks, block, motion, fields), ...); }, blocks);
}

}  // namespace percuss
