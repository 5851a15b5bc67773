#pragma once
// How the corners of elements are named in a mirror image, so that these stay right-handed and shells keep the mirror
// images of their normals.

#include <algorithm>
#include <array>
#include <memory>

#include "src/deck/deck.hpp"
#include "src/mesh/shapes/shape_source.hpp"
#include "src/mesh/topology/topology.hpp"

namespace percuss {

/// Whether an odd number of reflections acts on the part.
inline bool is_mirrored(const PartDeck& part) {
  return std::count_if(part.images.begin(), part.images.end(),
                       [](const PartImage& image) { return image.kind == PartImage::Kind::mirror; }) %
             2 !=
         0;
}

/// Places among the corners and faces of an element in the order before the mirror: corner[new] is the old one, and
/// face[old] the new one.
struct MirroredOrder {
  std::array<int, most_corners> corner{};
  std::array<int, most_faces> face{};
};

MirroredOrder find_mirrored_order(const Topology& topology);

/// A shape whose elements are ordered as those of its mirror image.
std::unique_ptr<ShapeSource> mirror_corners(std::unique_ptr<ShapeSource> source);

}  // namespace percuss
