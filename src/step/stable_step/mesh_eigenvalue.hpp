#pragma once
// The largest eigenvalue of the elements of all ranks as a linear operator, M^-1 A(h)
// (kernels/element/elastic_operator.hpp), by the Lanczos iteration in the inner product of the masses, from a random
// start.
//
// Directions that a condition holds take no part. The bits are the same on any number of ranks and threads: forces are
// summed like those of a step, inner products exactly.

#include <cstdint>

#include "comm/halo/halo_swap.hpp"
#include "src/step/model/owned_sums.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class MeshEigenvalue {
 public:
  /// Collective over the model's ranks.
  MeshEigenvalue(const ChunkedMesh& chunked, const Model& model);

  /// Iterations that find() makes.
  int iterations() const { return iterations_; }

  /// The largest eigenvalue for the trial step h [time] at the state's n, with the margin added that the iteration may
  /// fall short of it. Collective.
  double find(const State& state, double step);

  // Kernels of its own: nvcc takes none in a private function.
  void start_vector();
  void subtract_previous(double beta);
  double take_out();
  double normalise();

 private:
  void apply(const State& state, double step);

  const Model& model_;
  std::int64_t unknowns_;
  int iterations_;
  HaloSwap halo_;
  OwnedNodeSums<1> sum_{"percuss::lanczos"};
  Rows3<double> slots_, before_, vector_, next_;
};

}  // namespace percuss
