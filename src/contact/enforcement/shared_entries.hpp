#pragma once
// Entries of rows on nodes that rows of several ranks touch: who has which, and who sends what to whom.
//
// The owner of such a node learns from notices which rows of other ranks touch it, and answers each of these ranks with
// the data of the node and the entries that all others have on it. Then all of them know the same list, and what they
// send each other follows from it without a word: by node, and as each lists its own.

#include <cstdint>
#include <vector>

#include "comm/exchange/exchange_plan.hpp"
#include "kernels/contact/rows/row_system.hpp"
#include "src/contact/surface/contact_ranks.hpp"

namespace percuss {

/// A row on a foreign node in the message to its owner.
struct RowNotice {
  std::int64_t node = 0;  // number
  std::int64_t key = 0;   // of the row
};

/// The nodes of other ranks that rows of this one touch, by owner and number.
struct ForeignNodes {
  std::vector<std::int64_t> numbers;  // [nodes]
  std::vector<PeerRun> owners;        // runs of nodes
  std::vector<int> of_slot;           // [k] node of the touch's slot with RowTouch::node -1 - k
  std::vector<RowNotice> notices;     // by node, then as rows come
  std::vector<int> entries;           // [notices] row * row_nodes + slot
  std::vector<PeerRun> notice_runs;   // by owner
};

ForeignNodes find_foreign_nodes(const ContactRanks& ranks, const Array<const RowTouch>& touches, int num_touches);

/// An entry on a node that rows of several ranks touch.
struct SharedEntry {
  std::int64_t node = 0;  // number
  std::int64_t key = 0;   // of the row
  int owner = 0;          // of the node
  int place = 0;          // of the node
  int rank = 0;           // that has the row
  int entry = -1;         // row * row_nodes + slot, of a row of this rank
};

/// Entries that a rank sends and receives in each swap.
struct SwapLists {
  std::vector<int> sent;          // [sent] row * row_nodes + slot
  std::vector<std::int64_t> key;  // [received] of the row
  std::vector<int> place;         // [received] of the node
  ExchangePlan plan;
};

/// entries: all on nodes that this rank shares; those of a node and rank in the order in which that rank lists them.
SwapLists list_swaps(std::vector<SharedEntry> entries, int own_rank);

/// The entries of this rank's rows on own nodes that others touch. is_touched: [mesh nodes]; place: [mesh nodes].
std::vector<SharedEntry> list_own_entries(const ContactRanks& ranks, const RowSources& sources, const RowSystem& system,
                                          const std::vector<char>& is_touched);

/// Data of a node and how many entries follow, in the answer to a rank that touches it; and such an entry.
struct NodeAnswer {
  double x[3], v[3], v_before[3], v_checked[3], inverse_mass[3];
  double spring, growth;
  std::int32_t body;  // rigid, -1: none
  std::int32_t entries;
};
struct EntryAnswer {
  std::int64_t key, rank;
};

/// Word of an answer's message: a node takes several, an entry one.
struct AnswerWord {
  std::int64_t value[2];
};
static_assert(sizeof(NodeAnswer) % sizeof(AnswerWord) == 0 && sizeof(EntryAnswer) == sizeof(AnswerWord));

/// Node data by place, on the host, to and from answers.
class HostRowNodes {
 public:
  explicit HostRowNodes(const RowSystem& system);
  NodeAnswer get(int place) const;
  void set(int place, const NodeAnswer& answer);
  /// Copies the lists to where kernels run.
  void write(RowSystem& system) const;

 private:
  HostMirror<Rows3<double>> x_, v_, v_before_, v_checked_, inverse_mass_;
  HostMirror<Array<double>> spring_, growth_;
  HostMirror<Array<int>> body_;
  bool has_springs_, has_bodies_;
};

}  // namespace percuss
