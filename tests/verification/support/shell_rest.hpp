#pragma once
// Static answers from an explicit code: nodal loads grow over a ramp, and the scene comes to rest by kinetic damping,
// which stops all motion whenever the kinetic energy has passed a peak (Cundall 1976).

#include <string>
#include <vector>

#include "tests/src/step/scene.hpp"

namespace percuss::test {

/// A force on the node with the user's id.
struct NodeLoad {
  std::int64_t node_id = 0;
  Vec3 force{};
};

struct RestOptions {
  int ramp = 200;           // steps over which the loads grow
  int peaks = 60;           // of the kinetic energy, at most
  int steps = 200000;       // at most
  double tolerance = 1e-5;  // change of the watched displacement from peak to peak, at which to stop
};

/// A deck of one mesh of elastic shells at two points, of density 1. file: the mesh; conditions: the list of the deck.
std::string make_static_deck(const std::string& file, double young, double poisson, double thickness,
                             const std::string& conditions);

/// Loads the scene and brings it to rest; returns the displacement of the node with the id `watched`.
Vec3 bring_to_rest(Scene& scene, const std::vector<NodeLoad>& loads, std::int64_t watched, const RestOptions& options);

}  // namespace percuss::test
