#include "kernels/shell/shell_failure.hpp"

#include "kernels/core/small_space.hpp"
#include "kernels/element/failure_criteria.hpp"

namespace percuss {

namespace {

constexpr int width = pack_size<double>;

/// One shell: its record and what its layers carry; scalars lie a pack of each apart.
struct FailingShell {
  ElementRecord record;
  double* lives;
  int layer_size;                                 // scalars of a layer in the record
  int plastic_strain, temperature, fibre_damage;  // their places in a layer, or negative

  KOKKOS_INLINE_FUNCTION double* life(int p) const { return find_layer_life(lives, p); }
  KOKKOS_INLINE_FUNCTION double read(int p, int scalar) const {
    return record[ShellRecord::layers + layer_size * p + scalar];
  }
  KOKKOS_INLINE_FUNCTION int left(int p) const { return static_cast<int>(life(p)[LayerLives::left * width]); }
};

/// Stress, plastic strain and temperature of a layer.
KOKKOS_INLINE_FUNCTION ElementLoad read_layer(const FailingShell& shell, int p, const FailureLimits& limits) {
  ElementLoad load;
  load.stress = {shell.read(p, 0), shell.read(p, 1), 0, shell.read(p, 2), 0, 0};
  load.stretch = {1, 1, 1, 0, 0, 0};
  if (shell.plastic_strain >= 0) load.plastic_strain = shell.read(p, shell.plastic_strain);
  if (shell.temperature >= 0) load.homologous = find_homologous(limits, shell.read(p, shell.temperature));
  return load;
}

/// Strain of a layer in the plane, at the place from -1 (bottom) to 1.
KOKKOS_INLINE_FUNCTION Symmetric3<double> read_strain(const FailingShell& shell, double place) {
  const auto strain = [&](int k) {
    return shell.lives[(LayerLives::membrane + k) * width] + place * shell.lives[(LayerLives::bending + k) * width];
  };
  return {strain(0), strain(1), 0, 0.5 * strain(2), 0, 0};
}

/// How much thinner a layer has become.
KOKKOS_INLINE_FUNCTION double read_thinning(const FailingShell& shell, int p, double place,
                                            const FailureLimits& limits) {
  return find_thinning(read_strain(shell, place), shell.read(p, 0) + shell.read(p, 1), limits.compressibility);
}

/// Whether the whole shell has become too thin.
KOKKOS_INLINE_FUNCTION bool is_thin(const FailingShell& shell, const ThicknessPoints& rule,
                                    const FailureLimits& limits) {
  if (!(limits.mean_thinning < FailureLimits::none)) return false;
  double mean = 0;
  for (int p = 0; p < rule.count; ++p) mean += rule.weight[p] * read_thinning(shell, p, rule.place[p], limits);
  return mean >= limits.mean_thinning;
}

/// What a layer remembers.
KOKKOS_INLINE_FUNCTION FailureHistory read_history(const double* life) {
  return {life[LayerLives::plastic_strain * width], life[LayerLives::damage * width], life[LayerLives::second * width]};
}

/// Adds the step to what the layer remembers; returns whether it fails.
KOKKOS_INLINE_FUNCTION bool judge_layer(const FailingShell& shell, int p, double place, const FailureLimits& limits,
                                        double dt) {
  double* const life = shell.life(p);
  FailureHistory history = read_history(life);
  const bool failed = fails_by_load(limits, read_layer(shell, p, limits), dt, history);
  life[LayerLives::plastic_strain * width] = history.plastic_strain;
  life[LayerLives::damage * width] = history.damage;
  life[LayerLives::second * width] = history.second;
  if (shell.fibre_damage >= 0 && shell.read(p, shell.fibre_damage) >= limits.fibre_damage) return true;
  if (limits.thinning < FailureLimits::none && read_thinning(shell, p, place, limits) >= limits.thinning) return true;
  return failed ||
         (limits.principal_strain < FailureLimits::none && reaches(read_strain(shell, place), limits.principal_strain));
}

/// Layers that have failed lose their stress. Returns whether any has changed.
KOKKOS_INLINE_FUNCTION bool fade_layers(const FailingShell& shell, int points, int fade_steps) {
  bool changed = false;
  for (int p = 0; p < points; ++p) {
    if (shell.left(p) <= 0) continue;
    set_layer_left(shell.life(p), shell.left(p) - 1, fade_steps);
    changed = true;
  }
  return changed;
}

/// The element fails, and its layers keep what they have.
KOKKOS_INLINE_FUNCTION void keep_shares(const FailingShell& shell, int points) {
  for (int p = 0; p < points; ++p) {
    const Life<double, double> life = find_life(shell.life(p));
    if (shell.left(p) == ElementLives::whole) life.work = life.force;
  }
}

/// By what the shells of a chunk are judged in a step.
struct ShellCriteria {
  const ThicknessPoints& rule;
  const FailureLimits& limits;
  double dt;
};

/// Judges the layers of a whole element; returns whether the element fails. Those that fail in the step in which it
/// does fade with it.
KOKKOS_INLINE_FUNCTION bool judge_layers(const FailingShell& shell, const ShellCriteria& by, bool& changed) {
  const ThicknessPoints& rule = by.rule;
  const FailureLimits& limits = by.limits;
  constexpr double round_off = 1e-12;
  bool fresh[most_layers];
  double failed = 0;
  int count = 0;
  for (int p = 0; p < rule.count; ++p) {
    const bool is_whole = shell.left(p) == ElementLives::whole;
    fresh[p] = is_whole && judge_layer(shell, p, rule.place[p], limits, by.dt);
    if (is_whole && !fresh[p]) continue;
    failed += rule.weight[p];
    ++count;
  }
  const bool softens = limits.softens();
  if (count == rule.count || failed >= limits.layers * (1 - round_off) || is_thin(shell, rule, limits)) {
    if (softens) keep_shares(shell, rule.count);
    return true;
  }
  for (int p = 0; p < rule.count; ++p) {
    double* const layer = shell.life(p);
    if (fresh[p]) find_life(layer).begin_to_die(limits);
    if (fresh[p] || (softens && shell.left(p) == ElementLives::whole &&
                     find_life(layer).soften(find_force_share(limits, read_history(layer)))))
      changed = true;
  }
  return false;
}

/// The means over the layers, of one that has failed as if it were at the limit.
KOKKOS_INLINE_FUNCTION void take_means(const FailingShell& shell, const ThicknessPoints& rule,
                                       const FailureLimits& limits, const ElementLives& lives, int lane) {
  double strain = 0, damage = 0, second = 0;
  for (int p = 0; p < rule.count; ++p) {
    const double* const life = shell.life(p);
    const bool is_whole = shell.left(p) == ElementLives::whole;
    strain += rule.weight[p] * smaller(life[LayerLives::plastic_strain * width], limits.plastic_strain);
    second += rule.weight[p] * smaller(life[LayerLives::second * width], limits.yield_time);
    damage += rule.weight[p] * (is_whole ? find_shown_damage(limits, read_history(life)) : limits.whole_damage());
  }
  lives.plastic_strain(lane) = strain;
  lives.damage(lane) = damage;
  lives.second(lane) = second;
}

KOKKOS_INLINE_FUNCTION bool judge(const FailingShell& shell, const ShellCriteria& by, const ElementLives& lives,
                                  int lane, FailureCounts& counts) {
  const FailureLimits& limits = by.limits;
  bool changed = fade_layers(shell, by.rule.count, limits.fade_steps);
  if (go_on_dying(lives, lane, limits, counts)) return true;
  if (judge_layers(shell, by, changed)) {
    ++counts.failing;
    find_life(lives, lane).set_left(limits.fade_steps, limits.fade_steps);
    changed = true;
  }
  take_means(shell, by.rule, limits, lives, lane);
  return changed;
}

/// The shells of one chunk.
struct JudgeShells {
  ElementChunks chunks;
  FailingChunks failing;
  ThicknessRules rules;
  double dt;
  Array<Real> elements;
  ElementLives lives;
  ChunkResults results;

