#pragma once
// Values that a mesh file has of its elements and nodes, as a run left them there: variables of Exodus II, arrays of
// VTK.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

/// Results to read from a file, by names of components.
struct ResultsWish {
  std::vector<std::string> of_elements, of_nodes;
  std::optional<double> time;  // the step nearest to it; none: the last
};

/// The values of a component; NaN where a block does not have it, if `lacking` says so.
struct ResultsColumn {
  std::vector<double> values;    // [elements or nodes of the file]
  std::vector<char> is_lacking;  // [blocks] whether a block does not have it; of nodes empty
};

struct FileResults {
  std::vector<FileBlock> blocks;
  std::vector<std::vector<std::int64_t>> corners;  // [blocks] nodes of the elements, from 1
  std::vector<std::int64_t> element_ids, node_ids;
  std::map<std::string, ResultsColumn> of_elements, of_nodes;  // requested columns that the file has
  std::vector<std::string> element_names, node_names;          // all that it has
};

/// Results that a file has, without the values.
struct ResultsContents {
  std::vector<double> times;                           // of its steps; empty: the format has none, or the file
  std::vector<std::string> element_names, node_names;  // of components
};

/// Names of the components of an array: itself, or with _x, _y, _z, or _xx, _yy, _zz, _xy, _yz, _zx; empty: of another
/// number of components.
std::vector<std::string> name_result_components(const std::string& array, std::int64_t components);

}  // namespace percuss
