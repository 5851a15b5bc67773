#pragma once
// Glue: cohesive ties, node by node. Every rank has all of it, and the same bits.

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/contact/geometry/cohesive_law.hpp"
#include "kernels/contact/geometry/tie_geometry.hpp"
#include "src/step/model/spring_model.hpp"

namespace percuss {

/// A node of side a and the face of side b that it is glued to; const after set-up.
struct GluePoint {
  std::int64_t number = -1;   // of the node in the whole mesh
  int tie = 0;                // of the deck
  std::array<int, 5> node{};  // places in GlueModel::nodes: the node, the corners of the face
  TieGeometry geometry;       // of the glue itself, not of its node
  Point3 arm{};               // from the node to the glue at the start, through its own shell
  int side = 1;               // on which the node lies of the face
  double area = 0;            // of side a that it holds
};

struct GlueModel : ForcedNodes {
  std::vector<CohesiveLaw> laws;  // by tie of the deck; of rigid ties unused
  std::vector<GluePoint> points;  // by ascending number

  bool any() const { return !points.empty(); }
};

}  // namespace percuss
