#pragma once
// The rows of tied nodes, the same in every step: made once, given to the enforcement after those of the check.

#include "kernels/contact/rows/row_system.hpp"
#include "src/contact/surface/contact_ranks.hpp"
#include "src/contact/surface/tied_surfaces.hpp"

namespace percuss {

/// How many names work is booked by before the ties' (name_contact_pairs()).
int count_booked_surfaces(const ContactDeck& contact);

class TieRows {
 public:
  /// The nodes that this rank owns; corners of faces that other ranks own are numbered as foreign nodes.
  TieRows(const ContactRanks& ranks, const TiedSurfaces& ties, const ContactDeck& contact);

  /// Whether any rank has any.
  bool any() const { return any_; }

  /// Puts the rows behind the first num_touches; returns how many there are then. Not collective.
  int append(int num_touches, Array<RowTouch>& touches) const;

  /// Keys of the rows, ascending.
  const std::vector<std::int64_t>& keys() const { return keys_; }

  /// [ties of this rank], then of those whose rotation is tied
  const Array<const TieGeometry>& geometry() const { return geometry_; }

 private:
  bool any_ = false;
  Array<const RowTouch> rows_;
  std::vector<std::int64_t> keys_;
  Array<const TieGeometry> geometry_;
};

}  // namespace percuss
