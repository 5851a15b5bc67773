#pragma once
// What each part has of the scene's energies, momentum and mass: columns of the history, where the deck requests them.
//
// A part consists of whole chunks; a node that parts share counts for the one of the lowest chunk. So the sums of the
// audit, which are exact sums of those of the chunks, fall apart into sums of the parts: these have the same bits on
// any number of ranks and threads, and add up to those of the scene. Rigid parts count by the shapes of their elements;
// what else their body has, as masses that the deck gives, counts for its first part.

#include <optional>
#include <string>
#include <vector>

#include "src/step/audit/part_sums.hpp"
#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {

/// Parts in the order of the deck's list; of `all`, in that of the parts.
std::vector<BookedPart> find_booked_parts(const Deck& deck);

/// The columns, part after part.
std::vector<HistoryColumn> list_part_columns(const std::vector<BookedPart>& parts);

/// Energies of a part, without what its dead elements took [energy].
struct PartEnergy {
  double internal = 0, hourglass = 0;
};

/// [Mesh::parts] of all ranks, the same bits on any number of them. Collective.
std::vector<PartEnergy> sum_part_energies(const ChunkedMesh& chunked, const Model& model, const State& state);

class PartEnergies {
 public:
  /// chunked outlives this.
  PartEnergies(const Deck& deck, const ChunkedMesh& chunked);

  /// Appends the values of the columns to a row, the same on every rank. One message a rank. Collective; does nothing
  /// where the deck names no part.
  void append(const Model& model, const State& state, std::vector<double>& row);

 private:
  void find_bodies(const Deck& deck, const std::vector<int>& place);
  std::vector<ExactSum> sum_parts(const Model& model, const State& state);
  void add_bodies(const Model& model, const State& state, std::vector<ExactSum>& sums);

  const ChunkedMesh& chunked_;
  std::vector<BookedPart> parts_;
  std::vector<int> chunks_;         // of this rank that belong to these parts
  std::vector<int> part_of_chunk_;  // [those] into parts_
  Array<int> listed_;               // the same chunks, for the kernel
  ChunkSums node_sums_;             // [those]
  // Bodies with rigid parts, whose nodes do not count; empty: there are none.
  std::vector<int> part_of_body_;  // [bodies] first part, into parts_; -1: it has none, or no columns
  Array<int> has_own_mass_;        // [bodies] 1: its nodes do not count
  std::optional<BodyForceFinder> find_forces_;
};

}  // namespace percuss
