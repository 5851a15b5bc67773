// Motions without effect, and bodies that meet nothing or pass through each other.

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/checks/flight.hpp"
#include "src/checks/rules.hpp"
#include "src/checks/who_touches.hpp"
#include "src/deck/embedded_parts.hpp"
#include "src/deck/jointed_parts.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

template <class Entries>
Marks mark_named(const Deck& deck, const Entries& entries) {
  Marks marks(deck.parts.size(), false);
  for (const auto& entry : entries) mark(deck, entry.where, marks);
  return marks;
}

/// Whether a material starts motion by itself: a gas, an explosive, or any material with energy at the start.
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
  if (condition.turn) return is_moving(condition.turn->angular_velocity);
  return (condition.kind == ConditionDeck::Kind::velocity || condition.kind == ConditionDeck::Kind::displacement) &&
         std::any_of(condition.value.begin(), condition.value.end(), is_moving);
}

/// Whether a wall moves though nothing pushes it.
bool is_driven(const WallDeck& wall) { return wall.speed ? is_moving(*wall.speed) : wall.start_speed != 0; }

/// Times of the run, in which a body is followed to say when it would arrive.
constexpr double longer = 1024;

/// Whether the deck has connections by which one part may move another.
bool has_connections(const Deck& deck) {
  return !deck.springs.empty() || !deck.welds.empty() || !deck.constraints.empty() || !deck.embedded.empty();
}

/// Whether any wall can move, which no flight knows of.
bool has_moving_wall(const Deck& deck) {
  return std::any_of(deck.walls.begin(), deck.walls.end(), [](const WallDeck& wall) { return wall.moves(); });
}

bool has_motion(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const bool spins = std::any_of(scene.measures->parts.begin(), scene.measures->parts.end(),
                                 [](const PartMeasures& part) { return part.speed > 0; });
  return spins || deck.gravity.any() || !deck.pressures.empty() || !deck.nodal_loads.empty() || !deck.springs.empty() ||
         deck.contact.overlap == ContactDeck::Overlap::push_out ||
         std::any_of(deck.conditions.begin(), deck.conditions.end(), is_driving) ||
         std::any_of(deck.constraints.begin(), deck.constraints.end(),
                     [](const ConstraintDeck& constraint) { return constraint.sum.has_value(); }) ||
         std::any_of(deck.walls.begin(), deck.walls.end(), is_driven) || !deck.start.preloads.empty() ||
         !deck.start.fields.empty() || std::any_of(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& part) {
           return is_energetic(find_material(deck, part));
         });
}

/// Pairs of parts whose boxes come to overlap before the end, the first of them the one that moves; a few. Not those
/// whose boxes do so from the start, as of a bolt and the plate around it.
struct Meeting {
  std::size_t a, b;
  double time;
};

std::vector<Meeting> find_meetings(const CheckedScene& scene, std::size_t most) {
  const std::vector<Flight> flights = find_flights(scene);
  const Marks of_beams = scene.measures->mark_beams();
  std::vector<Meeting> meetings;
  for (std::size_t a = 0; a < flights.size(); ++a) {
    for (std::size_t b = a + 1; b < flights.size() && meetings.size() < most; ++b) {
      if ((!flights[a].moves() && !flights[b].moves()) || flights[a].moves_with(flights[b])) continue;
      if (scene.measures->are_joined(a, b) || are_sprung(scene.deck, a, b)) continue;
      if (of_beams[a] || of_beams[b]) continue;  // check_beam_contact()
      if (do_overlap(flights[a].find_box(0), flights[b].find_box(0))) continue;
      const double time = find_meeting(flights[a], flights[b], scene.deck.time.end, overlapping_share);
      if (time >= 0) meetings.push_back(flights[a].moves() ? Meeting{a, b, time} : Meeting{b, a, time});
    }
  }
  return meetings;
}

/// When two bodies first touch; below 0: never.
struct FirstMeeting {
  double time = -1, gap = 0;  // gap: at the start

  void take(double when, double how_far) {
    if (when < 0 || (time >= 0 && time <= when)) return;
    time = when;
    gap = how_far;
  }
};

/// When bodies can first touch each other or walls.
class FirstMeetings {
 public:
  explicit FirstMeetings(const CheckedScene& scene)
      : deck_(scene.deck),
        are_free_to_part_(scene.deck.contact.ties.empty() && scene.deck.joints.empty()),
        flights_(find_flights(scene)) {
    for (const WallDeck& wall : deck_.walls) stopped_.push_back(mark_stopped(deck_, wall));
  }

  const Flight& flight(std::size_t part) const { return flights_[part]; }

