#include "src/step/stable_step/global_step.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"

namespace percuss {
namespace {

/// Time of an iteration over that of a step, rounded up: no stress is updated, but ranks wait for two sums.
constexpr double steps_of_an_iteration = 0.5;
/// Share of the steps that estimates may take.
constexpr double largest_share = 0.02;
/// A new estimate is wanted once the bound has fallen by this share or the elements' own has grown by it.
constexpr double least_change = 0.02;
/// An estimate that allows less than this over the elements' bound was in vain; the next one waits twice as long.
constexpr double least_gain = 1.02;
constexpr double longest_patience = 16;
}  // namespace

GlobalStep::GlobalStep(const ChunkedMesh& chunked, const Model& model, double end, double scale)
    : chunked_(chunked), model_(model), end_(end), scale_(scale), eigenvalue_(chunked, model) {
  const std::size_t lanes = model.chunks.corner_slots.extent(0) / 8;
  watch_.bound = Array<Real>("percuss::element_bounds", lanes);
  watch_.reference = Array<Real>("percuss::reference_bounds", lanes);
  watch_.growth = Array<double>("percuss::growth", static_cast<std::size_t>(model.chunks.count));
}

double GlobalStep::find_bound(const State& state, double element_bound, double growth) {
  double bound = std::max(element_bound, watch_.step / std::sqrt(1 + growth));
  if (is_due(state, element_bound, bound)) {
    renew(state, element_bound);
    bound = std::max(element_bound, watch_.step);
  }
  gains_ += bound / element_bound;
  ++steps_;
  return bound;
}

bool GlobalStep::is_due(const State& state, double element_bound, double bound) const {
  if (!(element_bound > 0) || !std::isfinite(element_bound)) return false;  // the run ends here
  const double wait = patience_ * eigenvalue_.iterations() * steps_of_an_iteration / largest_share;
  if ((end_ - state.time) / (scale_ * element_bound) < wait) return false;  // it would not pay any more
  if (last_step_ < 0) return true;
  if (static_cast<double>(state.step - last_step_) < wait) return false;
  return bound < (1 - least_change) * watch_.step || element_bound > (1 + least_change) * reference_bound_;
}

void GlobalStep::renew(const State& state, double element_bound) {
  const double gain = reference_bound_ > 0 ? std::max(1.0, watch_.step / reference_bound_) : 1.0;
  const double found = estimate(state, gain * element_bound);
  watch_.step = found > element_bound ? found : element_bound;  // also where it is no number
  copy_values(watch_.reference, watch_.bound);
  set_values(watch_.growth, 0.0);
  reference_bound_ = element_bound;
  patience_ = watch_.step > least_gain * element_bound ? 1 : std::min(2 * patience_, longest_patience);
  last_step_ = state.step;
  ++count_;
}

/// Stable step from the eigenvalue a of A(h) at the trial step h: where the step must be shorter than h, damping
/// shrinks only with its first power.
double GlobalStep::estimate(const State& state, double trial) {
  const double a = eigenvalue_.find(state, trial);
  return a < 1 ? trial / std::sqrt(a) : trial / a;
}

void GlobalStep::archive(CheckpointArchive& archive) {
  archive.number("global_step/step", watch_.step);
  archive.number("global_step/reference_bound", reference_bound_);
  archive.number("global_step/patience", patience_);
  archive.number("global_step/last_step", last_step_);
  archive.number("global_step/count", count_);
  archive.number("global_step/steps", steps_);
  archive.number("global_step/gains", gains_);
  archive_reference(archive);
}

/// Archives by element, without the packs, whose width depends on the machine.
void GlobalStep::archive_reference(CheckpointArchive& archive) {
  const HostChunks chunks(model_.chunks);
  const auto reference = to_host(watch_.reference);
  std::vector<double> values(chunked_.mesh.elements.size());
  const auto visit = [&](const auto& take) {
    for (int c = 0; c < chunks.count; ++c) {
      for (int i = 0; i < count_lanes(chunks, c); ++i)
        take(static_cast<std::size_t>(find_element(chunks, c, i)), static_cast<std::size_t>(number_lane(chunks, c, i)));
    }
  };
  if (!archive.is_loading()) visit([&](std::size_t e, std::size_t lane) { values[e] = reference(lane); });
  archive.rows("global_step/reference", find_element_rows(chunked_), 1, values);
  if (!archive.is_loading()) return;
  visit([&](std::size_t e, std::size_t lane) { reference(lane) = static_cast<Real>(values[e]); });
  copy_values(watch_.reference, reference);
}

StepEstimateReport GlobalStep::report() const {
  return {count_, steps_ > 0 ? gains_ / static_cast<double>(steps_) : 1};
}

}  // namespace percuss
