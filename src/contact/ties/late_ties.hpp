#pragma once
// Ties that begin or end in the run, and those that take in nodes as they come into contact.
//
// Such a tie is found at the places of the moment and keeps them. What it has found is in checkpoints, since the mesh
// of time 0 does not say it.

#include <cstdint>
#include <string>
#include <vector>

#include "src/contact/surface/surface_classes.hpp"
#include "src/contact/ties/tie_failures.hpp"
#include "src/contact/ties/ties.hpp"

namespace percuss {

class LateTies {
 public:
  /// ties: those of the start. Collective, as is all that follows.
  LateTies(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties, const Communicator& ranks);

  bool any() const { return any_; }

  /// Whether nodes that come into contact now are tied.
  bool grows(const ActiveContact& active) const;

  /// Owned nodes of sides a that may be tied later, ascending.
  const std::vector<std::int64_t>& numbers() const { return numbers_; }

  /// Ties the nodes of ties that have begun to act, at places [mesh nodes]; releases those of ties that act no more. A
  /// tie that finds nothing is a RunError, unless the deck allows it. Tells of each in lines.
  ReleasedTies switch_now(const ActiveContact& before, const ActiveContact& now, const std::vector<Vec3>& places,
                          TiedSurfaces& ties, std::vector<std::string>& lines);

  /// Owned nodes that a growing tie may take in: nodes of its side a that were never tied, ascending numbers; and
  /// whether a face, by its number, is of its side b.
  bool may_stick(std::size_t tie, std::int64_t node) const;
  bool is_of_side_b(std::size_t tie, std::int64_t face) const;

  /// Ties these owned nodes, which touch side b. Returns how many became so, on all ranks.
  std::int64_t stick(std::size_t tie, const std::vector<std::int64_t>& nodes, const std::vector<Vec3>& places,
                     TiedSurfaces& ties);

  /// Keeps what has been found of nodes that the ties have got since, with their areas.
  void note(const TiedSurfaces& ties);

  /// Faces and nodes of late ties, from the mesh and the tied nodes as they are now.
  void refresh(const ActiveContact& active, TiedSurfaces& ties);

  /// Loading: gives the ties what they had. Returns whether there is any such tie.
  bool archive(CheckpointArchive& archive, const ActiveContact& active, TiedSurfaces& ties);

 private:
  ReleasedTies end(std::size_t tie, TiedSurfaces& ties) const;

  const ChunkedMesh& chunked_;
  const Deck& deck_;
  const Communicator ranks_;
  bool any_ = false;
  std::vector<std::int64_t> numbers_;
  std::vector<std::vector<std::int64_t>> sides_a_;  // [ties] of growing ones: their nodes in numbers_
  std::vector<double> records_;                     // [numbers] record_size each; the first is the tie
  std::vector<std::vector<std::int64_t>> faces_b_;  // [ties] of growing ones: numbers of all ranks, ascending
};

}  // namespace percuss
