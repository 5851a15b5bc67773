// Results of an Exodus II file: variables of elements and nodes at a time step.

#include <exodusII.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/error.hpp"
#include "src/mesh/formats/exodus/exodus_file.hpp"

namespace percuss {
namespace {

/// Share of a time within which a step has it.
constexpr double same_time = 1e-6;
constexpr int longest_variable_name = 256;  // netCDF's own limit
constexpr std::int64_t least_value_bytes = 4;

void check_results(int code, const std::string& what) {
  if (code < 0)
    throw InputError(
        fmt::format("{} cannot be read (the file is damaged or not one of Exodus II; code {})", what, code));
}

std::size_t count_of(std::int64_t count) { return static_cast<std::size_t>(count); }

}  // namespace

/// Throws where the file ends before its last time step.
void ExodusFile::require_time_steps() const {
  if (container_.records_end > static_cast<double>(container_.bytes))
    throw InputError(fmt::format("the file is truncated (it has {} bytes, its time steps need {:.0f}): copy it again",
                                 container_.bytes, container_.records_end));
}

std::vector<double> ExodusFile::read_times() const {
  const std::int64_t count = std::max<std::int64_t>(ex_inquire_int(file_, EX_INQ_TIME), 0);
  require_room(count, least_value_bytes, "time steps");
  std::vector<double> times(count_of(count));
  if (count > 0) check_results(ex_get_all_times(file_, times.data()), "the list of times");
  return times;
}

/// Number of the time step, from 1.
int ExodusFile::find_time_step(const ResultsWish& wish) const {
  const std::vector<double> times = read_times();
  const std::size_t count = times.size();
  if (count < 1) throw InputError("the file has no time steps (it is a mesh without results)");
  if (!wish.time) return static_cast<int>(count);
  const auto nearest = std::min_element(times.begin(), times.end(), [&](double a, double b) {
    return std::abs(a - *wish.time) < std::abs(b - *wish.time);
  });
  if (!(std::abs(*nearest - *wish.time) <= same_time * std::max(std::abs(*wish.time), std::abs(times.back()))))
    throw InputError(fmt::format("there is no step at the time {:g} (the nearest of its {} steps is at {:g})",
                                 *wish.time, count, *nearest));
  return static_cast<int>(nearest - times.begin()) + 1;
}

std::vector<std::string> ExodusFile::read_variable_names(int kind) const {
  const auto of = static_cast<ex_entity_type>(kind);
  int count = 0;
  check_results(ex_get_variable_param(file_, of, &count), "the count of variables");
  require_room(count, 1, "variables");
  check_results(ex_set_max_name_length(file_, longest_variable_name), "the names of variables");
  std::vector<std::string> names(count_of(count), std::string(longest_variable_name + 2, '\0'));
  std::vector<char*> pointers;
  pointers.reserve(names.size());
  for (std::string& name : names) pointers.push_back(name.data());
  if (count > 0) check_results(ex_get_variable_names(file_, of, count, pointers.data()), "the names of variables");
  for (std::string& name : names) {
    name.resize(std::char_traits<char>::length(name.c_str()));
    name.erase(name.find_last_not_of(' ') + 1);
  }
  return names;
}

/// variable: from 1.
ResultsColumn ExodusFile::read_element_variable(int step, int variable, const std::string& name) const {
  ResultsColumn column{std::vector<double>(count_of(elements_), std::numeric_limits<double>::quiet_NaN()), {}};
  int count = 0;
  check_results(ex_get_variable_param(file_, EX_ELEM_BLOCK, &count), "the count of variables");
  for (const FileBlock& block : blocks_) {
    column.is_lacking.push_back(1);
    if (block.elements == 0) continue;
    std::vector<int> table(count_of(count), 0);
    check_results(ex_get_object_truth_vector(file_, EX_ELEM_BLOCK, block.id, count, table.data()),
                  "the truth table of its variables");
    if (table[count_of(variable - 1)] == 0) continue;
    column.is_lacking.back() = 0;
    check_results(ex_get_var(file_, step, EX_ELEM_BLOCK, variable, block.id, block.elements,
                             column.values.data() + (block.first_element - 1)),
                  fmt::format("variable '{}' of block '{}'", name, block.name));
  }
  return column;
}

ResultsContents ExodusFile::read_results_contents() const {
  require_time_steps();
  return {read_times(), read_variable_names(EX_ELEM_BLOCK), read_variable_names(EX_NODAL)};
}

FileResults ExodusFile::read_results(const ResultsWish& wish) const {
  require_time_steps();
  const int step = find_time_step(wish);
  FileResults results;
  results.blocks = blocks_;
  for (const FileBlock& block : blocks_) results.corners.push_back(read_connectivity(block));
  results.element_ids = read_element_ids();
  results.node_ids = read_node_ids();
  results.element_names = read_variable_names(EX_ELEM_BLOCK);
  results.node_names = read_variable_names(EX_NODAL);
  const auto find = [](const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
  };
  for (const std::string& name : wish.of_elements) {
    if (const int variable = find(results.element_names, name); variable > 0)
      results.of_elements.emplace(name, read_element_variable(step, variable, name));
  }
  for (const std::string& name : wish.of_nodes) {
    const int variable = find(results.node_names, name);
    if (variable == 0) continue;
    std::vector<double> values(count_of(nodes_));
    if (nodes_ > 0)
      check_results(ex_get_var(file_, step, EX_NODAL, variable, 1, nodes_, values.data()),
                    fmt::format("variable '{}' of nodes", name));
    results.of_nodes.emplace(name, ResultsColumn{std::move(values), {}});
  }
  return results;
}

}  // namespace percuss