  /// First meeting of a part, up to a time; below 0: never. Parts that move apart during the run have to come back;
  /// parts that move together do nothing to each other.
  FirstMeeting find(std::size_t part, double end) const {
    FirstMeeting first;
    const Flight& own = flights_[part];
    for (std::size_t other = 0; other < flights_.size() && first.time != 0; ++other) {
      if (other == part || own.moves_with(flights_[other])) continue;
      const bool separate = are_free_to_part_ && do_separate(own, flights_[other], deck_.time.end);
      first.take(find_meeting(own, flights_[other], end, separate ? overlapping_share : touching_share),
                 find_gap(own.find_box(0), flights_[other].find_box(0)));
    }
    for (std::size_t w = 0; w < deck_.walls.size(); ++w) {
      if (!stopped_[w][part]) continue;
      const bool separate = do_separate(own, deck_.walls[w], deck_.time.end);
      const double time = find_meeting(own, deck_.walls[w], end, separate ? overlapping_share : touching_share);
      if (may_act_after(deck_, deck_.walls[w].when, time)) first.take(time, find_gap(own, deck_.walls[w], 0));
    }
    return first;
  }

  /// First meeting of a part in a run that is longer, by up to `longer` times.
  FirstMeeting find_later(std::size_t part) const {
    for (double times = 2; times <= longer; times *= 2) {
      const FirstMeeting meeting = find(part, times * deck_.time.end);
      if (meeting.time >= 0) return meeting;
    }
    return {};
  }

  /// Whether a wall that moves comes to a part before the end.
  bool does_reach(std::size_t wall) const {
    for (std::size_t p = 0; p < flights_.size(); ++p)
      if (stopped_[wall][p] && does_wall_reach(deck_.walls[wall], flights_[p], deck_.time.end)) return true;
    return false;
  }

  /// The smallest distance of a wall from a part at the start.
  double find_gap_of_wall(std::size_t wall) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < flights_.size(); ++p)
      if (stopped_[wall][p]) least = std::min(least, find_gap(flights_[p], deck_.walls[wall], 0));
    return least;
  }

  /// Whether any part can leave its free flight before the end: it meets something, also a wall that comes to it, is
  /// under a load, is tied to something, or may expand. Where it goes then, and whom it sends where, is not known.
  bool may_change(const CheckedScene& scene) const {
    const Deck& deck = scene.deck;
    if (!deck.pressures.empty() || !deck.nodal_loads.empty() || has_connections(deck)) return true;
    if (!deck.gravity.is_constant() || !deck.dampings.empty()) return true;
    for (std::size_t w = 0; w < deck.walls.size(); ++w)
      if (deck.walls[w].moves() && does_reach(w)) return true;
    for (const TieDeck& tie : deck.contact.ties)
      if (does_any_move(tie.a) || does_any_move(tie.b)) return true;
    for (std::size_t p = 0; p < flights_.size(); ++p) {
      if (is_energetic(find_material(deck, deck.parts[p]))) return true;
      if (flights_[p].moves() && find(p, deck.time.end).time >= 0) return true;
    }
    return false;
  }

 private:
  bool does_any_move(const Selector& where) const {
    const std::vector<std::size_t> parts = find_named_parts(deck_, where);
    return std::any_of(parts.begin(), parts.end(), [&](std::size_t p) { return flights_[p].moves(); });
  }

  const Deck& deck_;
  bool are_free_to_part_;  // nothing holds bodies together that move apart
  std::vector<Flight> flights_;
  std::vector<Marks> stopped_;  // by wall
};

/// The part that a part of beams meets before the end; empty: none.
std::string describe_meeting(const CheckedScene& scene, const std::vector<Flight>& flights, std::size_t part) {
  const Deck& deck = scene.deck;
  for (std::size_t other = 0; other < flights.size(); ++other) {
    if (deck.contact.surfaces == ContactDeck::Surfaces::none || scene.measures->are_joined(part, other)) continue;
    if (!flights[part].moves() && !flights[other].moves()) continue;
    if (find_meeting(flights[part], flights[other], deck.time.end, overlapping_share) >= 0)
      return fmt::format("that of part '{}'", deck.parts[other].name);
  }
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    if (flights[part].moves() && find_meeting(flights[part], deck.walls[w], deck.time.end, touching_share) >= 0)
      return fmt::format("walls.{}", w);
  }
  return "";
}

