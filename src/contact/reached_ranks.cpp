#include "src/contact/reached_ranks.hpp"

#include <fmt/format.h>

#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// A node that runs away makes every box reach every rank: told before faces are sent to all. unlisted: becomes the
/// largest of all ranks.
void refuse_too_many_copies(const Communicator& ranks, std::int64_t copies, double margin, std::int64_t& unlisted) {
  std::int64_t most[2] = {copies, unlisted};
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_INT64_T, MPI_MAX, ranks.handle()); }, "MPI_Allreduce");
  unlisted = most[1];
  constexpr std::int64_t most_indexed = 1'000'000'000;
  if (most[0] <= most_indexed) return;
  throw RunError(
      fmt::format("contact search needs {} copies of faces on other ranks (capture boxes are {:.3g} wide beyond their "
                  "faces: nodes move many faces a step) is the run unstable? try a smaller time.step_scale",
                  most[0], margin));
}

/// Calls visit(rank) for the ranks that box i reaches, ascending.
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

ReachCount count_reached_ranks(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                               double margin, const ReachedRanks& listed) {
  ReachCount count;
  std::int64_t unlisted = 0;
  const BoxVisit visit{tree, boxes};
  const Array<const int> first = listed.first, rank = listed.rank;
  Kokkos::parallel_reduce(
      "contact::count_reached_ranks", Range(ExecSpace(), 0, num_boxes),
      KOKKOS_LAMBDA(int i, std::int64_t& copies, std::int64_t& others) {
        int next = first(i);
        const int end = first(i + 1);
        visit(i, [&](int r) {
          ++copies;
          while (next < end && rank(next) < r) ++next;
          if (next == end || rank(next) != r) ++others;
        });
      },
      count.copies, unlisted);
  refuse_too_many_copies(ranks, count.copies, margin, unlisted);
  count.any_unlisted = unlisted > 0;
  return count;
}

ReachedRanks list_reached_ranks(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                                double margin) {
  const ExecSpace space;
  ReachedRanks reached;
  reached.first = Array<int>("contact::first_reached", static_cast<std::size_t>(num_boxes) + 1);
  const Array<int> first = reached.first;
  std::int64_t total = 0, unlisted = 0;
  const BoxVisit visit{tree, boxes};
  Kokkos::parallel_scan(
      "contact::place_reached_ranks", Range(space, 0, num_boxes + 1),
      KOKKOS_LAMBDA(int i, std::int64_t& place, bool final_pass) {
        if (final_pass) first(i) = static_cast<int>(place);
        if (i < num_boxes) visit(i, [&](int) { ++place; });
      },
      total);
  refuse_too_many_copies(ranks, total, margin, unlisted);
  const auto copies = static_cast<std::size_t>(total);
  const Array<int> box("contact::reached_box", copies), rank("contact::reached_rank", copies);
  reached.box = box;
  reached.rank = rank;
  Kokkos::parallel_for(
      "contact::list_reached_ranks", Range(space, 0, num_boxes), KOKKOS_LAMBDA(int i) {
        int place = first(i);
        visit(i, [&](int r) {
          box(place) = i;
          rank(place++) = r;
        });
      });
  space.fence();
  return reached;
}

std::int64_t count_boxes_that_reach(const CutTree& tree, const Boxes& boxes, int num_boxes, int rank) {
  std::int64_t count = 0;
  const BoxVisit visit{tree, boxes};
  Kokkos::parallel_reduce(
      "contact::count_reaching_boxes", Range(ExecSpace(), 0, num_boxes),
      KOKKOS_LAMBDA(int i, std::int64_t& sum) { visit(i, [&](int r) { sum += r == rank ? 1 : 0; }); }, count);
  return count;
}

}  // namespace percuss
