// Joints between the rigid bodies of a model.

#include <fmt/format.h>

#include <cmath>

#include "src/deck/rigid_bodies.hpp"
#include "src/index.hpp"
#include "src/step/rigid/build_rigid.hpp"

namespace percuss {
namespace {

JointEnd make_end(const RigidModel& rigid, int body, const JointDeck& joint) {
  JointEnd end;
  end.body = body;
  end.arm = to_vector(joint.at);
  if (body != Joint::ground) end.arm = end.arm - rigid.bodies[at(body)].center;
  if (joint.axis) end.axis = to_vector(*joint.axis);
  return end;
}

std::string describe(const JointDeck& joint) {
  return fmt::format("joint '{}': {}, of '{}' and {}", joint.name,
                     joint.kind == JointDeck::Kind::revolute ? "revolute" : "spherical", joint.bodies[0],
                     joint.bodies.size() > 1 ? fmt::format("'{}'", joint.bodies[1]) : std::string("the ground"));
}

}  // namespace

void build_joints(const Deck& deck, Model& model) {
  const RigidNames names = name_rigid_bodies(deck);
  for (const JointDeck& of : deck.joints) {
    const int first = names.find(of.bodies[0]),
              second = of.bodies.size() > 1 ? names.find(of.bodies[1]) : Joint::ground;
    const RigidBody& body = model.rigid.bodies[at(first)];
    Joint joint;
    joint.name = of.name;
    joint.place = deck.where(of.place);
    joint.has_axis = of.kind == JointDeck::Kind::revolute;
    joint.ends = {make_end(model.rigid, first, of), make_end(model.rigid, second, of)};
    joint.length = std::sqrt(trace(body.inertia) / (2 * body.mass));
    model.rigid.joints.push_back(joint);
    model.mass_notes.push_back(describe(of));
  }
}

}  // namespace percuss
