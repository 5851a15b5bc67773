#include "src/step/results/spring_columns.hpp"

#include <fmt/format.h>

namespace percuss {

std::vector<HistoryColumn> list_spring_columns(const SpringModel& springs) {
  if (!springs.any()) return {};
  std::vector<HistoryColumn> columns = {
      {"spring_work", dimensions::energy, "energy of springs, within the internal energy"},
      {"damper_work", dimensions::energy, "energy that dampers have taken, within the viscous energy"}};
  for (const Spring& spring : springs.springs) {
    if (!spring.has_columns) continue;
    columns.push_back({"spring_force:" + spring.name, dimensions::force,
                       fmt::format("force of spring '{}', its damper included, positive in tension", spring.name)});
    columns.push_back({"spring_elongation:" + spring.name, dimensions::length,
                       fmt::format("elongation of spring '{}'", spring.name)});
  }
  return columns;
}

void append_springs(const SpringModel& springs, const State& state, std::vector<double>& row) {
  if (state.springs.empty()) return;
  row.push_back(state.books.spring_work);
  row.push_back(state.books.damper_work);
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    if (!springs.springs[s].has_columns) continue;
    row.push_back(state.springs[s].force());
    row.push_back(state.springs[s].elongation);
  }
}

}  // namespace percuss
