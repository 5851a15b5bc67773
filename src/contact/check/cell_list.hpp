#pragma once
// The pairs that are near enough to be checked, by cells with travels of their own, made where that leaves out enough.

#include <algorithm>
#include <cstdint>

#include "kernels/core/small_space.hpp"

namespace percuss {

/// Cells: NearCells or EdgeCells; Pairs: the list, with its number as num_pairs.
template <class Cells, class Pairs>
class CellList {
 public:
  /// The pairs are others now.
  void forget() {
    is_new_ = true;
    is_used_ = false;
  }

  /// Goes on after those of another surface. Where surfaces change soon again, more checks go by without a list.
  void take_over(const CellList& before) {
    constexpr int worth_it = 16, most = 63;
    after_change_ = before.checks_ < worth_it ? std::min(2 * before.after_change_ + 1, most) : 0;
    left_out_ = std::max(after_change_, before.left_out_);
    pause_ = before.pause_;
  }

  /// Lists the near pairs for this step, or leaves all of them to be checked.
  template <class Inputs>
  void update(const Inputs& inputs, const Pairs& all) {
    constexpr double worth_it = 0.7;  // share of the pairs above which a list saves nothing
    constexpr int least_pause = 15, most_pause = 255;
    ++checks_;
    if (left_out_ > 0) {
      --left_out_;
      is_used_ = false;
      return;
    }
    list(inputs, all);
    is_used_ = near_.num_pairs <= worth_it * all.num_pairs;
    if (!is_used_) left_out_ = pause_;
    pause_ = is_used_ ? least_pause : std::min(2 * pause_ + 1, most_pause);
  }

  /// The near pairs, or all where they are not listed.
  const Pairs& choose(const Pairs& all) const { return is_used_ ? near_ : all; }

 private:
  template <class Inputs>
  void list(const Inputs& inputs, const Pairs& all) {
    constexpr double ahead = 16, of_step = 5;  // steps for which lists hold; what a step takes besides, CellTravels
    constexpr double most_growth = 1.25;
    constexpr int least_growth = 64, pairs_a_touch = 8;  // pairs that cost as much as one that is checked
    const bool restarts =
        is_new_ || !is_used_ || listed_again_ > all.num_pairs || near_.num_pairs > most_growth * listed_ + least_growth;
    run_where_it_pays(all.num_pairs / pairs_a_touch, [&](const WorkSpace& space) {
      if (is_new_) watch_cells(space, inputs.surface, all, cells_);
      if (restarts)
        restart_cells(space, inputs, all, ahead + of_step, cells_);
      else
        find_due_cells(space, inputs, all, ++steps_, ahead, cells_);
      list_near(space, inputs, all, cells_, near_);
      space.fence();
    });
    is_new_ = false;
    listed_again_ += cells_.due_pairs;
    if (!restarts) return;
    listed_ = near_.num_pairs;
    listed_again_ = steps_ = 0;
  }

  Cells cells_;
  Pairs near_;
  bool is_new_ = true, is_used_ = false;
  int steps_ = 0;                      // since travels began
  std::int64_t listed_again_ = 0;      // pairs of cells that were listed again since then
  int listed_ = 0;                     // near pairs then
  int left_out_ = 0, pause_ = 15;      // checks of all pairs: still to come, and after a list that was not worth it
  int checks_ = 0, after_change_ = 0;  // of this surface; without a list at its beginning
};

}  // namespace percuss
