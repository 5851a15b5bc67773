#pragma once
// How large the faces are that a tie joins.

#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Root of the mean area of the faces of one tie's sides where they lie on each other [length]; 0: a side has none.
struct TieSizes {
  double a = 0;  // faces all of whose nodes are tied
  double b = 0;  // faces whose middle is in the box of the tied nodes
};

/// [ties] The same on all ranks. Collective.
std::vector<TieSizes> find_tie_sizes(const ChunkedMesh& chunked, const TiedSurfaces& ties, const Communicator& ranks);

}  // namespace percuss
