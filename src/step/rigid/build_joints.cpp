// Joints between the rigid bodies of a model.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "src/deck/rigid_bodies.hpp"
#include "src/index.hpp"
#include "src/step/joints/joint_rows.hpp"
#include "src/step/rigid/build_rigid.hpp"

namespace percuss {
namespace {

JointEnd make_end(const RigidModel& rigid, int body, const JointDeck& joint) {
  JointEnd end;
  end.body = body;
  end.arm = to_vector(joint.at);
  if (body != Joint::ground) end.arm = end.arm - rigid.bodies[at(body)].center;
  end.axis = joint.axis ? to_vector(*joint.axis) : Vector3<double>{0, 0, 1};  // any of a fixed joint
  return end;
}

/// The directions whose right angle keeps the turn: those of a cross, or two across the axis.
void set_turns(const JointDeck& of, Joint& joint) {
  if (of.second_axis) {
    joint.ends[0].turn = to_vector(*of.axis);
    joint.ends[1].turn = to_vector(*of.second_axis);
    return;
  }
  const std::array<Vector3<double>, 2> across = find_sides(joint.ends[0].axis);
  for (std::size_t e = 0; e < 2; ++e) joint.ends[e].turn = across[e];
}

std::string describe(const JointDeck& joint) {
  return fmt::format("joint '{}': {}, of '{}' and {}", joint.name, find_traits(joint.kind).word, joint.bodies[0],
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
    const JointTraits& traits = find_traits(of.kind);
    joint.point = traits.point;
    joint.keeps_axis = traits.keeps_axis;
    joint.keeps_turn = traits.keeps_turn;
    joint.ends = {make_end(model.rigid, first, of), make_end(model.rigid, second, of)};
    joint.lead = of.lead.value_or(0) / (2 * std::numbers::pi);
    if (joint.keeps_turn || joint.lead != 0) set_turns(of, joint);
    joint.length = std::sqrt(trace(body.inertia) / (2 * body.mass));
    model.rigid.joints.push_back(joint);
    model.mass_notes.push_back(describe(of));
  }
}

}  // namespace percuss
