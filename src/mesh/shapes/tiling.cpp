#include "src/mesh/shapes/tiling.hpp"

#include <algorithm>
#include <cstddef>

#include "src/mesh/ordering.hpp"

namespace percuss {
namespace {

/// A pack of 8 lanes costs the same however many of them are used.
constexpr int pack_lanes = 8;

/// Cost of a chunk's copy of a node (gathered, scattered, summed, exchanged), as a share of an element.
constexpr double copy_cost = 0.1;

/// How much the shape counts beside that: tiles of twice the least surface cost so much more.
constexpr double surface_cost = 0.02;

int divide_up(int a, int b) { return (a + b - 1) / b; }

/// Tiles of one direction: `larger` of them have one cell more than the others.
struct Cut {
  int tiles = 1;
  int cells = 1;  // of the others
  int larger = 0;
};

/// All cuts of a direction into tiles of different sizes, at most `limit` cells long.
std::vector<Cut> list_cuts(int cells, int limit) {
  std::vector<Cut> cuts;
  for (int size = 1; size <= std::min(cells, limit); ++size) {
    const int tiles = divide_up(cells, size);
    if (!cuts.empty() && cuts.back().tiles == tiles) continue;
    cuts.push_back({tiles, cells / tiles, cells % tiles});
  }
  return cuts;
}

int find_largest(const Cut& cut) { return cut.cells + (cut.larger > 0 ? 1 : 0); }

/// Calls visit(sizes, count) for the up to eight kinds of tiles that three cuts make.
template <class Visit>
void for_each_kind(const std::array<Cut, 3>& cuts, const Visit& visit) {
  for (unsigned kind = 0; kind < 8; ++kind) {
    std::array<int, 3> sizes{};
    double count = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      const bool larger = (kind >> d & 1) != 0;
      sizes[d] = cuts[d].cells + (larger ? 1 : 0);
      count *= larger ? cuts[d].larger : cuts[d].tiles - cuts[d].larger;
    }
    if (count > 0) visit(sizes, count);
  }
}

double find_surface(const std::array<int, 3>& sizes, const Vec3& edges) {
  const double x = sizes[0] * edges[0], y = sizes[1] * edges[1], z = sizes[2] * edges[2];
  return 2 * (x * y + y * z + z * x);
}

/// Cost of all tiles in elements, and their surface.
struct TilesCost {
  double work = 0, surface = 0;
};
TilesCost find_cost(const std::array<Cut, 3>& cuts, const Vec3& edges) {
  TilesCost cost;
  for_each_kind(cuts, [&](const std::array<int, 3>& sizes, double count) {
    const int cells = sizes[0] * sizes[1] * sizes[2];
    const int nodes = (sizes[0] + 1) * (sizes[1] + 1) * (sizes[2] + 1);
    cost.work += count * (divide_up(cells, pack_lanes) * pack_lanes + copy_cost * nodes);
    cost.surface += count * find_surface(sizes, edges);
  });
  return cost;
}

struct TilingCandidate {
  std::array<Cut, 3> cuts;
  TilesCost cost;
};

std::vector<TilingCandidate> list_candidates(const CellBlock& block, int limit) {
  std::vector<TilingCandidate> candidates;
  for (const Cut& x : list_cuts(block.cells[0], limit)) {
    for (const Cut& y : list_cuts(block.cells[1], limit)) {
      if (find_largest(x) * find_largest(y) > limit) continue;
      for (const Cut& z : list_cuts(block.cells[2], limit)) {
        if (find_largest(x) * find_largest(y) * find_largest(z) > limit) continue;
        candidates.push_back({{x, y, z}, find_cost({x, y, z}, block.edges)});
      }
    }
  }
  return candidates;
}

}  // namespace

BlockTiles choose_tiles(const CellBlock& block, int limit) {
  const std::vector<TilingCandidate> candidates = list_candidates(block, limit);
  double least_surface = candidates.front().cost.surface;
  for (const TilingCandidate& c : candidates) least_surface = std::min(least_surface, c.cost.surface);
  const auto rate = [&](const TilingCandidate& c) {
    return c.cost.work * (1 + surface_cost * (c.cost.surface / least_surface - 1));
  };
  const TilingCandidate* best = &candidates.front();
  for (const TilingCandidate& c : candidates) {
    if (rate(c) < rate(*best)) best = &c;
  }
  return {block, {best->cuts[0].tiles, best->cuts[1].tiles, best->cuts[2].tiles}};
}

PartTiling::PartTiling(const ShapeSource& source, int copies) : copies_(copies), elements_(source.element_count()) {
  const int limit = find_chunk_limit(std::int64_t{copies} * elements_);
  if (elements_ <= limit) {
    shared_chunks_ = divide_up(copies, limit / elements_);
    return;
  }
  for (const CellBlock& block : source.blocks()) {
    tiles_.push_back(choose_tiles(block, std::max(1, limit / block.elements_of_cell)));
    tiles_a_copy_ += tiles_.back().count();
  }
}

int PartTiling::chunk_count() const { return shared_chunks_ > 0 ? shared_chunks_ : copies_ * tiles_a_copy_; }

PartTiling::Run PartTiling::cut_evenly(int cells, int tiles, int tile) const {
  const auto cut = [&](int t) { return static_cast<int>(std::int64_t{cells} * t / tiles); };
  return {cut(tile), cut(tile + 1)};
}

PartTiling::Run PartTiling::find_copies(int chunk) const { return cut_evenly(copies_, shared_chunks_, chunk); }

std::array<PartTiling::Run, 3> PartTiling::find_tile(int tile, const CellBlock*& block) const {
  auto tiles = tiles_.begin();
  for (; tile >= tiles->count(); ++tiles) tile -= tiles->count();
  block = &tiles->block;
  const auto [x, y, z] = tiles->counts;
  const std::array<int, 3> place{tile % x, tile / x % y, tile / x / y};
  std::array<Run, 3> runs;
  for (std::size_t d = 0; d < 3; ++d) runs[d] = cut_evenly(block->cells[d], tiles->counts[d], place[d]);
  return runs;
}

int PartTiling::count_elements(int chunk) const {
  if (shared_chunks_ > 0) {
    const Run copies = find_copies(chunk);
    return (copies.last - copies.first) * elements_;
  }
  const CellBlock* block = nullptr;
  const auto [x, y, z] = find_tile(chunk % tiles_a_copy_, block);
  return (x.last - x.first) * (y.last - y.first) * (z.last - z.first) * block->elements_of_cell;
}

std::vector<SourceElement> PartTiling::list_elements(int chunk) const {
  std::vector<SourceElement> elements;
  elements.reserve(static_cast<std::size_t>(count_elements(chunk)));
  if (shared_chunks_ > 0) {
    const Run copies = find_copies(chunk);
    for (int copy = copies.first; copy < copies.last; ++copy) {
      for (int e = 0; e < elements_; ++e) elements.push_back({copy, e});
    }
    return elements;
  }
  const CellBlock* block = nullptr;
  const auto [x, y, z] = find_tile(chunk % tiles_a_copy_, block);
  const int copy = chunk / tiles_a_copy_;
  for (int k = z.first; k < z.last; ++k) {
    for (int j = y.first; j < y.last; ++j) {
      for (int i = x.first; i < x.last; ++i) {
        const int cell = block->first + i * block->strides[0] + j * block->strides[1] + k * block->strides[2];
        for (int e = 0; e < block->elements_of_cell; ++e)
          elements.push_back({copy, block->elements_of_cell * cell + e});
      }
    }
  }
  return elements;
}

}  // namespace percuss
