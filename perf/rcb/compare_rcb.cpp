// Recursive coordinate bisection by comm/rcb and by Zoltan, in turns, in one run: seconds and their ratio, cold (points
// dealt to the ranks by turns, nothing known) and warm (points at their owners, moved a little). What is timed: from
// points that lie on some ranks to points that lie on their owners, migration included, which is the same code for
// both.
//
//     mpirun -n 2 compare_rcb [POINTS [ROUNDS]]

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>

#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/unstructured_exchange.hpp"
#include "comm/rcb/rcb.hpp"
#include "perf/rcb/bisection.hpp"

namespace percuss::perf {
namespace {

using Points = std::vector<HeldPoint>;
using FindOwners = std::function<std::vector<int>(const Points&)>;

/// Random points of the unit cube, dealt by turns: nobody holds what he will own.
Points make_points(const Communicator& ranks, std::int64_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  Points own;
  for (std::int64_t id = 0; id < count; ++id) {
    const HeldPoint point{{place(random), place(random), place(random)}, id};
    if (id % ranks.size() == ranks.rank()) own.push_back(point);
  }
  return own;
}

/// A step of motion: all drift, each jitters, by a hundredth of the mean distance of neighbours.
void move_points(Points& points, double step, int round) {
  for (HeldPoint& point : points) {
    std::minstd_rand random(static_cast<unsigned>(point.id + 1 + 7919 * round));
    std::uniform_real_distribution<double> jitter(-1, 1);
    for (double& x : point.x) x += step * (1 + jitter(random));
  }
}

class Migration {
 public:
  explicit Migration(const Communicator& ranks) : rank_(ranks.rank()), exchange_(ranks), data_(ranks) {}

  void operator()(Points& points, const std::vector<int>& owners) {
    Points staying, leaving;
    std::vector<int> to;
    for (std::size_t i = 0; i < points.size(); ++i) {
      (owners[i] == rank_ ? staying : leaving).push_back(points[i]);
      if (owners[i] != rank_) to.push_back(owners[i]);
    }
    const SendOrder order = order_by_destination(to);
    Points ordered;
    for (const int i : order.items) ordered.push_back(leaving[static_cast<std::size_t>(i)]);
    const Points arrived = data_.exchange(exchange_.plan(order.to), ordered);
    staying.insert(staying.end(), arrived.begin(), arrived.end());
    points = std::move(staying);
  }

 private:
  int rank_;
  UnstructuredExchange exchange_;
  DataExchange data_;
};

std::vector<int> find_owners_by_rcb(Rcb& rcb, const Points& points) {
  const Rows3<double> positions(Kokkos::view_alloc("positions", Kokkos::WithoutInitializing), points.size());
  const Array<std::int64_t> ids(Kokkos::view_alloc("ids", Kokkos::WithoutInitializing), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) positions(i, k) = points[i].x[k];
    ids(i) = points[i].id;
  }
  rcb.decompose(ExecSpace(), {positions, ids, {}});
  const Array<int> owners(Kokkos::view_alloc("owners", Kokkos::WithoutInitializing), points.size());
  find_owners(ExecSpace(), rcb.tree(), positions, ids, owners);
  ExecSpace().fence();
  return {owners.data(), owners.data() + points.size()};
}

/// Seconds from points anywhere to points at their owners, of the slowest rank.
double time_bisection(const Communicator& ranks, const FindOwners& find_owners, Migration& migrate, Points& points) {
  ranks.barrier();
  const double start = MPI_Wtime();
  migrate(points, find_owners(points));
  ranks.barrier();
  double seconds = MPI_Wtime() - start;
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, ranks.handle()), "MPI_Allreduce");
  return seconds;
}

double find_median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

struct Times {
  std::vector<double> rcb, zoltan, ratio;

  void add(double by_rcb, double by_zoltan) {
    rcb.push_back(by_rcb);
    zoltan.push_back(by_zoltan);
    ratio.push_back(by_zoltan / by_rcb);
  }
  void print(const char* name) const {
    std::printf("%s: comm/rcb %.2f ms, Zoltan %.2f ms, Zoltan / comm/rcb %.2f (medians of %zu, ratios %.2f to %.2f)\n",
                name, 1e3 * find_median(rcb), 1e3 * find_median(zoltan), find_median(ratio), ratio.size(),
                *std::min_element(ratio.begin(), ratio.end()), *std::max_element(ratio.begin(), ratio.end()));
  }
};

void compare(const Communicator& ranks, std::int64_t count, int rounds) {
  const Points dealt = make_points(ranks, count);
  const double step = 0.01 / std::cbrt(static_cast<double>(count));
  Migration migrate(ranks);
  Times cold, warm;
  for (int round = 0; round < rounds; ++round) {
    Rcb rcb(ranks);
    ZoltanBisection zoltan(ranks);
    const FindOwners by_rcb = [&](const Points& points) { return find_owners_by_rcb(rcb, points); };
    const FindOwners by_zoltan = [&](const Points& points) { return zoltan.find_owners(points); };
    Points ours = dealt, theirs = dealt;
    const double cold_rcb = time_bisection(ranks, by_rcb, migrate, ours);
    cold.add(cold_rcb, time_bisection(ranks, by_zoltan, migrate, theirs));
    for (int moves = 0; moves < 3; ++moves) {
      move_points(ours, step, moves);
      move_points(theirs, step, moves);
      const double warm_rcb = time_bisection(ranks, by_rcb, migrate, ours);
      warm.add(warm_rcb, time_bisection(ranks, by_zoltan, migrate, theirs));
    }
  }
  if (ranks.rank() != 0) return;
  std::printf("%lld points on %d ranks\n", static_cast<long long>(count), ranks.size());
  cold.print("cold");
  warm.print("warm");
}

}  // namespace
}  // namespace percuss::perf

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  const Kokkos::ScopeGuard kokkos(argc, argv);
  const long long count = argc > 1 ? std::atoll(argv[1]) : 1000000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 9;
  if (count < 1 || rounds < 1) {
    std::fprintf(stderr, "usage: compare_rcb [POINTS [ROUNDS]]\n");
    return 2;
  }
  percuss::perf::compare(percuss::Communicator::world(), count, rounds);
  return 0;
}
