#include "src/mesh/formats/exodus/exodus_coordinates.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <string>

#include "src/error.hpp"

namespace percuss {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw InputError(
      fmt::format("the node coordinates cannot be read (the file is damaged or not one of Exodus II; {})", reason));
}

void check(int code) {
  if (code != NC_NOERR) refuse(fmt::format("its library says '{}'", nc_strerror(code)));
}

/// Lengths of a variable's dimensions.
std::vector<std::size_t> read_shape(int file, int variable) {
  int count = 0;
  check(nc_inq_varndims(file, variable, &count));
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  if (count > 0) check(nc_inq_vardimid(file, variable, dimensions.data()));
  std::vector<std::size_t> shape;
  for (const int dimension : dimensions) check(nc_inq_dimlen(file, dimension, &shape.emplace_back()));
  return shape;
}

/// Values of a direction: of the variable of its own, or of its row in the variable of all.
std::vector<double> read_direction(int file, int direction, std::size_t nodes) {
  constexpr std::array<const char*, 3> names{"coordx", "coordy", "coordz"};
  const auto row = static_cast<std::size_t>(direction);
  int variable = 0;
  int code = nc_inq_varid(file, names[row], &variable);
  const bool is_of_all = code == NC_ENOTVAR;
  if (is_of_all) code = nc_inq_varid(file, "coord", &variable);
  if (code == NC_ENOTVAR) refuse(fmt::format("it has neither '{}' nor 'coord'", names[row]));
  check(code);
  const std::vector<std::size_t> shape = read_shape(file, variable);
  const bool fits =
      is_of_all ? shape.size() == 2 && shape[0] > row && shape[1] == nodes : shape.size() == 1 && shape[0] == nodes;
  if (!fits)
    refuse(fmt::format("'{}' has not one value for each of {} nodes", is_of_all ? "coord" : names[row], nodes));
  const std::array<std::size_t, 2> start{is_of_all ? row : 0, 0}, count{is_of_all ? 1 : nodes, nodes};
  std::vector<double> values(nodes);
  check(nc_get_vara_double(file, variable, start.data(), count.data(), values.data()));
  return values;
}

}  // namespace

std::vector<Vec3> read_exodus_coordinates(int file, int dimensions, std::int64_t nodes) {
  std::vector<Vec3> places(static_cast<std::size_t>(nodes));
  for (int d = 0; d < dimensions && !places.empty(); ++d) {
    const std::vector<double> values = read_direction(file, d, places.size());
    for (std::size_t n = 0; n < places.size(); ++n) places[n][static_cast<std::size_t>(d)] = values[n];
  }
  return places;
}

}  // namespace percuss
