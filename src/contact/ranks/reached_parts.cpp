#include "src/contact/ranks/reached_parts.hpp"

#include <fmt/format.h>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// A node that diverges makes every box reach every part: reported before faces are sent to all. most: of all ranks.
void refuse_too_many_copies(std::int64_t most, double margin) {
  constexpr std::int64_t most_indexed = 1'000'000'000;
  if (most <= most_indexed) return;
  throw RunError(fmt::format(
      "contact search needs {} copies of faces on other ranks (capture boxes extend {:.3g} beyond their faces: nodes "
      "cross many faces per step): the run is probably unstable; try a smaller time.step_scale",
      most, margin));
}

/// Calls visit(part) for the parts that box i reaches, ascending.
struct BoxVisit {
  CutTree tree;
  Boxes boxes;

  template <class Visit>
  KOKKOS_INLINE_FUNCTION void operator()(int i, const Visit& visit) const {
    using Corner = Kokkos::Array<double, 3>;
    const Corner low{{boxes(i, 0), boxes(i, 1), boxes(i, 2)}}, high{{boxes(i, 3), boxes(i, 4), boxes(i, 5)}};
    visit_reached_ranks(tree, low, high, visit);
  }
};

}  // namespace

ReachCount count_reached_parts(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                               double margin, const ReachedParts& listed) {
  ReachCount count;
  std::int64_t unlisted = 0;
  const BoxVisit visit{tree, boxes};
  const Array<const int> first = listed.first, part = listed.part;
  parallel_reduce(
      "contact::count_reached_parts", RangeOf(ExecSpace(), 0, num_boxes),
      KOKKOS_LAMBDA(int i, std::int64_t& copies, std::int64_t& others) {
        int next = first(i);
        const int end = first(i + 1);
        visit(i, [&](int p) {
          ++copies;
          while (next < end && part(next) < p) ++next;
          if (next == end || part(next) != p) ++others;
        });
      },
      count.copies, unlisted);
  std::int64_t most[2] = {count.copies, unlisted};
  all_reduce(ranks, Reduce::largest, most);
  refuse_too_many_copies(most[0], margin);
  count.any_unlisted = most[1] > 0;
  return count;
}

ReachedParts list_reached_parts(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                                double margin) {
  const ExecSpace space;
  ReachedParts reached;
  reached.first = Array<int>("contact::first_reached", static_cast<std::size_t>(num_boxes) + 1);
  const Array<int> first = reached.first;
  std::int64_t total = 0;
  const BoxVisit visit{tree, boxes};
  parallel_scan(
      "contact::place_reached_parts", RangeOf(space, 0, num_boxes + 1),
      KOKKOS_LAMBDA(int i, std::int64_t& place, bool final_pass) {
        if (final_pass) first(i) = static_cast<int>(place);
        if (i < num_boxes) visit(i, [&](int) { ++place; });
      },
      total);
  std::int64_t most[2] = {total, 0};
  all_reduce(ranks, Reduce::largest, most);
  refuse_too_many_copies(most[0], margin);
  const auto copies = static_cast<std::size_t>(total);
  const Array<int> box("contact::reached_box", copies), part("contact::reached_part", copies);
  reached.box = box;
  reached.part = part;
  parallel_for(
      "contact::list_reached_parts", RangeOf(space, 0, num_boxes), KOKKOS_LAMBDA(int i) {
        int place = first(i);
        visit(i, [&](int p) {
          box(place) = i;
          part(place++) = p;
        });
      });
  space.fence();
  return reached;
}

std::int64_t count_boxes_that_reach(const CutTree& tree, const Boxes& boxes, int num_boxes, int part) {
  std::int64_t count = 0;
  const BoxVisit visit{tree, boxes};
  parallel_reduce(
      "contact::count_reaching_boxes", RangeOf(ExecSpace(), 0, num_boxes),
      KOKKOS_LAMBDA(int i, std::int64_t& sum) { visit(i, [&](int p) { sum += p == part ? 1 : 0; }); }, count);
  return count;
}

}  // namespace percuss
