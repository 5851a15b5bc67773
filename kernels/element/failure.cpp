#include "kernels/element/failure.hpp"

#include "kernels/core/common_record.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/element/failure_criteria.hpp"
#include "kernels/element/hex8/point_mean.hpp"
#include "kernels/element/life.hpp"

namespace percuss {

namespace {

/// Six scalars of a record, their mean over points that follow each other.
KOKKOS_INLINE_FUNCTION Symmetric3<double> read_tensor(const ElementRecord& record, int first, int points) {
  double mean[6];
  for (int k = 0; k < 6; ++k) {
    mean[k] = find_point_mean(points, [&](int p) { return double{record[first + 6 * p + k]}; });
  }
  return {mean[0], mean[1], mean[2], mean[3], mean[4], mean[5]};
}

/// A scalar of the history, the mean over the points; 0 where there is none.
KOKKOS_INLINE_FUNCTION double read_scalar(const ElementRecord& record, int first, int points) {
  if (first < 0) return 0;
  return find_point_mean(points, [&](int p) { return double{record[first + p]}; });
}

/// What the limits ask of an element.
KOKKOS_INLINE_FUNCTION ElementLoad read_load(const ElementChunks& chunks, int c, const FailureLimits& limits,
                                             const ElementRecord& record) {
  const int points = chunks.points(c);
  ElementLoad load;
  if (limits.reads_stress()) load.stress = read_tensor(record, SolidRecord::stress, points);
  if (limits.reads_stretch()) load.stretch = read_tensor(record, SolidRecord::stretch, 1);
  if (limits.reads_volume()) {
    const int energy = chunks.find_scalar(c, HistoryScalar::internal_energy);  // J follows it (start_state())
    load.volume = energy < 0 ? find_stretch_determinant(read_tensor(record, SolidRecord::stretch, 1))
                             : read_scalar(record, energy + points, points);
  }
  load.plastic_strain = read_scalar(record, chunks.find_scalar(c, HistoryScalar::equivalent_plastic_strain), points);
  const int remains = chunks.find_scalar(c, HistoryScalar::remains);
  if (remains >= 0) load.remains = read_scalar(record, remains, points);
  if (limits.johnson_cook.any()) {
    const int temperature = chunks.find_scalar(c, HistoryScalar::temperature);
    if (temperature >= 0) load.homologous = find_homologous(limits, read_scalar(record, temperature, points));
  }
  return load;
}

/// One element: undamaged, failing, removed by its evaluation, or eroded. Returns whether anything has changed.
KOKKOS_INLINE_FUNCTION bool judge(const ElementLives& lives, int lane, const FailureLimits& limits,
                                  const ElementLoad& load, double dt, FailureCounts& counts) {
  if (go_on_dying(lives, lane, limits, counts)) return true;
  FailureHistory history{lives.plastic_strain(lane), lives.damage(lane), lives.second(lane)};
  const bool failed = fails(limits, load, dt, history);
  lives.plastic_strain(lane) = history.plastic_strain;
  lives.damage(lane) = history.damage;
  lives.second(lane) = history.second;
  if (!failed) return limits.softens() && find_life(lives, lane).soften(find_force_share(limits, history));
  ++counts.failing;
  find_life(lives, lane).begin_to_die(limits);
  return true;
}

}  // namespace

FailureCounts find_failures(const ExecSpace& space, const ElementChunks& chunks, const FailingElements& elements,
                            double dt, const ChunkResults& results) {
  const FailingChunks failing = elements.chunks;
  const ElementLives lives = elements.lives;
  const Array<Real> records = elements.records;
  FailureCounts counts;
  parallel_reduce(
      "percuss::find_failures", RangeOf(space, 0, static_cast<int>(failing.list.extent(0))),
      KOKKOS_LAMBDA(const int i, int& sum_failing, int& sum_died) {
        const int c = failing.list(i);
        if (is_shell(chunks, c)) return;  // kernels/shell/shell_failure.hpp
        const FailingRecords of = find_records(chunks, failing, records, c);
        const int count = chunks.first_element(c + 1) - chunks.first_element(c);
        if (results.is_settled(c) != 0 && !is_any_ending(lives, of.first_lane, count)) return;  // as it was judged last
        FailureCounts here;
        bool changed = false;
        for (int e = 0; e < count; ++e) {
          if (lives.steps_left(of.first_lane + e) == 0) continue;
          const FailureLimits& limits = failing.find_limits(c, e);
          if (judge(lives, of.first_lane + e, limits, read_load(chunks, c, limits, of.find(e)), dt, here))
            changed = true;
        }
        if (changed) results.is_settled(c) = 0;
        if (changed) end_lanes_past_end(lives, of, count);
        if (here.died > 0) repeat_living_lanes(lives, of);
        sum_failing += here.failing;
        sum_died += here.died;
      },
      counts.failing, counts.died);
  return counts;
}

void copy_into_dead_lanes(const ExecSpace& space, const ElementChunks& chunks, const FailingElements& elements) {
  const FailingChunks failing = elements.chunks;
  const ElementLives lives = elements.lives;
  const Array<Real> records = elements.records;
  parallel_for(
      "percuss::copy_into_dead_lanes", RangeOf(space, 0, static_cast<int>(failing.list.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int c = failing.list(i);
        const FailingRecords of = find_records(chunks, failing, records, c);
        end_lanes_past_end(lives, of, chunks.first_element(c + 1) - chunks.first_element(c));
        repeat_living_lanes(lives, of);
      });
}

}  // namespace percuss
