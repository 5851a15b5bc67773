#pragma once
// From the local coordinates of a shape to those of the scene: array copies, rotations, translation, images of `mirror`
// and `pattern`, motions of `place`, in this order.

#include <array>
#include <optional>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/part_images.hpp"

namespace percuss {

/// x becomes center + matrix (x - center) + shift.
struct Motion {
  TurnMatrix matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 center{}, shift{};

  Vec3 operator()(const Vec3& x) const {
    const Vec3 turned = transform(matrix, {x[0] - center[0], x[1] - center[1], x[2] - center[2]});
    return {center[0] + turned[0] + shift[0], center[1] + turned[1] + shift[1], center[2] + turned[2] + shift[2]};
  }
};

class PartPlacement {
 public:
  explicit PartPlacement(const PartDeck& part);

  /// Number of copies that the part's array makes; 1 without an array.
  int copies() const { return copies_; }

  /// Place of a local point of a copy [length]. Copies count along x first.
  Vec3 operator()(const Vec3& local, int copy) const;

  /// Adds a motion after all that the deck says of the part alone.
  void move(const Motion& motion) { motions_.push_back(motion); }

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
  std::vector<Motion> motions_;
};

}  // namespace percuss
