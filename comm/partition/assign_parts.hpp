#pragma once
// Assigns each part of a dynamic decomposition to the rank that has most of its points already.
//
// The bisection numbers its parts by where they lie; a static decomposition numbers its own by what it likes. A part
// given to the rank that owns most of its points in the other decomposition has them to hand, where messages would
// carry them in every step.

#include <cstdint>
#include <vector>

#include "comm/rcb/rcb.hpp"

namespace percuss {

/// Points that a rank has in one decomposition and that belong to a part of the other.
struct Overlap {
  int rank = 0, part = 0;
  std::int64_t points = 0;
};

/// Largest number of overlaps that a rank reports; smaller ones have little effect.
inline constexpr std::size_t most_overlaps = 8;

/// The largest overlaps of a rank, largest first. parts: [points of the rank].
std::vector<Overlap> find_overlaps(int rank, const std::vector<int>& parts);

/// The rank of each part, [count], every rank once: largest overlaps first, what is left in order. overlaps: of all
/// ranks, in any order.
std::vector<int> assign_parts(std::vector<Overlap> overlaps, int count);

/// A bisection whose parts are given to ranks: what Rcb calls a rank is a part.
class AssignedParts {
 public:
  /// rank_of_part: as assign_parts() gives it; empty: part p is that of rank p. Collective. Throws MpiError.
  explicit AssignedParts(const Communicator& ranks, std::vector<int> rank_of_part = {});

  Rcb& bisection() { return rcb_; }
  const Rcb& bisection() const { return rcb_; }
  const std::vector<int>& rank_of_part() const { return rank_of_part_; }
  int find_rank(int part) const { return rank_of_part_[static_cast<std::size_t>(part)]; }

 private:
  std::vector<int> rank_of_part_;
  Rcb rcb_;  // over the ranks in the order of their parts
};

}  // namespace percuss
