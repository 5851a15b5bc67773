#pragma once
// From the local coordinates of a shape to those of the scene: array copies, rotations, translation, in this order.

#include <array>
#include <optional>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

class PartPlacement {
 public:
  explicit PartPlacement(const PartDeck& part);

  /// Number of copies that the part's array makes; 1 without an array.
  int copies() const { return copies_; }

  /// Place of a local point of a copy [length]. Copies count along x first.
  Vec3 operator()(const Vec3& local, int copy) const;

 private:
  struct Turn {
    std::array<Vec3, 3> matrix;
    Vec3 center;
  };

  Vec3 find_offset(int copy) const;

  std::optional<ArrayCopies> array_;
  int copies_ = 1;
  std::vector<Turn> turns_;
  Vec3 at_;
};

}  // namespace percuss
