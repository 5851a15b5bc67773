#pragma once
// A table of stresses of elements or velocities of nodes at time 0: comma-separated values with the user's ids.
//
//   element,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx[,equivalent_plastic_strain]
//   node,velocity_x,velocity_y,velocity_z

#include <cstdint>
#include <string>
#include <vector>

namespace percuss {

/// What a file has, row by row.
struct StartTable {
  bool is_of_nodes = false;
  bool has_plastic_strain = false;
  std::vector<std::int64_t> ids;  // ascending
  std::vector<int> lines;         // [ids] of the file
  std::vector<double> values;     // [ids][columns()]
  int columns() const { return is_of_nodes ? 3 : has_plastic_strain ? 7 : 6; }
};

/// The whole text of a file. Throws InputError for what is no regular file or has 2 GiB and more, SystemError.
std::string read_start_file(const std::string& path);

/// A byte order mark is skipped. Throws InputError with file and line: another heading, a row that is short or long,
/// what is no number, an id twice.
StartTable parse_start_table(const std::string& text, const std::string& path);

}  // namespace percuss
