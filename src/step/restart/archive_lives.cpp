#include "src/step/restart/archive_lives.hpp"

#include <span>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/shell/layer_lives.hpp"

namespace percuss {

namespace {

constexpr std::size_t layer_lanes = pack_size<double>;  // of packs of layers

// Steps left, plastic strain, damage, second sum, shares of force and of work, works.
constexpr std::size_t own_columns = 6, life_columns = own_columns + work_kinds;

/// The elements that can fail, chunk after chunk.
struct FailingRows {
  ChunkRows rows;
  std::vector<std::size_t> lanes;  // of each
};

FailingRows list_elements_that_fail(const Model& model) {
  const auto first_element = to_host(model.chunks.first_element), first_pack = to_host(model.failing.first_pack);
  FailingRows of;
  for (std::size_t c = 0; c < static_cast<std::size_t>(model.chunks.count); ++c) {
    const bool can_fail = model.failing.pack_count > 0 && first_pack(c) >= 0;
    of.rows.counts.push_back(can_fail ? first_element(c + 1) - first_element(c) : 0);
    for (std::int64_t i = 0; i < of.rows.counts.back(); ++i) {
      of.lanes.push_back(static_cast<std::size_t>(first_pack(c) * pack_width) + static_cast<std::size_t>(i));
    }
  }
  return of;
}

/// Lives of elements, on the host.
struct LivesOnHost {
  explicit LivesOnHost(const ElementLives& lives)
      : force_share(to_host(lives.force_share)),
        work_share(to_host(lives.work_share)),
        work(to_host(lives.work)),
        steps_left(to_host(lives.steps_left)),
        plastic_strain(to_host(lives.plastic_strain)),
        damage(to_host(lives.damage)),
        second(to_host(lives.second)) {}

  /// v: out, [life_columns].
  void read(std::size_t l, double* v) const {
    v[0] = steps_left(l);
    v[1] = plastic_strain(l);
    v[2] = damage(l);
    v[3] = second(l);
    v[4] = static_cast<double>(force_share(l));
    v[5] = static_cast<double>(work_share(l));
    for (std::size_t k = 0; k < work_kinds; ++k) v[own_columns + k] = work(find_work_place(l, k));
  }

  void write(std::size_t l, const double* v) const {
    steps_left(l) = static_cast<int>(v[0]);
    plastic_strain(l) = v[1];
    damage(l) = v[2];
    second(l) = v[3];
    force_share(l) = static_cast<Real>(v[4]);
    work_share(l) = static_cast<Real>(v[5]);
    for (std::size_t k = 0; k < work_kinds; ++k) work(find_work_place(l, k)) = v[own_columns + k];
  }

  void copy_to(const ElementLives& lives) const {
    copy_values(lives.steps_left, steps_left);
    copy_values(lives.plastic_strain, plastic_strain);
    copy_values(lives.damage, damage);
    copy_values(lives.second, second);
    copy_values(lives.work, work);
    copy_values(lives.force_share, force_share);
    copy_values(lives.work_share, work_share);
  }

  HostMirror<Array<Real>> force_share, work_share;
  HostMirror<Array<double>> work;
  HostMirror<Array<int>> steps_left;
  HostMirror<Array<double>> plastic_strain, damage, second;
};

/// Archives the lives of the elements that can fail, element after element.
void archive_elements_that_fail(CheckpointArchive& archive, const Model& model, const State& state) {
  const FailingRows of = list_elements_that_fail(model);
  const LivesOnHost lives(state.lives);
  std::vector<double> values(life_columns * of.lanes.size());
  for (std::size_t i = 0; i < of.lanes.size(); ++i) lives.read(of.lanes[i], &values[life_columns * i]);
  archive.rows("elements/lives", of.rows, static_cast<int>(life_columns), std::span<double>(values));
  if (!archive.is_loading()) return;
  for (std::size_t i = 0; i < of.lanes.size(); ++i) lives.write(of.lanes[i], &values[life_columns * i]);
  lives.copy_to(state.lives);
}

/// Calls visit(places in ElementLives::layers of the first row of each element, number of layers) chunk after chunk, of
/// chunks whose shells can fail.
template <class Visit>
void visit_failing_shells(const Model& model, const Visit& visit) {
  const FailingChunks& failing = model.failing;
  const auto list = to_host(failing.list), points = to_host(model.chunks.points),
             first_element = to_host(model.chunks.first_element);
  const auto family = to_host(model.chunks.family);
  const auto first_layer = to_host(failing.first_layer);
  for (std::size_t l = 0; failing.layer_scalars > 0 && l < list.extent(0); ++l) {
    const auto c = static_cast<std::size_t>(list(l));
    if (family(c) != ElementFamily::shells) continue;
    const auto rows = static_cast<std::size_t>(LayerLives::count_rows(points(c)));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < static_cast<std::size_t>(first_element(c + 1) - first_element(c)); ++i) {
      places.push_back(first_layer(c) + i / layer_lanes * rows * layer_lanes + i % layer_lanes);
    }
    visit(c, places, points(c));
  }
}

/// Archives the lives of layers of shells that can fail, element after element: the strains of the element, then of
/// each layer what LayerLives names.
void archive_layers(CheckpointArchive& archive, const Model& model, const State& state) {
  if (!model.has_rotations) return;
  ChunkRows rows{std::vector<std::int64_t>(static_cast<std::size_t>(model.chunks.count), 0), {}};
  const auto layers = to_host(state.lives.layers);
  std::vector<double> values;
  std::vector<std::size_t> scalars;  // of the layers, as they stand in `values`
  visit_failing_shells(model, [&](std::size_t c, const std::vector<std::size_t>& places, int points) {
    const auto count = static_cast<std::size_t>(LayerLives::count_rows(points));
    for (const std::size_t first : places) {
      for (std::size_t k = 0; k < count; ++k) scalars.push_back(first + k * layer_lanes);
    }
    rows.counts[c] = static_cast<std::int64_t>(places.size() * count);
  });
  values.reserve(scalars.size());
  for (const std::size_t s : scalars) values.push_back(layers(s));
  archive.rows("elements/layers", rows, 1, std::span<double>(values));
  if (!archive.is_loading()) return;
  for (std::size_t i = 0; i < scalars.size(); ++i) layers(scalars[i]) = values[i];
  copy_values(state.lives.layers, layers);
}

}  // namespace

void archive_lives(CheckpointArchive& archive, const Model& model, const State& state) {
  archive_elements_that_fail(archive, model, state);
  archive_layers(archive, model, state);
}

}  // namespace percuss
