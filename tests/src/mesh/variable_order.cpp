#include "tests/src/mesh/variable_order.hpp"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace percuss::testing_mesh {
namespace {

void check(int code) {
  if (code != NC_NOERR) throw std::runtime_error(std::string("the test cannot copy its file: ") + nc_strerror(code));
}

int find_mode(int file) {
  int format = 0;
  check(nc_inq_format(file, &format));
  constexpr std::array<int, 6> modes{0, 0, NC_64BIT_OFFSET, NC_NETCDF4, NC_NETCDF4 | NC_CLASSIC_MODEL, NC_64BIT_DATA};
  return modes.at(static_cast<std::size_t>(format)) | NC_CLOBBER;
}

std::vector<std::string> list_variables(int file) {
  int count = 0;
  check(nc_inq_nvars(file, &count));
  std::vector<std::string> names;
  for (int v = 0; v < count; ++v) {
    std::array<char, NC_MAX_NAME + 1> name{};
    check(nc_inq_varname(file, v, name.data()));
    names.emplace_back(name.data());
  }
  return names;
}

void copy_dimensions(int in, int out) {
  int count = 0, unlimited = -1;
  check(nc_inq_ndims(in, &count));
  check(nc_inq_unlimdim(in, &unlimited));
  for (int d = 0; d < count; ++d) {
    std::array<char, NC_MAX_NAME + 1> name{};
    std::size_t length = 0;
    check(nc_inq_dim(in, d, name.data(), &length));
    int copy = 0;
    check(nc_def_dim(out, name.data(), d == unlimited ? NC_UNLIMITED : length, &copy));
  }
}

void copy_attributes(int in, int from, int out, int to) {
  int count = 0;
  if (from == NC_GLOBAL)
    check(nc_inq_natts(in, &count));
  else
    check(nc_inq_varnatts(in, from, &count));
  for (int a = 0; a < count; ++a) {
    std::array<char, NC_MAX_NAME + 1> name{};
    check(nc_inq_attname(in, from, a, name.data()));
    check(nc_copy_att(in, from, name.data(), out, to));
  }
}

struct Variable {
  int from = 0, to = 0;
  std::size_t bytes = 0;
};

Variable define_copy(int in, const std::string& name, int out) {
  Variable copy;
  check(nc_inq_varid(in, name.c_str(), &copy.from));
  nc_type type = 0;
  int rank = 0;
  std::array<int, NC_MAX_VAR_DIMS> dimensions{};
  check(nc_inq_var(in, copy.from, nullptr, &type, &rank, dimensions.data(), nullptr));
  check(nc_inq_type(in, type, nullptr, &copy.bytes));
  for (int d = 0; d < rank; ++d) {
    std::size_t length = 0;
    check(nc_inq_dimlen(in, dimensions[static_cast<std::size_t>(d)], &length));
    copy.bytes *= length;
  }
  check(nc_def_var(out, name.c_str(), type, rank, dimensions.data(), &copy.to));
  copy_attributes(in, copy.from, out, copy.to);
  return copy;
}

}  // namespace

std::vector<std::string> list_variables(const std::string& path) {
  int file = 0;
  check(nc_open(path.c_str(), NC_NOWRITE, &file));
  std::vector<std::string> names = list_variables(file);
  check(nc_close(file));
  return names;
}

std::string copy_with_first(const std::string& from, const std::string& variable, const std::string& path) {
  int in = 0, out = 0;
  check(nc_open(from.c_str(), NC_NOWRITE, &in));
  check(nc_create(path.c_str(), find_mode(in), &out));
  copy_dimensions(in, out);
  copy_attributes(in, NC_GLOBAL, out, NC_GLOBAL);
  std::vector<std::string> order = list_variables(in);
  std::stable_partition(order.begin(), order.end(), [&](const std::string& name) { return name == variable; });
  std::vector<Variable> copies;
  for (const std::string& name : order) copies.push_back(define_copy(in, name, out));
  check(nc_enddef(out));
  for (const Variable& copy : copies) {
    std::vector<char> values(copy.bytes);
    if (values.empty()) continue;
    check(nc_get_var(in, copy.from, values.data()));
    check(nc_put_var(out, copy.to, values.data()));
  }
  check(nc_close(in));
  check(nc_close(out));
  return path;
}

}  // namespace percuss::testing_mesh
