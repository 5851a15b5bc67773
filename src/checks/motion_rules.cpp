// What moves nothing, and bodies that meet nothing or pass through each other.

#include <algorithm>
#include <cmath>

#include "src/checks/flight.hpp"
#include "src/checks/rules.hpp"

namespace percuss {
namespace {

bool names(const Deck& deck, const Selector& where, std::size_t part) {
  const std::vector<std::size_t> parts = find_named_parts(deck, where);
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

template <class Entries>
bool any_names(const Deck& deck, const Entries& entries, std::size_t part) {
  return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return names(deck, entry.where, part); });
}

/// Whether a part has someone to touch, by the deck: a surface, a tie, a wall.
bool has_contact(const Deck& deck, std::size_t part) {
  const auto touches = [&](const auto& pair) { return names(deck, pair.a, part) || names(deck, pair.b, part); };
  const ContactDeck& contact = deck.contact;
  return (contact.surfaces == ContactDeck::Surfaces::all && deck.parts.size() > 1) ||
         std::any_of(contact.pairs.begin(), contact.pairs.end(), touches) ||
         std::any_of(contact.ties.begin(), contact.ties.end(), touches);
}

bool has_wall(const Deck& deck, const WallDeck& wall, std::size_t part) {
  return wall.nodes.empty() || std::any_of(wall.nodes.begin(), wall.nodes.end(),
                                           [&](const Selector& where) { return names(deck, where, part); });
}

/// Whether a material sets things in motion by itself: a gas, an explosive, whatever has an energy at the start.
bool is_energetic(const MaterialDeck& material) {
  if (!material.equation_of_state) return false;
  const auto& numbers = material.equation_of_state->numbers;
  return std::any_of(numbers.begin(), numbers.end(), [](const auto& number) {
    return (number.first == "start_energy" || number.first == "energy" || number.first == "c0") && number.second != 0;
  });
}

bool is_moving(const Curve& curve) { return !curve.is_constant() || curve(0) != 0; }

/// Whether a condition moves a node.
bool is_driving(const ConditionDeck& condition) {
  return (condition.kind == ConditionDeck::Kind::velocity || condition.kind == ConditionDeck::Kind::displacement) &&
         std::any_of(condition.value.begin(), condition.value.end(), is_moving);
}

bool has_motion(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const bool spins = std::any_of(scene.measures->parts.begin(), scene.measures->parts.end(),
                                 [](const PartMeasures& part) { return part.speed > 0; });
  return spins || deck.gravity != Vec3{} || !deck.pressures.empty() || !deck.nodal_loads.empty() ||
         deck.contact.overlap == ContactDeck::Overlap::push_out ||
         std::any_of(deck.conditions.begin(), deck.conditions.end(), is_driving) ||
         std::any_of(deck.parts.begin(), deck.parts.end(),
                     [&](const PartDeck& part) { return is_energetic(find_material(deck, part)); });
}

/// Pairs of parts that can meet before the end, the first of them the one that moves; a few.
struct Meeting {
  std::size_t a, b;
  double time;
};

std::vector<Meeting> find_meetings(const CheckedScene& scene, std::size_t most) {
  const std::vector<Flight> flights = find_flights(scene);
  std::vector<Meeting> meetings;
  for (std::size_t a = 0; a < flights.size(); ++a) {
    for (std::size_t b = a + 1; b < flights.size() && meetings.size() < most; ++b) {
      if (!flights[a].moves() && !flights[b].moves()) continue;
      const double time = find_meeting(flights[a], flights[b], scene.deck.time.end);
      if (time >= 0) meetings.push_back(flights[a].moves() ? Meeting{a, b, time} : Meeting{b, a, time});
    }
  }
  return meetings;
}

/// When a part can first touch another one or a wall, up to a time; below 0: never.
double find_first_meeting(const CheckedScene& scene, const std::vector<Flight>& flights, std::size_t part, double end) {
  double first = -1;
  const auto take = [&](double time) { first = time < 0 || (first >= 0 && first <= time) ? first : time; };
  for (std::size_t other = 0; other < flights.size() && first != 0; ++other) {
    if (other != part) take(find_meeting(flights[part], flights[other], end));
  }
  for (const WallDeck& wall : scene.deck.walls) {
    if (has_wall(scene.deck, wall, part)) take(find_meeting(flights[part], wall, end));
  }
  return first;
}

}  // namespace

