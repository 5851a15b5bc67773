#include "src/contact/reached_ranks.hpp"

#include <fmt/format.h>

#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// A node that runs away makes every box reach every rank: told before faces are sent to all.
void refuse_too_many_copies(const Communicator& ranks, std::int64_t copies, double margin) {
  std::int64_t most = copies;
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, ranks.handle()); },
           "MPI_Allreduce");
  constexpr std::int64_t most_indexed = 1'000'000'000;
  if (most <= most_indexed) return;
  throw RunError(
      fmt::format("contact search needs {} copies of faces on other ranks (capture boxes are {:.3g} wide beyond their "
                  "faces: nodes move many faces a step) is the run unstable? try a smaller time.step_scale",
                  most, margin));
}

}  // namespace

ReachedRanks list_reached_ranks(const Communicator& ranks, const CutTree& tree, const Boxes& boxes, int num_boxes,
                                double margin, Array<int>& first) {
  const ExecSpace space;
  reserve(first, num_boxes + 1);
  const Array<int> place_of = first;
  using Corner = Kokkos::Array<double, 3>;
  std::int64_t total = 0;
  const auto visit = [tree, boxes] KOKKOS_FUNCTION(int i, const auto& call) {
    const Corner low{{boxes(i, 0), boxes(i, 1), boxes(i, 2)}}, high{{boxes(i, 3), boxes(i, 4), boxes(i, 5)}};
    visit_reached_ranks(tree, low, high, call);
  };
  Kokkos::parallel_scan(
      "contact::count_reached_ranks", Range(space, 0, num_boxes),
      KOKKOS_LAMBDA(int i, std::int64_t& place, bool final_pass) {
        if (final_pass) place_of(i) = static_cast<int>(place);
        visit(i, [&](int) { ++place; });
      },
      total);
  refuse_too_many_copies(ranks, total, margin);
  const auto copies = static_cast<std::size_t>(total);
  const Array<int> box("contact::reached_box", copies), rank("contact::reached_rank", copies);
  Kokkos::parallel_for(
      "contact::list_reached_ranks", Range(space, 0, num_boxes), KOKKOS_LAMBDA(int i) {
        int place = place_of(i);
        visit(i, [&](int r) {
          box(place) = i;
          rank(place++) = r;
        });
      });
  space.fence();
  const auto host_box = to_host(box), host_rank = to_host(rank);
  return {{host_box.data(), host_box.data() + total}, {host_rank.data(), host_rank.data() + total}};
}

}  // namespace percuss
