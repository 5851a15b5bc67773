#pragma once
// Tied nodes that fail by the stress on them, and what the others hold.

#include <cstdint>
#include <vector>

#include "comm/exchange/item_exchange.hpp"
#include "kernels/contact/enforcement/tie_strength.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// Nodes and faces that failed ties release.
struct ReleasedTies {
  std::vector<std::int64_t> nodes;  // numbers, of all ranks, ascending
  std::vector<std::int64_t> faces;  // numbers of this rank's faces of which no corner is tied any more
};

class TieFailures {
 public:
  /// ties: those of the start. late: nodes that this rank owns and that may be tied later. Throws InputError, on all
  /// ranks, where a node has no area. Collective.
  TieFailures(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
              const std::vector<std::int64_t>& late, const Communicator& ranks);

  /// Whether ties are left, on any rank, that can fail.
  bool any_left() const { return any_left_; }

  /// The ties in use from now on. Collective.
  void use(const TiedSurfaces& ties);
  const TieStrengths& strengths() const { return strengths_; }

  /// Notes the nodes of the ties in use whose use of their strength has reached 1. Returns how many nodes of each tie
  /// of the deck these are, on all ranks. Collective.
  std::vector<std::int64_t> judge(const Array<const double>& use);
  /// Notes nodes whose glue has failed, by their numbers; those that other ranks own are passed over.
  void note(const std::vector<std::int64_t>& nodes);
  /// Takes the nodes noted last out of the ties of the start. Collective.
  ReleasedTies release(TiedSurfaces& ties);

  /// Number of released nodes, on all ranks.
  std::int64_t count() const { return count_; }

  /// Loading: removes the released nodes from the ties of the start, and returns whether there are any. Collective.
  bool archive(CheckpointArchive& archive, TiedSurfaces& ties);

 private:
  void sum_areas(const Deck& deck, const TiedSurfaces& ties, const std::vector<std::int64_t>& late);
  void refuse_bare(const Deck& deck, const TiedSurfaces& ties) const;

  const ChunkedMesh& chunked_;
  const Communicator ranks_;
  std::vector<ConnectionStrength> laws_;  // [failing ties]
  std::vector<char> is_glue_;             // [ties of the deck]
  std::vector<int> law_of_tie_;           // [ties of the deck] -1: does not fail
  std::vector<std::int64_t> numbers_;     // of the nodes that this rank owns in failing ties, late ones too; ascending
  std::vector<double> areas_;             // [numbers] of those of the start
  std::vector<double> has_failed_;        // [numbers] 1 or 0
  std::vector<std::int64_t> in_use_;      // nodes of the ties in use
  std::vector<int> tie_in_use_;           // [in use] of the deck
  std::vector<std::size_t> noted_;        // places in numbers_, by judge()
  TieStrengths strengths_;
  bool any_left_ = false;
  std::int64_t count_ = 0;
};

}  // namespace percuss
