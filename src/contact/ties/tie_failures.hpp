#pragma once
// Which tied nodes let go by the stress on them, and what the others hold.

#include <cstdint>
#include <vector>

#include "kernels/contact/enforcement/tie_strength.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

class TieFailures {
 public:
  /// ties: those of the start. Throws InputError, on all ranks, where a node has no area. Collective.
  TieFailures(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties, const Communicator& ranks);

  /// Whether any tie of the deck can fail.
  bool any() const { return !laws_.empty(); }

  /// From now on ties are these.
  void take(const TiedSurfaces& ties);
  const TieStrengths& strengths() const { return strengths_; }

  /// Notes the ties, as they were taken last, whose use has reached 1. Returns how many these are on all ranks.
  /// Collective.
  std::int64_t judge(const Array<const double>& use);
  /// Takes the nodes noted last out of the ties of the start. Collective.
  void let_go(TiedSurfaces& ties);

  /// Nodes that have let go, on all ranks.
  std::int64_t count() const { return count_; }

  /// Loading: let_go() is then to be called if this returns true. Collective.
  bool archive(CheckpointArchive& archive);

 private:
  const ChunkedMesh& chunked_;
  const Communicator ranks_;
  std::vector<TieStrength> laws_;      // [failing ties]
  std::vector<int> law_of_tie_;        // [ties of the deck] -1: does not fail
  std::vector<std::int64_t> numbers_;  // of the nodes that this rank owned in failing ties at the start, ascending
  std::vector<double> areas_;          // [numbers]
  std::vector<double> has_failed_;     // [numbers] 1 or 0
  std::vector<std::int64_t> taken_;    // nodes of the ties as taken last
  std::vector<std::int64_t> failing_;  // noted last
  TieStrengths strengths_;
  std::int64_t count_ = 0;
};

}  // namespace percuss
