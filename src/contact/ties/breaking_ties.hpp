#pragma once
// Ties that fail: judged by the impulses of a step, released after it, and reported to the user.

#include <utility>
#include <vector>

#include "src/contact/ties/tie_failures.hpp"
#include "src/warning.hpp"

namespace percuss {

class BreakingTies {
 public:
  /// deck: outlives this. ties: those of the start. late: as of TieFailures. Throws InputError as TieFailures does.
  /// Collective.
  BreakingTies(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
               const std::vector<std::int64_t>& late, const Communicator& ranks)
      : deck_(deck), failures_(chunked, deck, ties, late, ranks) {}

  /// The ties in use from now on. Collective.
  void use(const TiedSurfaces& ties) { failures_.use(ties); }

  /// Keeps ties from failing, in steps before time 0.
  void hold(bool is_held) { is_held_ = is_held; }

  /// Whether any can fail in this step, and at which strength.
  bool can_fail() const { return failures_.any_left() && !is_held_; }
  const TieStrengths& strengths() const { return failures_.strengths(); }

  /// The ties that have reached their strength, each with a warning. uses: of find_tie_uses(); time: of the end of the
  /// step. Returns how many nodes these are, on all ranks. Collective.
  std::int64_t judge(const Array<const double>& uses, double time);

  /// Nodes whose glue has failed in this step, after judge(): numbers, the same on all ranks.
  void let_go(const std::vector<std::int64_t>& nodes) {
    failures_.note(nodes);
    failing_ += static_cast<std::int64_t>(nodes.size());
  }

  /// Whether nodes of judge() wait for release().
  bool are_failing() const { return failing_ > 0; }
  /// Takes these out of the ties of the start. Collective.
  ReleasedTies release(TiedSurfaces& ties);

  /// Number of released nodes, on all ranks.
  std::int64_t count() const { return failures_.count(); }

  /// Warnings since the last call.
  std::vector<Warning> take_warnings() { return std::exchange(warnings_, {}); }

  /// As TieFailures has it. Collective.
  bool archive(CheckpointArchive& archive, TiedSurfaces& ties) { return failures_.archive(archive, ties); }

 private:
  const Deck& deck_;
  TieFailures failures_;
  std::int64_t failing_ = 0;  // tied nodes, on all ranks
  bool is_held_ = false;
  std::vector<Warning> warnings_;
};

}  // namespace percuss
