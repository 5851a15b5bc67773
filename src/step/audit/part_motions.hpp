#pragma once
// Mean displacement and mean velocity of parts: columns of the history, where the deck requests them.
//
// Both are means over the nodes, weighted with their masses. A node that parts share counts for the one of the lowest
// chunk, as in PartEnergies, whose chunks and exact sums give the same bits on any number of ranks and threads.

#include <vector>

#include "src/step/audit/part_sums.hpp"

namespace percuss {

/// The columns, part after part.
std::vector<HistoryColumn> list_motion_columns(const Deck& deck);

class PartMotions {
 public:
  PartMotions(const Deck& deck, const ChunkedMesh& chunked);

  /// Appends the values of the columns to a row, the same on every rank. Collective; does nothing where the deck names
  /// no part.
  void append(const Model& model, const State& state, std::vector<double>& row);

 private:
  int parts_ = 0;
  std::vector<int> part_of_chunk_;  // [those listed] into the parts with columns
  Array<int> listed_;               // chunks of this rank that belong to these parts
  Rows3<double> start_;             // [nodes] position at time 0
  ChunkSums sums_;                  // [those listed]
};

}  // namespace percuss
