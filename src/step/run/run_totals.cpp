#include "src/step/run/run_totals.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "comm/all_reduce.hpp"

namespace percuss {

namespace {

std::vector<std::int64_t> count_elements(const Numbering& numbering, int rank_count) {
  std::vector<std::int64_t> elements(static_cast<std::size_t>(rank_count), 0);
  for (std::size_t c = 0; c < numbering.ranks.size(); ++c) {
    elements[static_cast<std::size_t>(numbering.ranks[c])] +=
        numbering.first_element[c + 1] - numbering.first_element[c];
  }
  return elements;
}

}  // namespace

std::int64_t find_peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

double find_element_balance(const Numbering& numbering, int rank_count) {
  const std::vector<std::int64_t> elements = count_elements(numbering, rank_count);
  const auto most = static_cast<double>(*std::max_element(elements.begin(), elements.end()));
  return most * rank_count / static_cast<double>(numbering.element_count());
}

int count_idle_ranks(const Numbering& numbering, int rank_count) {
  const std::vector<std::int64_t> elements = count_elements(numbering, rank_count);
  return static_cast<int>(std::count(elements.begin(), elements.end(), 0));
}

void take_largest(const Communicator& ranks, Summary& summary) {
  auto peak = static_cast<double>(summary.peak_bytes);  // exact up to 2^53
  std::vector<double*> places{&summary.setup_s, &summary.loop_s, &peak};
  visit_phases(summary.phases_s, [&](const char*, double& seconds) { places.push_back(&seconds); });
  std::vector<double> values;
  for (const double* const place : places) values.push_back(*place);
  all_reduce(ranks, Reduce::largest, values);
  for (std::size_t i = 0; i < places.size(); ++i) *places[i] = values[i];
  summary.peak_bytes = static_cast<std::int64_t>(peak);
}

Traffic sum_traffic(const Communicator& ranks, const Traffic& own) {
  std::array<std::int64_t, 2> sums{own.messages, own.bytes};
  all_reduce(ranks, Reduce::sum, sums);
  return {sums[0], sums[1]};
}

std::int64_t sum_counts(const Communicator& ranks, std::int64_t own) {
  all_reduce(ranks, Reduce::sum, own);
  return own;
}

std::vector<RankRow> gather_rows(const Communicator& ranks, const RankRow& own) {
  static_assert(std::is_trivially_copyable_v<RankRow>, "rows travel as bytes");
  constexpr int bytes = sizeof(RankRow);
  std::vector<RankRow> rows(ranks.rank() == 0 ? static_cast<std::size_t>(ranks.size()) : 0);
  wait_mpi([&] { return MPI_Gather(&own, bytes, MPI_BYTE, rows.data(), bytes, MPI_BYTE, 0, ranks.handle()); },
           "MPI_Gather");
  return rows;
}

}  // namespace percuss
