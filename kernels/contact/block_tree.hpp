#pragma once
// Boxes in blocks of sixteen that lie near each other, blocks of blocks above them: built rarely, refitted each search.
//
// Boxes are compared in float, relative to an origin near them. Subtraction and conversion never change the order of
// two coordinates, only make some equal: what meets in double meets in float too, and no pair is lost.

#include "kernels/contact/contact_state.hpp"
#include "kernels/contact/lane_mask.hpp"
#include "kernels/contact/small_space.hpp"

namespace percuss {

struct BlockTree {
  static constexpr int max_levels = 8;  // 16^8 boxes are more than an int counts

  int num_boxes = 0;
  int num_levels = 0;                                                  // level 0: blocks of boxes
  int first[max_levels] = {};                                          // of each level in `blocks`
  int count[max_levels] = {};                                          // blocks of each level
  Array<int> order = Array<int>("contact::box_order", 0);              // [boxes] place in the query of each box
  Array<BoxBlock> blocks = Array<BoxBlock>("contact::box_blocks", 0);  // by level
};

KOKKOS_INLINE_FUNCTION float to_float(double value, double origin) { return static_cast<float>(value - origin); }

/// The box that holds all lanes of a block.
KOKKOS_FORCEINLINE_FUNCTION FloatBox bound_lanes(const BoxBlock& block) {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = block.low[axis][0];
    box.high[axis] = block.high[axis][0];
    for (int lane = 1; lane < block_size; ++lane) {
      box.low[axis] = block.low[axis][lane] < box.low[axis] ? block.low[axis][lane] : box.low[axis];
      box.high[axis] = block.high[axis][lane] > box.high[axis] ? block.high[axis][lane] : box.high[axis];
    }
  }
  return box;
}

KOKKOS_FORCEINLINE_FUNCTION FloatBox get_lane(const BoxBlock& block, int lane) {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = block.low[axis][lane];
    box.high[axis] = block.high[axis][lane];
  }
  return box;
}

KOKKOS_FORCEINLINE_FUNCTION void set_lane(BoxBlock& block, int lane, const FloatBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    block.low[axis][lane] = box.low[axis];
    block.high[axis][lane] = box.high[axis];
  }
}

/// A box that meets nothing finite.
KOKKOS_INLINE_FUNCTION FloatBox make_empty_box() {
  constexpr float beyond = 3.4e38F;
  return {{beyond, beyond, beyond}, {-beyond, -beyond, -beyond}};
}

/// Takes the order of the boxes and makes room. order: places in the query.
void set_order(const std::vector<int>& order, BlockTree& tree);

/// Fits all blocks to the boxes of this search. origin: [3] that coordinates in float are relative to.
template <class Space>
void refit(const Space& space, const Boxes& boxes, const double* origin, const BlockTree& tree);

/// Calls visit(place in BlockTree::order, box) for every box that meets `query` in float.
template <class Visit>
KOKKOS_FORCEINLINE_FUNCTION void visit_meeting_boxes(const BlockTree& tree, const FloatBox& query, const Visit& visit) {
  struct Entry {
    int level, block;
  };
  if (tree.num_levels == 0) return;
  Entry stack[BlockTree::max_levels * block_size];
  int depth = 0;
  stack[depth++] = {tree.num_levels - 1, 0};
  while (depth > 0) {
    const Entry at = stack[--depth];
    const BoxBlock& block = tree.blocks(tree.first[at.level] + at.block);
    for (std::uint32_t mask = find_meeting_lanes(block, query); mask != 0; mask &= mask - 1) {
      const int lane = find_lowest_bit(mask), child = at.block * block_size + lane;
      if (at.level > 0) {
        if (child < tree.count[at.level - 1]) stack[depth++] = {at.level - 1, child};
      } else if (child < tree.num_boxes) {
        visit(child, get_lane(block, lane));
      }
    }
  }
}

}  // namespace percuss
