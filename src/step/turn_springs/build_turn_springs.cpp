#include "src/step/turn_springs/build_turn_springs.hpp"

#include <fmt/format.h>

#include "src/deck/rigid_bodies.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {
namespace {

SpringLaw make_table(const std::optional<double>& slope, const std::vector<std::array<double, 2>>& rows) {
  SpringLaw law;
  law.rows = rows;
  if (slope) law.rows = {{{0, 0}, {1, *slope}}};
  law.largest_slope = find_largest_slope(law);
  return law;
}

TurnLaw make_law(const TurnLawDeck& deck) {
  TurnLaw law;
  law.spring = make_table(deck.stiffness, deck.table);
  law.damper = make_table(deck.damping > 0 ? std::optional(deck.damping) : std::nullopt, deck.damping_table);
  law.friction.rows = deck.friction_table;
  if (deck.friction) law.friction.rows = {{{0, *deck.friction}, {1, *deck.friction}}};
  law.hold_stiffness = deck.hold_stiffness.value_or(0);
  law.least = deck.least;
  law.most = deck.most;
  return law;
}

std::array<Vector3<double>, 3> make_axes(const std::array<Vec3, 2>& of) {
  const Vector3<double> x = to_vector(of[0]), y = to_vector(of[1]);
  return {x, y, cross(x, y)};
}

}  // namespace

void build_turn_springs(const Deck& deck, Model& model) {
  const RigidNames names = name_rigid_bodies(deck);
  for (const TurnSpringDeck& of : deck.turn_springs) {
    TurnSpring spring;
    spring.name = of.name;
    spring.body = {names.find(of.bodies[0]), names.find(of.bodies[1])};
    spring.axes = {make_axes(of.axes), make_axes(of.second_axes.value_or(of.axes))};
    const std::array<const std::optional<TurnLawDeck>*, 3> laws{&of.x, &of.y, &of.z};
    for (std::size_t k = 0; k < 3; ++k)
      if (*laws[k]) spring.laws[k] = make_law(**laws[k]);
    model.turn_springs.push_back(std::move(spring));
    model.mass_notes.push_back(fmt::format("turn spring '{}': of '{}' and '{}'", of.name, of.bodies[0], of.bodies[1]));
  }
}

}  // namespace percuss
