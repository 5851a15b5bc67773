#pragma once
// Boxes in blocks of sixteen that lie near each other, blocks of blocks above them: built rarely, refitted each search.
//
// Boxes are compared in float, relative to an origin near them. Subtraction and conversion never change the order of
// two coordinates, only make some equal: what meets in double meets in float too, and no pair is lost.

#include "kernels/contact/surface/pair_query.hpp"
#include "kernels/core/prefetch.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// A box of the search and what the rule asks of it, in one line of the cache.
struct alignas(64) TreeBox {
  FloatBox box;
  BoxMark mark;
};

struct BlockTree {
  static constexpr int max_levels = 8;  // 16^8 boxes are more than an int counts

  int num_boxes = 0;
  int num_levels = 0;                                                  // level 0: blocks of boxes
  int first[max_levels] = {};                                          // of each level in `blocks`
  int count[max_levels] = {};                                          // blocks of each level
  Array<int> order = Array<int>("contact::box_order", 0);              // [boxes] place in the query of each box
  Array<TreeBox> boxes = Array<TreeBox>("contact::tree_boxes", 0);     // in that order
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

/// Fits all blocks to `boxes` of the tree.
void refit(const WorkSpace& space, const BlockTree& tree);

/// Calls visit(first, mask) for every block of boxes some of which meet `query`: bit i is the box at `first` + i of
/// BlockTree::boxes.
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
    const int first = at.block * block_size;
    const int items = at.level > 0 ? tree.count[at.level - 1] : tree.num_boxes, left = items - first;
    std::uint32_t mask = find_meeting_lanes(tree.blocks(tree.first[at.level] + at.block), query);
    if (left < block_size) mask &= (std::uint32_t{1} << left) - 1;  // a query that is not finite meets empty boxes too
    if (at.level == 0) {
      visit(first, mask);
    } else {
      for (; mask != 0; mask &= mask - 1) {
        const int child = first + find_lowest_bit(mask);
        fetch_ahead(&tree.blocks(tree.first[at.level - 1] + child));
        stack[depth++] = {at.level - 1, child};
      }
    }
  }
}

}  // namespace percuss
