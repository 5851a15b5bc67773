#pragma once
// Bricks taken through one step of contact: search, check, rows, impulses.

#include "kernels/contact/enforcement/row_solution.hpp"
#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test {

enum class Solver { iterated, together, springs };

/// A step, and the time from the middle of the one before to its own.
struct SceneStep {
  double dt, dt_mean;
  SceneStep(double even) : dt(even), dt_mean(even) {}
  SceneStep(double before, double now) : dt(now), dt_mean(0.5 * (before + now)) {}
};

/// A scene taken through one enforcement; v is corrected. slip: that records hold at the start.
template <class Space>
struct EnforcedScene {
  EnforcedScene(const BrickScene& bricks, const SceneStep& step, double friction, const WallPairs& walls = no_walls(),
                Solver solver = Solver::iterated, double tolerance = 1e-3, const Point3& slip = {})
      : scene(bricks, step.dt, friction),
        before(to_rows(bricks.v)),
        inverse_mass(to_rows(bricks.inverse_mass)),
        impulse("test::impulse", bricks.v.size()) {
    history = make_empty_history(bricks.num_nodes(), static_cast<int>(walls.node.extent(0)));
    for (std::size_t r = 0; r < history.slip.extent(0); ++r) store_row(history.slip, static_cast<int>(r), slip);
    const Space space;
    const Array<std::int64_t> nodes = count_up(scene.surface.num_nodes), faces = count_up(scene.surface.num_faces);
    Array<RowTouch> touches("test::touches", 0);
    collect_touches(space, scene.surface, scene.candidates, scene.touches, {faces, nodes}, touches);
    OneRank others;
    for (int i = 0; i < scene.touches.count; ++i) touches(i).has_thickness = bricks.has_thickness;
    RowInputs inputs{scene.motion, before, inverse_mass, nodes, 1};
    if (solver == Solver::springs) {
      inputs.spring = to_array(std::vector<double>(bricks.v.size(), 1.0));
      inputs.springs = SpringRows::all;
      // Springs push what earlier steps have seen going in; depth that nothing has seen is held.
      for (int i = 0; i < scene.touches.count; ++i) touches(i).old_record = touches(i).record;
    }
    const RowSources sources{touches, scene.touches.count, walls};
    count_rows(space, inputs, sources, system);
    build_rows(space, inputs, sources, history, system, others);
    if (system.num_rows == 0) return;
    RowSumMemory memory;
    const SolveQuery query{step.dt, step.dt_mean, tolerance, 2, nodes};
    solved = solver == Solver::springs    ? solve_springs(space, query, system, memory, others)
             : solver == Solver::iterated ? solve_kinematic(space, query, system, memory, others)
                                          : solve_lagrange(space, query, system, memory, others);
    apply_impulses(space, system, scene.v, impulse);
    sums = sum_outcome(space, step.dt, system, memory);
    write_history(space, step.dt, system, history);
  }

  static Array<std::int64_t> count_up(int count) {
    const Array<std::int64_t> numbers("test::numbers", static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) numbers(i) = i;
    return numbers;
  }

  static WallPairs no_walls() {
    return {to_array(std::vector<ContactWall>{}), to_array(std::vector<int>{}), to_array(std::vector<int>{}),
            to_array(std::vector<double>{})};
  }
  Point3 v(int node) const { return load_row(scene.v, node); }
  Point3 p(int node) const { return load_row(impulse, node); }

  CheckedScene scene;
  ContactHistory history;
  Rows3<double> before, inverse_mass, impulse;
  RowSystem system;
  SolveReport solved;
  EnforcementSums sums;
};

/// Momentum and energy that a step of contact gave to a scene.
struct Gain {
  Point3 linear{}, angular{};
  double kinetic = 0;
};

template <class Space>
Gain find_gain(const EnforcedScene<Space>& scene, const BrickScene& bricks) {
  Gain gain;
  for (int n = 0; n < bricks.num_nodes(); ++n) {
    const double mass = 1 / bricks.inverse_mass[static_cast<std::size_t>(n)].x;
    const Point3 old = load_row(scene.before, n), dp = mass * (scene.v(n) - old);
    gain.linear = gain.linear + dp;
    gain.angular = gain.angular + cross(bricks.x[static_cast<std::size_t>(n)], dp);
    gain.kinetic += 0.5 * mass * (dot(scene.v(n), scene.v(n)) - dot(old, old));
  }
  return gain;
}

}  // namespace percuss::test