  KOKKOS_INLINE_FUNCTION FailingShell find(const FailingRecords& of, int c, int i) const {
    return {of.find(i),
            find_layer_lives(lives, failing, c, chunks.points(c), i),
            find_layer_size(chunks, c),
            chunks.find_scalar(c, HistoryScalar::equivalent_plastic_strain) - ShellRecord::layers,
            chunks.find_scalar(c, HistoryScalar::temperature) - ShellRecord::layers,
            chunks.find_scalar(c, HistoryScalar::fibre_damage) - ShellRecord::layers};
  }

  /// Whether an element or a layer has begun to fail and is not dead yet.
  KOKKOS_INLINE_FUNCTION bool is_ending(const FailingRecords& of, int c, int count) const {
    if (is_any_ending(lives, of.first_lane, count)) return true;
    for (int i = 0; i < count; ++i) {
      const FailingShell shell = find(of, c, i);
      for (int p = 0; p < chunks.points(c); ++p)
        if (shell.left(p) > 0) return true;
    }
    return false;
  }

  KOKKOS_INLINE_FUNCTION void operator()(const int place, int& sum_failing, int& sum_died) const {
    const int c = failing.list(place);
    if (!is_shell(chunks, c)) return;
    const FailingRecords of = find_records(chunks, failing, elements, c);
    const int count = chunks.first_element(c + 1) - chunks.first_element(c);
    if (results.is_settled(c) != 0 && !is_ending(of, c, count)) return;  // as it was judged last
    const ThicknessPoints& rule = rules(chunks.rule(c));
    FailureCounts here;
    bool changed = false;
    for (int i = 0; i < count; ++i) {
      if (lives.steps_left(of.first_lane + i) == 0) continue;
      const ShellCriteria by{rule, failing.find_limits(c, i), dt};
      if (judge(find(of, c, i), by, lives, of.first_lane + i, here)) changed = true;
    }
    if (changed) results.is_settled(c) = 0;
    if (changed) end_lanes_past_end(lives, of, count);
    if (here.died > 0) repeat_living_lanes(lives, of);
    sum_failing += here.failing;
    sum_died += here.died;
  }
};

}  // namespace

FailureCounts find_shell_failures(const ExecSpace& space, const ElementChunks& chunks, const FailingElements& elements,
                                  const ThicknessRules& rules, double dt, const ChunkResults& results) {
  const FailingChunks& failing = elements.chunks;
  FailureCounts counts;
  if (failing.first_layer.extent(0) == 0) return counts;
  parallel_reduce("percuss::find_shell_failures", RangeOf(space, 0, static_cast<int>(failing.list.extent(0))),
                  JudgeShells{chunks, failing, rules, dt, elements.records, elements.lives, results}, counts.failing,
                  counts.died);
  return counts;
}

}  // namespace percuss
