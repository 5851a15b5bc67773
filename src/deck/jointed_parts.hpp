#pragma once
// Rigid parts that joints hold together.

#include <algorithm>
#include <cstddef>
#include <string>

#include "src/deck/deck.hpp"

namespace percuss {

/// Whether a joint holds two parts together. They are meant to touch there, and to have no contact.
inline bool are_jointed(const Deck& deck, std::size_t part, std::size_t other) {
  const auto holds = [&](const JointDeck& joint, std::size_t p) {
    const PartDeck& one = deck.parts[p];
    if (!one.rigid) return false;
    const std::string& body = one.rigid->body.empty() ? one.name : one.rigid->body;
    return std::find(joint.bodies.begin(), joint.bodies.end(), body) != joint.bodies.end();
  };
  return std::any_of(deck.joints.begin(), deck.joints.end(),
                     [&](const JointDeck& joint) { return holds(joint, part) && holds(joint, other); });
}

}  // namespace percuss
