#include "src/step/rigid/body_columns.hpp"

#include <fmt/format.h>

#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {
namespace {

/// Source of a value.
struct Source {
  const RigidState& state;
  const RigidSums& sums;
};

struct BodyColumn {
  const char* name;
  Dimension dimension;
  const char* meaning;  // {}: the body
  double (*value)(const Source&);
};

constexpr Dimension rate{0, 0, -1};
namespace dim = dimensions;

constexpr BodyColumn body_columns[] = {
    {"x", dim::length, "centre of mass in x of {}", [](const Source& s) { return s.state.center.x; }},
    {"y", dim::length, "centre of mass in y of {}", [](const Source& s) { return s.state.center.y; }},
    {"z", dim::length, "centre of mass in z of {}", [](const Source& s) { return s.state.center.z; }},
    {"vx", dim::velocity, "velocity in x of {}, at its centre of mass half a step earlier",
     [](const Source& s) { return s.state.velocity.x; }},
    {"vy", dim::velocity, "velocity in y of {}, at its centre of mass half a step earlier",
     [](const Source& s) { return s.state.velocity.y; }},
    {"vz", dim::velocity, "velocity in z of {}, at its centre of mass half a step earlier",
     [](const Source& s) { return s.state.velocity.z; }},
    {"q0",
     {},
     "orientation q0 of {}, scalar of the unit quaternion",
     [](const Source& s) { return s.state.orientation.w; }},
    {"q1", {}, "orientation q1 of {}, x of the unit quaternion", [](const Source& s) { return s.state.orientation.x; }},
    {"q2", {}, "orientation q2 of {}, y of the unit quaternion", [](const Source& s) { return s.state.orientation.y; }},
    {"q3", {}, "orientation q3 of {}, z of the unit quaternion", [](const Source& s) { return s.state.orientation.z; }},
    {"wx", rate, "angular velocity about x of {}, half a step earlier", [](const Source& s) { return s.state.spin.x; }},
    {"wy", rate, "angular velocity about y of {}, half a step earlier", [](const Source& s) { return s.state.spin.y; }},
    {"wz", rate, "angular velocity about z of {}, half a step earlier", [](const Source& s) { return s.state.spin.z; }},
    {"kinetic", dim::energy, "kinetic energy of {}", [](const Source& s) { return s.sums.kinetic; }},
};

}  // namespace

std::vector<HistoryColumn> list_body_columns(const RigidModel& rigid) {
  std::vector<HistoryColumn> columns;
  for (const RigidBody& body : rigid.bodies)
    for (const BodyColumn& column : body_columns)
      columns.push_back({fmt::format("body_{}:{}", column.name, body.name), column.dimension,
                         fmt::format(fmt::runtime(column.meaning), "rigid body '" + body.name + "'")});
  return columns;
}

std::vector<HistoryColumn> list_joint_columns(const RigidModel& rigid) {
  std::vector<HistoryColumn> columns;
  for (const Joint& joint : rigid.joints) {
    for (const char* axis : {"x", "y", "z"})
      columns.push_back({fmt::format("joint_f{}:{}", axis, joint.name), dim::force,
                         fmt::format("force in {} of joint '{}', on its first body", axis, joint.name)});
    if (!joint.keeps_axis && !joint.keeps_turn) continue;
    for (const char* axis : {"x", "y", "z"})
      columns.push_back({fmt::format("joint_m{}:{}", axis, joint.name), dim::energy,
                         fmt::format("moment about {} of joint '{}', on its first body", axis, joint.name),
                         HistoryColumn::Kind::moment});
  }
  return columns;
}

void append_joints(const Model& model, const State& state, std::vector<double>& row) {
  for (std::size_t j = 0; j < state.joints.size(); ++j) {
    for (int k = 0; k < 3; ++k) row.push_back(get(state.joints[j].force, k));
    const Joint& joint = model.rigid.joints[j];
    for (int k = 0; (joint.keeps_axis || joint.keeps_turn) && k < 3; ++k) row.push_back(get(state.joints[j].moment, k));
  }
}

void BodyColumns::append(const Model& model, const State& state, std::vector<double>& row) {
  if (!find_forces_) find_forces_.emplace(model);
  const std::vector<BodyForces> forces = (*find_forces_)(state);
  for (std::size_t b = 0; b < forces.size(); ++b) {
    const RigidSums sums = sum_rigid_body(model, state, b, forces[b]);
    for (const BodyColumn& column : body_columns) row.push_back(column.value({state.bodies[b], sums}));
  }
}

}  // namespace percuss
