#pragma once
// Fluids in a step: lumped masses have weight and inertia of an element at the mean of its corners, but the pressure
// acts on its exact volume. The difference makes water at rest unstable in hourglass modes. Forces move both to the
// centroid of the element (kernels/element/centroid_forces.hpp).

#include "kernels/core/exact_sum.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

class FluidStage : public Action {
 public:
  /// Mesh and model outlive this.
  FluidStage(const ChunkedMesh& chunked, const Model& model);

  void begin_step(const State& state, const StepTimes& times) override;
  void book_motion(State& state, const StepTimes& times) override;
  void advance(State& state, double dt) override;
  void book_forces(State& state, double dt, double time, bool takes_gravity) override;
  void archive(CheckpointArchive& archive, State& state) override;
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  bool comes_between() const override { return false; }

 private:
  static constexpr int chunks_of_a_block = 128;

  const ChunkedMesh& chunked_;
  const Model& model_;
  double dt_mean_ = 0;      // of the step
  Rows3<double> velocity_;  // [elements of fluids] of the mass at their corners, at n-1/2
  CentroidSums sums_;       // [chunks of fluids] of the forces at n
  ExactSum work_;           // of the forces since the start, this rank's share; part of the external work
  ExactSums<3> moment_sums_{"percuss::centroid_moments", chunks_of_a_block};
  ExactSums<1> work_sum_{"percuss::centroid_work", chunks_of_a_block};
};

}  // namespace percuss
