#pragma once
// Sums over the nodes that a rank owns, for totals that have the same bits on any number of ranks and threads.
//
// The nodes of one chunk are added up in ascending order as ordinary numbers: a chunk is the same everywhere. Chunks
// are added exactly. That costs as much as an ordinary sum.

#include "kernels/core/exact_sum.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// K sums at once. Holds their memory, so that nothing is allocated in the step.
template <int K>
class OwnedNodeSums {
 public:
  using Values = Kokkos::Array<double, K>;

  explicit OwnedNodeSums(const std::string& label) : sums_(label, chunks_of_a_block) {}

  /// add(n, values) adds node n to values[0..K). Returns this rank's share of the K totals.
  template <class Add>
  typename ExactSums<K>::Totals operator()(const ExecSpace& space, const NodeRuns& owned, const Add& add) {
    return sums_(
        space, owned.count, KOKKOS_LAMBDA(const int c, const ExactAdder& add_exactly) {
          Values values;
          for (int k = 0; k < K; ++k) values[k] = 0;
          for (int n = owned.first(c); n < owned.end(c); ++n) add(n, values);
          for (int k = 0; k < K; ++k) add_exactly(k, values[k]);
        });
  }

 private:
  static constexpr int chunks_of_a_block = 8;
  ExactSums<K> sums_;
};

}  // namespace percuss
