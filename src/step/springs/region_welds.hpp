#pragma once
// Welds with a radius, from the deck to the regions that they hold.

#include <array>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/step/springs/weld_regions.hpp"

namespace percuss {

struct RegionWelds {
  std::vector<std::vector<std::array<WeldRegion, 2>>> of_entry;  // [welds of the deck][points]; none without a radius
  std::vector<Warning> warnings;                                 // of points far from the faces, or at their rim
};

/// Collective. Throws InputError with the deck's place, the same on all ranks: points that are out of reach of the
/// faces, ends that share nodes.
RegionWelds find_region_welds(const Deck& deck, const ChunkedMesh& chunked);

}  // namespace percuss
