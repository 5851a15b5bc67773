#pragma once
// The pass over shells that can fail: after the elements of a step, before its reduction.
//
// Each layer is judged by itself, as a point of a solid is; the element fails when its layers have failed over a share
// of the thickness that the deck gives, all of it by default (docs/theory_failure.md).

#include "kernels/element/life.hpp"
#include "kernels/shell/layer_lives.hpp"
#include "kernels/shell/shell_record.hpp"
#include "kernels/shell/thickness_points.hpp"

namespace percuss {

/// The rules across the thickness, by ElementChunks::rule.
using ThicknessRules = Kokkos::View<ThicknessPoints*, MemSpace>;

/// As find_failures(), for the chunks of shells.
FailureCounts find_shell_failures(const ExecSpace& space, const ElementChunks& chunks, const FailingElements& elements,
                                  const ThicknessRules& rules, double dt, const ChunkResults& results);

/// layer: its first scalar in ElementLives::layers.
KOKKOS_INLINE_FUNCTION Life<double, double> find_life(double* layer) {
  constexpr int width = pack_size<double>;
  return {layer[LayerLives::left * width], layer[LayerLives::force_share * width],
          layer[LayerLives::work_share * width]};
}

/// Gives a layer so many evaluations. Without any it has no stress, but is in the sums of its shell.
KOKKOS_INLINE_FUNCTION void set_layer_left(double* layer, int left, int fade_steps) {
  const Life<double, double> life = find_life(layer);
  life.set_left(left, fade_steps);
  if (left == 0) life.force = 0;
}

/// First scalar of a lane's layer p. lives: of the lane's element.
KOKKOS_INLINE_FUNCTION double* find_layer_life(double* lives, int p) {
  return lives + (LayerLives::layers + p * LayerLives::layer_size) * pack_size<double>;
}

/// Where element i of chunk c has its rows; point after point they lie a pack apart.
KOKKOS_INLINE_FUNCTION double* find_layer_lives(const ElementLives& lives, const FailingChunks& failing, int c,
                                                int points, int i) {
  constexpr int width = pack_size<double>;
  return &lives.layers(failing.first_layer(c)) + i / width * LayerLives::count_rows(points) * width + i % width;
}

}  // namespace percuss
