#pragma once
// Tied surfaces that lie on each other: what belongs to a tie is no overlap.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/contact/surface/tied_surfaces.hpp"

namespace percuss {

/// Nodes, faces and edges at ties: the tied nodes, the corners of the faces that hold them, and faces and edges with
/// one of these. Numbers of all ranks, ascending.
struct FlushTies {
  struct Item {
    std::int64_t number;
    int tie;
    auto operator<=>(const Item&) const = default;
  };
  std::vector<Item> nodes, faces, edges;

  /// Whether a node and a face, or two edges, are at one tie.
  bool has_face(std::int64_t node, std::int64_t face) const { return has_common(nodes, node, faces, face); }
  bool has_edges(std::int64_t a, std::int64_t b) const { return has_common(edges, a, edges, b); }

 private:
  static bool has_common(const std::vector<Item>& of_a, std::int64_t a, const std::vector<Item>& of_b, std::int64_t b);
};

/// Collective.
FlushTies find_flush_ties(const Communicator& ranks, const SurfaceShare& share, const TiedSurfaces& ties);

/// The smallest gap of each two parts that a tie holds together, between surfaces at half thickness; 0 where these
/// overlap. By (part, other), the same on all ranks. Collective.
std::vector<PartGap> find_tied_gaps(const Communicator& ranks, const SurfaceShare& share, const TiedSurfaces& ties);

}  // namespace percuss
