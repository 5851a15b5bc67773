#include "kernels/contact/search/block_tree.hpp"

#include "kernels/core/host_copy.hpp"

namespace percuss {

void set_order(const std::vector<int>& order, BlockTree& tree) {
  tree.order = to_view("contact::box_order", order);
  tree.num_boxes = static_cast<int>(order.size());
  tree.num_levels = 0;
  int total = 0;
  for (int items = tree.num_boxes; items > 0 && tree.num_levels < BlockTree::max_levels;) {
    const int blocks = (items + block_size - 1) / block_size;
    tree.first[tree.num_levels] = total;
    tree.count[tree.num_levels++] = blocks;
    total += blocks;
    items = blocks > 1 ? blocks : 0;
  }
  reserve(tree.boxes, tree.num_boxes);
  reserve(tree.blocks, total);
}

void refit(const WorkSpace& space, const BlockTree& tree) {
  const BlockTree t = tree;
  if (t.num_levels == 0) return;
  parallel_for(
      "contact::fit_blocks", RangeOf(space, 0, t.count[0]), KOKKOS_LAMBDA(int b) {
        BoxBlock& block = t.blocks(b);
        for (int lane = 0; lane < block_size; ++lane) {
          const int place = b * block_size + lane;
          set_lane(block, lane, place < t.num_boxes ? t.boxes(place).box : make_empty_box());
        }
      });
  for (int level = 1; level < t.num_levels; ++level) {
    const int first = t.first[level], below = t.first[level - 1], count = t.count[level - 1];
    parallel_for(
        "contact::fit_upper_blocks", RangeOf(space, 0, t.count[level]), KOKKOS_LAMBDA(int b) {
          for (int lane = 0; lane < block_size; ++lane) {
            const int child = b * block_size + lane;
            set_lane(t.blocks(first + b), lane,
                     child < count ? bound_lanes(t.blocks(below + child)) : make_empty_box());
          }
        });
  }
}

}  // namespace percuss
