#pragma once
// A quarter of a ball whose mesh is fine where it will touch, as an Exodus mesh.

#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::test {

/// The quarter x >= 0, y >= 0 of a ball about the origin, `across` (even) cells on its diameter, drawn together towards
/// its lowest point by a Moebius map of the ball onto itself: conformal, so that elements keep their shape, and smaller
/// by (1 - grading) / (1 + grading) there. One block, "ball".
testing_mesh::WrittenMesh make_graded_quarter_ball(double radius, int across, double grading);

}  // namespace percuss::test
