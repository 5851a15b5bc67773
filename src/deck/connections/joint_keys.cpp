#include "src/deck/connections/joint_keys.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/deck/rigid_bodies.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

const Keys<JointDeck>& joint_keys() {
  ChoiceValue<JointDeck::Kind> kinds;
  for (const JointTraits& traits : joint_traits) kinds.choices.emplace_back(traits.word, traits.kind);
  static const Keys<JointDeck> keys = {
      need("kind", &JointDeck::kind, kinds),
      need("bodies", &JointDeck::bodies, ListValue<NameValue>{}),
      need("at", &JointDeck::at, vector3()),
      may("axis", &JointDeck::axis, DirectionValue{}),
      may("second_axis", &JointDeck::second_axis, DirectionValue{}),
      may("lead", &JointDeck::lead, NumberValue{any_number}),
  };
  return keys;
}

/// Whether a joint has the axis if its kind has one, and none if not.
bool check_axis(const Reader& reader, const Node& node, const JointDeck& joint, const char* key, bool is_given,
                bool is_needed) {
  if (is_given == is_needed) return true;
  const JointTraits& traits = find_traits(joint.kind);
  const std::string why = fmt::format("(a {} joint {})", traits.word, traits.motion);
  if (is_needed)
    reader.error(node.spot, fmt::format("{} has no {} {}", reader.self(), key, why));
  else
    reader.error(node.find(key)->key, fmt::format("{} has a key {} {}: leave it out", reader.self(), key, why));
  return false;
}

/// The axes of a universal joint are those of its cross.
bool check_cross(const Reader& reader, const Node& node, const JointDeck& joint) {
  constexpr double round_off = 1e-6;
  if (!joint.second_axis) return true;
  const Vec3 &a = *joint.axis, &b = *joint.second_axis;
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  if (std::abs(cosine) <= round_off) return true;
  reader.error(node.find("second_axis")->key,
               fmt::format("{} has axes whose angle is {:.4g} degrees (those of a cross are perpendicular)",
                           reader.self(), std::acos(cosine) * 180 / std::numbers::pi));
  return false;
}

bool check_lead(const Reader& reader, const Node& node, const JointDeck& joint) {
  if (!joint.lead || *joint.lead != 0) return true;
  reader.error(node.find("lead")->spot, fmt::format("{} is 0 (such a screw does not slide): use revolute, or give the "
                                                    "way of a turn; a left-handed thread has a negative one",
                                                    reader.name_of("lead")));
  return false;
}

bool check_joint(const Reader& reader, const Node& node, JointDeck& joint) {
  const Node& bodies = *node.find("bodies");
  if (joint.bodies.empty() || joint.bodies.size() > 2) {
    reader.error(bodies.spot,
                 fmt::format("{} has {} names{} (must have two, or one of a body that is joined to the ground)",
                             reader.name_of("bodies"), joint.bodies.size(), reader.in()));
    return false;
  }
  if (joint.bodies.size() == 2 && joint.bodies[0] == joint.bodies[1]) {
    reader.error(bodies.items[1].spot,
                 fmt::format("{} joins '{}' to itself (which moves as one anyway)", reader.self(), joint.bodies[0]));
    return false;
  }
  const JointTraits& traits = find_traits(joint.kind);
  return check_axis(reader, node, joint, "axis", joint.axis.has_value(), traits.has_axis()) &&
         check_axis(reader, node, joint, "second_axis", joint.second_axis.has_value(), traits.has_second_axis()) &&
         check_axis(reader, node, joint, "lead", joint.lead.has_value(), traits.has_lead()) &&
         check_lead(reader, node, joint) && check_cross(reader, node, joint);
}

/// Whether two joints join the same bodies at the same place.
bool repeats(const JointDeck& a, const JointDeck& b) {
  return a.at == b.at && a.bodies.size() == b.bodies.size() &&
         std::is_permutation(a.bodies.begin(), a.bodies.end(), b.bodies.begin());
}

}  // namespace

NamedMapValue<JointDeck, MapValue<JointDeck>> joints_value() { return {"joint", {joint_keys, check_joint}}; }

void check_joints(const Deck& deck, const Node& root, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  const auto is_part = [&](const std::string& name) {
    return std::any_of(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& part) { return part.name == name; });
  };
  for (auto joint = deck.joints.begin(); joint != deck.joints.end(); ++joint) {
    const Node* node = root.find("joints")->find(joint->name);
    for (std::size_t i = 0; i < joint->bodies.size(); ++i) {
      const std::string& name = joint->bodies[i];
      if (names.find(name) >= 0 || node->find("bodies")->items.size() != joint->bodies.size()) continue;
      reading.errors.add(
          node->find("bodies")->items[i].spot,
          is_part(name) ? fmt::format("joint '{}' is to hold part '{}', which deforms (joints hold rigid bodies): make "
                                      "it rigid, or join nodes of it that are a rigid set",
                                      joint->name, name)
                        : fmt::format("joint '{}' is to hold '{}', which is no rigid body{}", joint->name, name,
                                      name_hint(name, names.bodies)));
    }
    const auto first = std::find_if(deck.joints.begin(), joint, [&](const JointDeck& j) { return repeats(j, *joint); });
    if (first != joint)
      reading.errors.add(node->key, fmt::format("joint '{}' joins the same bodies at the same point as '{}' (once is "
                                                "enough): leave one of them out",
                                                joint->name, first->name));
  }
}

}  // namespace percuss
