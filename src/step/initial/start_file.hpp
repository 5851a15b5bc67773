#pragma once
// A table of the state of elements or the velocities of nodes at time 0: comma-separated values with the user's ids.
//
//   element[,layer][,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx][,equivalent_plastic_strain][,temperature]
//   node,velocity_x,velocity_y,velocity_z

#include <cstdint>
#include <string>
#include <vector>

namespace percuss {

/// Content of a file, row by row.
struct StartTable {
  static constexpr int absent = -1;
  bool is_of_nodes = false;
  bool has_layers = false;
  bool is_of_mesh = false;  // of a mesh file, whose rows of zeros say nothing of what cannot have them
  int columns = 0;          // of `values`
  int stress = absent, plastic_strain = absent, temperature = absent;  // their first columns
  std::vector<std::int64_t> ids;                                       // ascending
  std::vector<std::int64_t>
      layers;                  // [ids] of a shell from 1, the lowest; ascending in an element; 0: the whole element
  std::vector<int> lines;      // [ids] of the file; 0: none
  std::vector<double> values;  // [ids][columns]

  const double* row(int i) const { return values.data() + static_cast<std::ptrdiff_t>(i) * columns; }
};

/// The whole text of a file. Throws InputError for what is no regular file or has 2 GiB and more, SystemError.
std::string read_start_file(const std::string& path);

/// A byte order mark is skipped. Throws InputError with file and line: another heading, a row that is short or long,
/// what is no number, an id or a layer of it twice.
StartTable parse_start_table(const std::string& text, const std::string& path);

}  // namespace percuss
