#pragma once
// The springs of a step: new lengths, forces into the slots, work, and what they leave of the step.
//
// Every rank computes all springs, from places and velocities that the owners of their nodes send to all.

#include <cstdint>
#include <limits>
#include <vector>

#include "src/step/model/state.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {

/// What springs leave of a step.
struct SpringLimit {
  double step = 0;
  std::int64_t spring = -1;  // that alone allows less than what else there is, the one that allows least; -1: none
};

class SpringStage {
 public:
  /// Collective over the model's ranks. The model outlives this.
  explicit SpringStage(const Model& model);

  /// Forces at n+1, and the work of the step; dt = 0: those at time 0, and the energy that is stored then. Call with x
  /// at n+1 and v at n+1/2. Collective.
  void advance(State& state, double dt);

  /// Springs break whose nodes have vanished. Collective.
  void drop_vanished(State& state);

  /// The forces into the slots of the nodes that this rank owns.
  void apply(const State& state);

  /// The largest stable step, if what else there is allows `step` alone. Call after advance() or drop_vanished().
  SpringLimit limit_step(const State& state, double step) const;

 private:
  /// What the owner of a node tells.
  struct NodeRow {
    enum : std::size_t { place, velocity = place + 3, mobility = velocity + 3, count };
    static constexpr double gone = -1;
  };
  /// What all springs are bounded by, and the one that alone allows the shortest step.
  struct StiffestSpring {
    SpringRates rates;  // the largest of all
    std::int64_t spring = -1;
    double step = std::numeric_limits<double>::infinity();  // that this one allows
  };

  double value(std::size_t node, std::size_t k) const { return rows_[node * NodeRow::count + k]; }
  Vector3<double> vector(std::size_t node, std::size_t first) const {
    return {value(node, first), value(node, first + 1), value(node, first + 2)};
  }
  void gather(const State& state);
  SpringEnds find_ends(const Spring& spring) const;
  bool has_lost_a_node(const Spring& spring) const;
  std::vector<double> find_mobilities(const State& state) const;
  StiffestSpring find_rates(const State& state) const;

  const Model& model_;
  std::vector<int> body_of_node_;  // [SpringModel::nodes] rigid; -1: none
  std::vector<double> rows_;       // [SpringModel::nodes][NodeRow::count] of the last gather()
  Kokkos::View<double**, Kokkos::LayoutRight, MemSpace> own_rows_;
  Rows3<double> own_forces_;
};

}  // namespace percuss
