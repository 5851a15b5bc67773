#pragma once
// A longer step than the elements alone allow: from the largest eigenvalue of the whole mesh (docs/theory.md, section
// 1).
//
// The eigenvalue is found by the Lanczos iteration on the elements as a linear operator, raised by the margin that the
// iteration may fall short of it. Until the next estimate the step shrinks with the growth of what each element's own
// bound says, and never falls below the least of those bounds. Estimates take at most a fiftieth of the steps.

#include <cstdint>

#include "kernels/element/element_motion.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/stable_step/mesh_eigenvalue.hpp"

namespace percuss {

/// Cost and result of the estimates of a run.
struct StepEstimateReport {
  std::int64_t count = 0;  // of estimates since the start of the run
  double gain = 1;         // mean over the steps of the bound taken over the least bound of an element
};

class GlobalStep {
 public:
  /// Collective over the model's ranks. end: of the run [time]; scale: share of a bound that a step takes.
  GlobalStep(const ChunkedMesh& chunked, const Model& model, double end, double scale);

  /// Quantities that the elements track from step to step.
  const StepWatch& watch() const { return watch_; }

  /// The bound at n. element_bound: least of all elements; growth: largest of watch().growth on all ranks. Estimates
  /// anew if that is due. Collective.
  double find_bound(const State& state, double element_bound, double growth);

  /// The largest stable step of the mesh at n, the margin taken off. trial: a step near it, which sizes the damping.
  /// Collective.
  double estimate(const State& state, double trial);

  /// Reads or writes what later steps depend on. Collective.
  void archive(CheckpointArchive& archive);

  StepEstimateReport report() const;

 private:
  bool is_due(const State& state, double element_bound, double bound) const;
  void renew(const State& state, double element_bound);
  void archive_reference(CheckpointArchive& archive);

  const ChunkedMesh& chunked_;
  const Model& model_;
  double end_, scale_;
  MeshEigenvalue eigenvalue_;
  StepWatch watch_;
  double reference_bound_ = 0;   // least bound of an element at the last estimate
  double patience_ = 1;          // what the wait between estimates is multiplied by, more where they bring nothing
  std::int64_t last_step_ = -1;  // of the last estimate
  std::int64_t count_ = 0, steps_ = 0;
  double gains_ = 0;  // summed over steps_
};

}  // namespace percuss
