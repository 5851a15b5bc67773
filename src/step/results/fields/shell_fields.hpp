#pragma once
// Reads the records of shells for output. Internal to element_fields.cpp.

#include "kernels/element/element_records.hpp"
#include "kernels/shell/shell_failure.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/results/fields/element_fields.hpp"

namespace percuss {

/// Tables of a reader of shells besides the records; empty in a scene without shells.
struct ShellTables {
  Rows3<const double> x;
  Kokkos::View<ThicknessPoints*, MemSpace> rules;
  FailingChunks failing;
  ElementLives lives;

  ShellTables(const Model& model, const State& state)
      : x(state.x), rules(model.thickness_rules), failing(model.failing), lives(state.lives) {}

  /// Share of its stress at n that layer p of element i of chunk c has.
  KOKKOS_INLINE_FUNCTION double find_share(int c, int i, int points, int p) const {
    constexpr int width = pack_size<double>;
    if (failing.first_layer.extent(0) == 0 || failing.find_pack(c) < 0) return 1;
    const double* const life = find_layer_life(find_layer_lives(lives, failing, c, points, i), p);
    const int left = static_cast<int>(life[LayerLives::left * width]);
    if (left == ElementLives::whole)  // work takes the mean of the shares of now and of the next step
      return 2 * life[LayerLives::work_share * width] - life[LayerLives::force_share * width];
    return find_life_shares(left, failing.limits(failing.row(c)).fade_steps).now;
  }
};

/// Element e of chunk c and its record.
struct RecordedShell {
  const ElementChunks& chunks;
  int c, e;
  ElementRecord record;
};

/// Scalar `place` of one point (a number below the rule's count, or as in ShellPoint). share(p): what counts of layer
/// p.
template <class Share>
KOKKOS_INLINE_FUNCTION double read_layers(const RecordedShell& shell, const ThicknessPoints& rule, int place, int point,
                                          const Share& share) {
  const int size = find_layer_size(shell.chunks, shell.c), count = rule.count;
  const auto value = [&](int p) { return share(p) * shell.record[ShellRecord::layers + size * p + place]; };
  if (point == ShellPoint::highest) return value(count - 1);
  if (point != ShellPoint::mean) return value(point);
  double mean = 0;
  for (int p = 0; p < count; ++p) mean += rule.weight[p] * value(p);
  return mean;
}

/// Its axes as rows.
KOKKOS_INLINE_FUNCTION Matrix3<double> find_shell_frame(const RecordedShell& shell, const Rows3<const double>& x) {
  const auto& [chunks, c, e, record] = shell;
  Vector3<double> corners[4];
  for (int k = 0; k < 4; ++k) {
    const int n = chunks.slots_to_nodes(number_corner_slot(chunks, c, e - chunks.first_element(c), k));
    corners[k] = {x(n, 0), x(n, 1), x(n, 2)};
  }
  return find_shell_geometry(find_differences(corners)).frame;
}

/// Stress in space axes: xx, yy, zz, xy, yz, zx. Transverse shear is that of all layers.
KOKKOS_INLINE_FUNCTION void read_shell_stress(const ShellTables& tables, const RecordedShell& shell, int point,
                                              double* row) {
  constexpr int shear = 3;  // ShellState::shear
  const ElementChunks& chunks = shell.chunks;
  const int c = shell.c, i = shell.e - chunks.first_element(c);
  const ElementRecord& record = shell.record;
  const ThicknessPoints& rule = tables.rules(chunks.rule(c));
  if (point >= rule.count) {
    for (int k = 0; k < 6; ++k) row[k] = 0;
    return;
  }
  const auto share = [&](int p) { return tables.find_share(c, i, rule.count, p); };
  const auto in_plane = [&](int k) { return read_layers(shell, rule, k, point, share); };
  double left = 1;  // of the whole section
  for (int p = 0; p < rule.count; ++p) left -= rule.weight[p] * (1 - share(p));
  const Symmetric3<double> stress{in_plane(0),         in_plane(1), 0, in_plane(2), left * record[shear + 1],
                                  left * record[shear]};
  const Symmetric3<double> t = pull_back(find_shell_frame(shell, tables.x), stress);
  row[0] = t.xx;
  row[1] = t.yy;
  row[2] = t.zz;
  row[3] = t.xy;
  row[4] = t.yz;
  row[5] = t.zx;
}

}  // namespace percuss
