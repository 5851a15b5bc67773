#pragma once
// Places and diameters of welds from a table: comma-separated x, y, z and perhaps a diameter, one weld a line; or from
// a master connection file.

#include <string>
#include <vector>

#include "src/step/springs/weld_regions.hpp"

namespace percuss {

/// A weld of a table.
struct WeldPoint {
  Vec3 at{};
  double radius = 0;  // 0: the table gives none [length]
  int line = 0;       // of the table; 0: the deck gives the place
};

/// A byte order mark, empty lines and lines that begin with # are skipped; the first line may be a heading. Throws
/// InputError with file and line: rows of another length, what is no number, more than `most` rows, none.
std::vector<WeldPoint> parse_weld_points(const std::string& text, const std::string& path, std::size_t most);

struct WeldPoints {
  std::vector<WeldPoint> points;
  std::string left_out;  // connections of the file that are no spot welds; empty: none
};

/// The points of a weld of the deck, the same on all ranks. Rank 0 reads. Collective.
WeldPoints list_weld_points(const Deck& deck, const Communicator& ranks, const WeldDeck& weld);

}  // namespace percuss
