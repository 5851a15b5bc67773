#pragma once
// What welds with a radius hold: of the faces of each end those around the weld, and how far their nodes share in it.
//
// A disc of the radius lies around the point of a face nearest to the weld, across its normal. Points spread evenly
// over the disc are projected onto the faces along the normal. What a node has of the region is the mean of its shape
// function over these points: so the region is the disc itself, whatever the size of the elements.

#include <array>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/spring_model.hpp"

namespace percuss {

/// A weld with a radius: a point, and the faces of its ends.
struct WeldSpot {
  Vec3 at{};
  double radius = 0;
  std::array<std::size_t, 2> faces{};  // of find_weld_regions()
};

/// One end of it.
struct WeldRegion {
  double distance = 0;              // from the weld to the nearest face; endless: there is none
  Vec3 nearest{}, normal{};         // the point of it, and its normal there
  double covered = 0;               // share of the disc that has faces
  std::vector<std::int64_t> nodes;  // by number in the whole mesh, ascending
  std::vector<double> weights;      // [nodes]
  std::vector<ShapeProduct> products;
};

/// [spots] both ends; the same on all ranks. faces: by WeldSpot::faces, those of this rank. Without nodes are ends
/// farther from the faces than `reach` radii. Collective.
std::vector<std::array<WeldRegion, 2>> find_weld_regions(const ChunkedMesh& chunked, const std::vector<WeldSpot>& spots,
                                                         const std::vector<std::vector<ElementFace>>& faces,
                                                         double reach);

}  // namespace percuss
