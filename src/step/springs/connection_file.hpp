#pragma once
// Spot welds of a master connection file (xMCF): version 3.0 of FAT-Schriftenreihe 286, 3.1 of ISO/PAS 8329.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/step/springs/weld_points.hpp"

namespace percuss {

/// Connections between the same parts.
struct ConnectionGroup {
  std::vector<std::vector<std::string>> parts;  // of each part, or sheet of an assembly: its label, name and number
  std::vector<WeldPoint> spots;                 // in the unit of the file
  std::map<std::string, int> others;            // how many of each other kind: "rivet", "seamweld" ...
};

struct ConnectionFile {
  double length_in_si = 1e-3;  // metres in its unit of length
  std::vector<ConnectionGroup> groups;
};

/// Whether a text is XML.
bool is_connection_file(std::string_view text);

/// Throws InputError with file and line: what is no such file, a weld without a place, more than `most` welds.
ConnectionFile parse_connections(std::string_view text, const std::string& path, std::size_t most);

}  // namespace percuss