/// later: when the part would touch something, in a run `longer` times as long.
std::string describe_flight(const std::string& part, const Flight& flight, double end, const FirstMeeting& later) {
  const double speed = std::sqrt(dot(flight.velocity(), flight.velocity()));
  if (!flight.is_free())
    return fmt::format(
        "part '{}' is moved by conditions, but comes to nothing before time.end = {:g} (all other bodies and walls "
        "stay "
        "out of the box of its way): check its motion and its place, or run longer",
        part, end);
  if (later.time < 0)
    return fmt::format(
        "part '{}' flies clear of all other bodies and walls (even a run {:g} times as long would not bring them "
        "together): check its velocity and its place",
        part, longer);
  return fmt::format(
      "part '{}' touches nothing before time.end = {:g} (it starts {:.3g} away at a speed of {:.3g}, and would arrive "
      "at "
      "about {:.2g}): check the unit of its velocity, run longer, or start closer",
      part, end, later.gap, speed, later.time);
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
  if (!has_motion(scene) || deck.gravity.any() || has_connections(deck) || has_moving_wall(deck)) return warnings;
  const Marks held = mark_named(deck, deck.conditions), pressed = mark_named(deck, deck.pressures),
              loaded = mark_named(deck, deck.nodal_loads);
  Marks touching = mark_touching(deck);
  mark_jointed(deck, touching);  // other bodies move them
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    if (scene.measures->parts[p].speed > 0 || held[p] || pressed[p] || loaded[p] || touching[p]) continue;
    if (scene.measures->is_joined(p)) continue;  // others move it
    if (is_energetic(find_material(deck, deck.parts[p]))) continue;
    warnings.push_back(warn_at(
        deck, "idle_part", "parts." + deck.parts[p].name,
        fmt::format(
            "nothing acts on part '{}' (it has no velocity, condition, load or contact): add one, or remove the part",
            deck.parts[p].name)));
  }
  return warnings;
}

std::vector<Warning> check_unreached_bodies(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if ((deck.parts.size() < 2 && deck.walls.empty()) || deck.parts.size() > most_compared_parts) return warnings;
  const FirstMeetings meetings(scene);
  const Marks touching = mark_touching(deck);
  if (meetings.may_change(scene)) return warnings;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const Flight& flight = meetings.flight(p);
    if (scene.measures->is_joined(p)) continue;  // what it is joined to may stop it
    if (!flight.is_known() || !flight.moves() || (!touching[p] && deck.walls.empty())) continue;
    const FirstMeeting later = meetings.find_later(p);
    const std::string& name = deck.parts[p].name;
    const std::string text = describe_flight(name, flight, deck.time.end, later);
    warnings.push_back(warn_at(deck, "unreached_body", "parts." + name, text));
  }
  return warnings;
}

std::vector<Warning> check_wall_motion(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (!has_moving_wall(deck) || deck.parts.size() > most_compared_parts) return warnings;
  const FirstMeetings meetings(scene);
  if (meetings.may_change(scene)) return warnings;
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    const WallDeck& wall = deck.walls[w];
    if (!is_driven(wall)) continue;
    const double way = find_wall_way(wall, deck.time.end);
    const std::string why = way < 0 && !wall.is_round()
                                ? fmt::format("it moves {:.3g} away from them, as its speed is negative", -way)
                                : fmt::format("it moves {:.3g} and starts {:.3g} away", std::abs(way),
                                              std::max(meetings.find_gap_of_wall(w), 0.0));
    warnings.push_back(warn_at(deck, "wall_motion", join_path("walls", w) + (wall.speed ? ".speed" : ".start_speed"),
                               fmt::format("this wall reaches no body before time.end = {:g} ({}; a speed is positive "
                                           "along the normal): check the sign and the unit of its speed",
                                           deck.time.end, why)));
  }
  return warnings;
}

/// Whether all nodes of a part move as they would had nothing touched it.
bool has_flown(const Flight& flight, double speed, const EndMotion& end, std::size_t part) {
  constexpr double round_off = 1e-6;  // share of the speed
  for (std::size_t k = 0; k < 3; ++k) {
    const double free = flight.velocity()[k] + flight.gravity()[k] * end.time;
    const double margin = round_off * (speed + std::abs(flight.gravity()[k]) * end.time);
    if (std::abs(end.low[part][k] - free) > margin || std::abs(end.high[part][k] - free) > margin) return false;
  }
  return true;
}

std::vector<Warning> check_flown_bodies(const CheckedScene& scene, const EndMotion& end) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if ((deck.parts.size() < 2 && deck.walls.empty()) || !deck.gravity.is_constant() || !deck.dampings.empty())
    return warnings;
  const Marks touching = mark_touching(deck);
  const std::vector<Flight> flights = find_flights(scene);
  for (std::size_t p = 0; p < flights.size(); ++p) {
    const double speed = scene.measures->parts[p].speed;
    if (!flights[p].is_free() || speed == 0 || (!touching[p] && deck.walls.empty())) continue;
    if (!has_flown(flights[p], speed, end, p)) continue;
    warnings.push_back(
        warn_at(deck, "unreached_body", "parts." + deck.parts[p].name,
                fmt::format("part '{}' has flown through the whole run without touching anything (all its "
                            "nodes end with the velocity that they began with): check its velocity, its "
                            "place and time.end = {:g}",
                            deck.parts[p].name, deck.time.end)));
  }
  return warnings;
}

