#include "tests/verification/support/graded_ball.hpp"

#include <cmath>
#include <span>

#include "src/deck/reading/read_deck.hpp"

namespace percuss::test {

namespace {

/// The Moebius map of the unit ball onto itself that takes (0, 0, s) to the middle.
Vec3 draw_together(const Vec3& x, double s) {
  const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const double to_center = x[0] * x[0] + x[1] * x[1] + (x[2] - s) * (x[2] - s);
  const double scale = 1 / (1 - 2 * s * x[2] + s * s * square);
  return {scale * (1 - s * s) * x[0], scale * (1 - s * s) * x[1], scale * ((1 - s * s) * (x[2] - s) - s * to_center)};
}

}  // namespace

testing_mesh::WrittenMesh make_graded_quarter_ball(double radius, int across, double grading) {
  Deck deck;
  PartDeck part;
  part.name = "ball";
  part.shape = SphereShape{1.0, across};
  part.material = "any";
  deck.parts.push_back(part);
  deck.materials.push_back({"any", 1, {}, {}, {}, {}, {}});
  const Mesh ball = build_mesh(deck);

  testing_mesh::WrittenMesh quarter;
  testing_mesh::WrittenBlock block;
  block.name = "ball";
  std::vector<std::int64_t> new_number(ball.nodes.size(), 0);
  for (std::size_t e = 0; e < ball.elements.size(); ++e) {
    const std::span<const int> corners = ball.corners(e);
    double center[2] = {0, 0};
    for (const int n : corners) {
      for (std::size_t k = 0; k < 2; ++k) center[k] += ball.nodes[static_cast<std::size_t>(n)][k];
    }
    if (center[0] < 0 || center[1] < 0) continue;
    for (const int n : corners) {
      std::int64_t& number = new_number[static_cast<std::size_t>(n)];
      if (number == 0) {
        Vec3 x = draw_together(ball.nodes[static_cast<std::size_t>(n)], grading);
        for (std::size_t k = 0; k < 3; ++k) x[k] = std::abs(x[k]) < 1e-12 ? 0 : radius * x[k];
        quarter.nodes.push_back(x);
        number = static_cast<std::int64_t>(quarter.nodes.size());
      }
      block.corners.push_back(number);
    }
  }
  quarter.blocks.push_back(block);
  return quarter;
}

}  // namespace percuss::test
