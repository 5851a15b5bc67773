#include "src/step/forces/wall_motions.hpp"

#include <fmt/format.h>

namespace percuss {

std::vector<HistoryColumn> WallMotions::list_columns() const {
  std::vector<HistoryColumn> columns;
  for (const std::string& name : name_moving_walls(deck_)) {
    columns.push_back({"wall_displacement:" + name, dimensions::length,
                       fmt::format("displacement of wall '{}', along its normal or direction", name)});
    columns.push_back({"wall_speed:" + name, dimensions::velocity,
                       fmt::format("speed of wall '{}', along its normal or direction", name)});
  }
  return columns;
}

void WallMotions::append_values(const State& /*state*/, std::vector<double>& row) {
  const std::vector<double> motions = contact_.list_wall_motions();
  row.insert(row.end(), motions.begin(), motions.end());
}

}  // namespace percuss
