#pragma once
// Forces at n on rigid bodies: of loads, and of elements that share nodes with them.

#include <vector>

#include "src/step/model/state.hpp"

namespace percuss {

/// Force and moment of a load on its body at n.
struct PointForce {
  Vector3<double> arm{};              // of the point, from the centre
  Vector3<double> force{}, moment{};  // the latter without that of the force about the centre
};

/// time: of the load, while `body` stands as it does then.
PointForce find_point_force(const Model& model, const BodyLoad& load, const State& state, const RigidState& body,
                            double time);

/// Its power on a body that moves so.
inline double find_power(const PointForce& on, const RigidState& motion) {
  return dot(on.force, motion.velocity) + dot(on.moment + cross(on.arm, on.force), motion.spin);
}

/// Holds the memory of the sums.
class RigidForces {
 public:
  /// Force and moment about its centre of each body, without gravity, from the slots. The same on all ranks.
  /// Collective.
  std::vector<Wrench> operator()(const Model& model, const State& state) { return (*this)(model, state, state.time); }

  /// Forces with loads on points of bodies at another time.
  std::vector<Wrench> operator()(const Model& model, const State& state, double time);

 private:
  std::vector<Wrench> sum_nodes(const Model& model, const State& state);

  ExactSums<6> memory_{"percuss::rigid_forces"};
  std::vector<ExactSum> sums_;
};

}  // namespace percuss