std::vector<Warning> check_beam_contact(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  const bool has_contact = deck.contact.surfaces != ContactDeck::Surfaces::none;
  if ((!has_contact && deck.walls.empty()) || deck.parts.size() > most_compared_parts) return warnings;
  const std::vector<Flight> flights = find_flights(scene);
  const Marks of_beams = scene.measures->mark_beams();
  for (std::size_t p = 0; p < flights.size(); ++p) {
    if (!of_beams[p] || do_beams_touch(scene, p) || is_embedded(deck, deck.parts[p].name)) continue;
    const std::string meets = describe_meeting(scene, flights, p);
    if (meets.empty()) continue;
    warnings.push_back(
        warn_at(deck, "beam_contact", "parts." + deck.parts[p].name,
                fmt::format("the bounding box of part '{}' meets {} (its beams have no contact and pass through): set "
                            "contact.beams, name the part in contact.surfaces, or join it to a part that has a surface",
                            deck.parts[p].name, meets)));
  }
  return warnings;
}

/// Marks touching parts; of joined parts one that has a surface may lie on the others.
Marks mark_touching_with_joined(const CheckedScene& scene, double time) {
  Marks touching = mark_touching(scene.deck, time);
  for (std::size_t p = 0; p < touching.size(); ++p)
    for (std::size_t q = 0; q < touching.size() && !touching[p]; ++q)
      touching[p] = touching[q] && scene.measures->are_joined(p, q);
  return touching;
}

std::vector<Warning> check_missing_contact(const CheckedScene& scene) {
  constexpr std::size_t most = 1;  // one pair says it all
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (deck.parts.size() < 2 || deck.parts.size() > most_compared_parts) return warnings;
  if (deck.contact.surfaces == ContactDeck::Surfaces::none && deck.contact.ties.empty()) {
    for (const Meeting& meeting : find_meetings(scene, most)) {
      warnings.push_back(warn_at(deck, "no_contact", deck.places.has("contact") ? "contact" : "parts",
                                 fmt::format("the bounding boxes of parts '{}' and '{}' meet (from t = {:.2g} on, but "
                                             "contact is off): add contact: {{surfaces: all}}",
                                             deck.parts[meeting.a].name, deck.parts[meeting.b].name, meeting.time)));
    }
  }
  if (deck.contact.surfaces != ContactDeck::Surfaces::pairs) return warnings;
  const Marks ever = mark_touching_with_joined(scene, 0);
  const bool is_switched = std::any_of(deck.contact.pairs.begin(), deck.contact.pairs.end(),
                                       [](const SurfacePairDeck& pair) { return pair.when.any(); });
  for (const Meeting& meeting : find_meetings(scene, deck.parts.size())) {
    if (are_jointed(deck, meeting.a, meeting.b)) continue;
    const Marks touching = is_switched ? mark_touching_with_joined(scene, meeting.time) : ever;
    for (const auto& [part, other] : {std::pair(meeting.a, meeting.b), std::pair(meeting.b, meeting.a)}) {
      if (touching[part]) continue;
      warnings.push_back(
          warn_at(deck, "no_contact", "contact.surfaces",
                  fmt::format("part '{}' is in no pair of contact.surfaces{}, but its bounding box "
                              "meets that of part '{}' (from t = {:.2g} on): {}",
                              deck.parts[part].name, ever[part] ? " that acts then" : "", deck.parts[other].name,
                              meeting.time, ever[part] ? "let one act longer" : "add a pair")));
    }
  }
  return warnings;
}

// Rigid bodies have no waves that would throw them back.
std::vector<Warning> check_restitution(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const ContactDeck& contact = deck.contact;
  if (contact.restitution || contact.surfaces == ContactDeck::Surfaces::none) return {};
  if (deck.parts.size() > most_compared_parts) return {};
  for (const Meeting& meeting : find_meetings(scene, deck.parts.size())) {
    const PartDeck &a = deck.parts[meeting.a], &b = deck.parts[meeting.b];
    if (!a.rigid || !b.rigid || are_jointed(deck, meeting.a, meeting.b)) continue;
    return {warn_at(deck, "restitution", "contact",
                    fmt::format("rigid parts '{}' and '{}' meet (from t = {:.2g} on) and part with {:g} times the "
                                "velocity of approach (the default of contact.enforcement): set contact.restitution",
                                a.name, b.name, meeting.time, contact.find_restitution()))};
  }
  return {};
}

}  // namespace percuss
