#pragma once
// Exodus II files whose netCDF variables stand in another order, as other writers leave them.

#include <string>
#include <vector>

namespace percuss::testing_mesh {

/// Names of the variables of a file in their order.
std::vector<std::string> list_variables(const std::string& path);

/// Copies a file to `path`, in the same container, with one variable before all others. Returns `path`.
std::string copy_with_first(const std::string& from, const std::string& variable, const std::string& path);

}  // namespace percuss::testing_mesh