std::vector<Warning> check_still_scene(const CheckedScene& scene) {
  if (has_motion(scene)) return {};
  return {warn_at(scene.deck, "still_scene", "time.end",
                  "nothing moves in this run (no velocity, load, gravity or prescribed motion is given): add what is "
                  "missing, such as initial")};
}

std::vector<Warning> check_idle_parts(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (!has_motion(scene) || deck.gravity != Vec3{}) return warnings;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const bool is_used = scene.measures->parts[p].speed > 0 || any_names(deck, deck.conditions, p) ||
                         any_names(deck, deck.pressures, p) || any_names(deck, deck.nodal_loads, p) ||
                         has_contact(deck, p) || is_energetic(find_material(deck, deck.parts[p]));
    if (is_used) continue;
    warnings.push_back(
        warn_at(deck, "idle_part", "parts." + deck.parts[p].name,
                fmt::format("part '{}' stays as it is (it has no velocity, condition, load or contact): add "
                            "one, or remove the part",
                            deck.parts[p].name)));
  }
  return warnings;
}

std::vector<Warning> check_unreached_bodies(const CheckedScene& scene) {
  constexpr double longer = 100;  // times of the run, in which a body is followed to say when it would arrive
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (deck.parts.size() < 2 && deck.walls.empty()) return warnings;
  const std::vector<Flight> flights = find_flights(scene);
  for (std::size_t p = 0; p < flights.size(); ++p) {
    const bool can_touch = has_contact(deck, p) || !deck.walls.empty();
    if (!can_touch || !flights[p].is_free() || !flights[p].moves() || any_names(deck, deck.pressures, p) ||
        any_names(deck, deck.nodal_loads, p))
      continue;
    if (find_first_meeting(scene, flights, p, deck.time.end) >= 0) continue;
    const double later = find_first_meeting(scene, flights, p, longer * deck.time.end);
    const std::string name = deck.parts[p].name;
    const std::string text =
        later < 0 ? fmt::format(
                        "part '{}' moves away from all other bodies and walls (it will not touch any): check its "
                        "velocity and its place",
                        name)
                  : fmt::format(
                        "part '{}' touches nothing before time.end = {:g} (it needs until about {:.2g}): run longer, "
                        "or start closer",
                        name, deck.time.end, later);
    warnings.push_back(warn_at(deck, "unreached_body", "parts." + name, text));
  }
  return warnings;
}

std::vector<Warning> check_missing_contact(const CheckedScene& scene) {
  constexpr std::size_t most = 1;  // one pair says it all
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (deck.parts.size() < 2) return warnings;
  if (deck.contact.surfaces == ContactDeck::Surfaces::none && deck.contact.ties.empty()) {
    for (const Meeting& meeting : find_meetings(scene, most)) {
      warnings.push_back(
          warn_at(deck, "no_contact", deck.places.has("contact") ? "contact" : "parts",
                  fmt::format("parts '{}' and '{}' pass through each other (from t = {:.2g} on, contact is "
                              "off): add contact: {{surfaces: all}}",
                              deck.parts[meeting.a].name, deck.parts[meeting.b].name, meeting.time)));
    }
  }
  if (deck.contact.surfaces != ContactDeck::Surfaces::pairs) return warnings;
  for (const Meeting& meeting : find_meetings(scene, deck.parts.size())) {
    for (const auto& [part, other] : {std::pair(meeting.a, meeting.b), std::pair(meeting.b, meeting.a)}) {
      if (has_contact(deck, part)) continue;
      warnings.push_back(
          warn_at(deck, "no_contact", "contact.surfaces",
                  fmt::format("part '{}' is in no pair of contact.surfaces and passes through part '{}' (from "
                              "t = {:.2g} on): add a pair",
                              deck.parts[part].name, deck.parts[other].name, meeting.time)));
    }
  }
  return warnings;
}

}  // namespace percuss
