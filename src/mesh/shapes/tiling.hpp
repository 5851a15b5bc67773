#pragma once
// Cuts generated parts into chunks by index alone: any chunk can be listed without looking at the others, so the chunks
// do not depend on how many ranks make them.

#include <array>
#include <cstdint>
#include <vector>

#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {

/// A block of cells cut into boxes of near-equal sizes.
struct BlockTiles {
  CellBlock block;
  std::array<int, 3> counts{1, 1, 1};  // of tiles in each direction

  int count() const { return counts[0] * counts[1] * counts[2]; }
};

/// Chooses how many tiles a block is cut into in each direction: the cheapest of all cuts into tiles of at most
/// `limit` cells. A cut costs the lanes of its packs of 8 and the copies that its chunks have of their
/// nodes; among near-equal ones the tiles with the least surface win.
BlockTiles choose_tiles(const CellBlock& block, int limit);

/// An element of a part: which of the copies that an array makes, and which element of the shape.
struct SourceElement {
  int copy = 0;
  int element = 0;
  friend bool operator==(const SourceElement&, const SourceElement&) = default;
};

/// The chunks of a generated part, in the order of their numbers: copy after copy, block after block, tile after tile.
/// Shapes of at most find_chunk_limit() elements are chunks of their own, those of at most half as many share one with
/// the next copies.
class PartTiling {
 public:
  PartTiling(const ShapeSource& source, int copies);

  int chunk_count() const;

  /// Number of elements of a chunk.
  int count_elements(int chunk) const;

  /// Elements of a chunk, in the order in which they are numbered.
  std::vector<SourceElement> list_elements(int chunk) const;

 private:
  struct Run {
    int first = 0, last = 0;
  };
  Run find_copies(int chunk) const;
  Run cut_evenly(int cells, int tiles, int tile) const;
  std::array<Run, 3> find_tile(int tile, const CellBlock*& block) const;

  int copies_, elements_;          // of the part, of a copy
  int shared_chunks_ = 0;          // chunks of whole copies; 0: copies are cut into tiles
  std::vector<BlockTiles> tiles_;  // of a copy
  int tiles_a_copy_ = 0;
};

}  // namespace percuss
