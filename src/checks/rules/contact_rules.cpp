// Overlap at the start, walls, friction and ties.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernels/contact/geometry/contact_limits.hpp"
#include "src/checks/rules.hpp"

namespace percuss {
namespace {

const std::string& name_part(const Deck& deck, int part) { return deck.parts[static_cast<std::size_t>(part)].name; }

/// Size that an overlap is compared with: the shortest edge of either part, or the thickness of shells.
double find_contact_size(const CheckedScene& scene, const PartOverlap& overlap) {
  double size = scene.measures->parts[static_cast<std::size_t>(overlap.part)].shortest_edge;
  for (const int part : {overlap.part, overlap.other}) {
    const auto p = static_cast<std::size_t>(part);
    const PartMeasures& measures = scene.measures->parts[p];
    size = std::min(size, measures.shortest_edge);
    if (measures.shell_thickness > 0) size = std::min(size, measures.shell_thickness);
  }
  return size;
}

/// Overlaps between parts, each pair once, its first part the one with the lower number.
std::vector<PartOverlap> list_pairs(const StartOverlap& found) {
  std::vector<PartOverlap> pairs;
  for (PartOverlap overlap : found.parts) {
    if (overlap.other < 0) continue;  // a wall
    if (overlap.other < overlap.part) std::swap(overlap.part, overlap.other);
    const auto same = std::find_if(pairs.begin(), pairs.end(), [&](const PartOverlap& pair) {
      return pair.part == overlap.part && pair.other == overlap.other;
    });
    if (same == pairs.end()) {
      pairs.push_back(overlap);
    } else {
      same->nodes += overlap.nodes;
      same->deepest = std::max(same->deepest, overlap.deepest);
    }
  }
  return pairs;
}

/// The key to look at: the thickness of the thicker shell of the two, or the first part.
std::string find_overlap_path(const CheckedScene& scene, const PartOverlap& pair) {
  const auto thickness_of = [&](int part) {
    return scene.measures->parts[static_cast<std::size_t>(part)].shell_thickness;
  };
  const double a = thickness_of(pair.part), b = thickness_of(pair.other);
  if (!(a > 0) && !(b > 0)) return "parts." + name_part(scene.deck, pair.part);
  return "parts." + name_part(scene.deck, a < b ? pair.other : pair.part) + ".thickness";
}

const PartCrossing* find_crossing(const StartOverlap& found, const PartOverlap& pair) {
  const auto is_there = [&](const PartCrossing& of) { return of.part == pair.part && of.other == pair.other; };
  const auto place = std::find_if(found.crossings.begin(), found.crossings.end(), is_there);
  return place == found.crossings.end() ? nullptr : &*place;
}

/// The crossings of which crossing_parts warns: of solids only where nodes that contact finds inside do not tell the
/// depth.
std::vector<PartCrossing> list_crossings(const StartOverlap& found) {
  constexpr double most = 0.9;  // share of the depth
  std::vector<PartCrossing> list;
  for (const PartCrossing& crossing : found.crossings)
    if (crossing.contact != PartCrossing::Contact::never && crossing.is_deep()) list.push_back(crossing);
  for (const PartOverlap& pair : list_pairs(found))
    std::erase_if(list, [&](const PartCrossing& of) {
      const bool is_pair = of.part == pair.part && of.other == pair.other;
      return is_pair && of.is_of_solids && pair.deepest >= most * of.depth;
    });
  return list;
}

/// Parts of both sides of a tie that deform.
std::vector<std::size_t> find_deforming_sides(const Deck& deck, const TieDeck& tie) {
  std::vector<std::size_t> parts = find_named_parts(deck, tie.a);
  const std::vector<std::size_t> others = find_named_parts(deck, tie.b);
  parts.insert(parts.end(), others.begin(), others.end());
  std::erase_if(parts, [&](std::size_t p) { return deck.parts[p].rigid.has_value(); });
  return parts;
}

}  // namespace

std::vector<Warning> check_crossing_parts(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const PartCrossing& crossing : list_crossings(*scene.overlap)) {
    const std::string &part = name_part(scene.deck, crossing.part), &other = name_part(scene.deck, crossing.other);
    const std::string parts = crossing.part == crossing.other
                                  ? fmt::format("part '{}' crosses itself", part)
                                  : fmt::format("parts '{}' and '{}' cross each other", part, other);
    const std::size_t edges = crossing.places.size();
    const bool is_later = crossing.contact == PartCrossing::Contact::later;
    warnings.push_back(warn_at(
        scene.deck, "crossing_parts", "parts." + part,
        fmt::format(
            "{} at the start: {} edge{} through faces, up to {:.4g} inside at {} (contact{} does not separate what "
            "crosses): move the parts apart",
            parts, edges, edges == 1 ? " goes" : "s go", crossing.depth, crossing.name_place(),
            is_later ? " that begins later" : "")));
  }
  return warnings;
}

std::vector<Warning> check_deep_overlap(const CheckedScene& scene) {
  constexpr double most = 0.2;  // share of an element or thickness: round-off and chords of curved meshes are far less
  std::vector<Warning> warnings;
  const bool is_pushed = scene.deck.contact.overlap == ContactDeck::Overlap::push_out;
  const std::vector<PartCrossing> crossings = list_crossings(*scene.overlap);
  for (const PartOverlap& pair : list_pairs(*scene.overlap)) {
    const auto crosses = [&](const PartCrossing& of) { return of.part == pair.part && of.other == pair.other; };
    if (std::any_of(crossings.begin(), crossings.end(), crosses)) continue;
    const double size = find_contact_size(scene, pair);
    if (pair.deepest <= most * size) continue;
    const PartCrossing* const crossing = find_crossing(*scene.overlap, pair);
    const bool is_known = crossing != nullptr && crossing->is_of_solids;
    warnings.push_back(
        warn_at(scene.deck, "deep_overlap", find_overlap_path(scene, pair),
                fmt::format("parts '{}' and '{}' overlap at the start by {:.3g}, {:.3g} times an element edge or "
                            "thickness, at {} node{}{} "
                            "({}): move them apart or check the thickness",
                            name_part(scene.deck, pair.part), name_part(scene.deck, pair.other), pair.deepest,
                            pair.deepest / size, pair.nodes, pair.nodes == 1 ? "" : "s",
                            is_known ? ", deepest at " + crossing->name_place() : "",
                            is_pushed ? "pushing out such a depth adds energy" : "contact does not remove it")));
  }
  return warnings;
}

namespace {

/// How fast any two bodies may close in at the start.
double find_closing_speed(const CheckedScene& scene) {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartMeasures& part = scene.measures->parts[p];
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = p == 0 ? part.velocity_low[k] : std::min(low[k], part.velocity_low[k]);
      high[k] = p == 0 ? part.velocity_high[k] : std::max(high[k], part.velocity_high[k]);
    }
  }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/// The slowest wave speed of any part; 0 if none has one.
double find_slowest_wave(const Deck& deck) {
  double slowest = 0;
  for (const PartDeck& part : deck.parts) {
    const double speed = find_wave_speed(find_material(deck, part));
    if (speed > 0 && (slowest == 0 || speed < slowest)) slowest = speed;
  }
  return slowest;
}

}  // namespace

// The pressure rho c v / 2 of a plane impact on springs of the stiffness scale M / h that a unit of area has on both
// sides together.
std::vector<Warning> check_penalty_speed(const CheckedScene& scene) {
  constexpr double stiffest = 1;  // penalty_scale; stiffer springs give bodies that part energy
  const ContactDeck& contact = scene.deck.contact;
  if (contact.enforcement != ContactDeck::Enforcement::penalty) return {};
  const double slowest = find_slowest_wave(scene.deck);
  if (slowest == 0) return {};
  constexpr double cushion = contact_limits::spring_cushion;
  const double closing = find_closing_speed(scene);
  const double depth = closing / (2 * contact.penalty_scale * slowest);
  if (depth <= cushion) return {};
  constexpr double margin = 1.01;  // for the digits that are shown
  const double scale = margin * contact.penalty_scale * depth / cushion;
  const std::string remedy =
      scale <= stiffest ? fmt::format("use enforcement kinematic, or a penalty_scale of {:.3g} at least", scale)
                        : std::string("use enforcement kinematic");
  return {warn_at(scene.deck, "penalty_speed", "contact.enforcement",
                  fmt::format("bodies may meet at {:.3g}, {:.3g} of the wave speed (penalty contact would allow a "
                              "penetration of about {:.2g} of an element; beyond {:g} the impact becomes "
                              "inelastic): {}",
                              closing, closing / slowest, depth, cushion, remedy))};
}

std::vector<Warning> check_behind_wall(const CheckedScene& scene) {
  constexpr double most = 0.2;  // share of an element
  std::vector<Warning> warnings;
  for (const PartOverlap& overlap : scene.overlap->parts) {
    if (overlap.other >= 0) continue;
    const double edge = scene.measures->parts[static_cast<std::size_t>(overlap.part)].shortest_edge;
    if (overlap.deepest <= most * edge) continue;
    warnings.push_back(warn_at(
        scene.deck, "behind_wall", join_path("walls", static_cast<std::size_t>(-1 - overlap.other)),
        fmt::format("{} nodes of part '{}' begin behind this wall, up to {:.3g} deep, {:.3g} times an element edge "
                    "(its normal must point to the side of the bodies): reverse the normal or move the part",
                    overlap.nodes, name_part(scene.deck, overlap.part), overlap.deepest, overlap.deepest / edge)));
  }
  return warnings;
}

std::vector<Warning> check_inside_wall(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const PartOverlap& overlap : scene.overlap->lost) {
    warnings.push_back(
        warn_at(scene.deck, "inside_wall", join_path("walls", static_cast<std::size_t>(-1 - overlap.other)),
                fmt::format("{} nodes of part '{}' begin inside this cylinder, up to {:.3g} deep (a cylinder with an "
                            "end does not stop nodes that begin more than half an element edge inside it): move the "
                            "part or the wall, or leave out length",
                            overlap.nodes, name_part(scene.deck, overlap.part), overlap.deepest)));
  }
  return warnings;
}

std::vector<Warning> check_friction(const CheckedScene& scene) {
  constexpr double most = 1;  // dry metals have less; rubber on a rough road, which has 1.5, is rare in a deck
  std::vector<Warning> warnings;
  const auto check = [&](double friction, const std::string& path) {
    if (friction <= most) return;
    warnings.push_back(
        warn_at(scene.deck, "friction", path + ".friction",
                fmt::format("the coefficient of friction is {:g} (dry metals have 0.1 to 0.8; rubber alone has "
                            "up to 1.5): check it",
                            friction)));
  };
  const ContactDeck& contact = scene.deck.contact;
  check(contact.friction, "contact");
  for (std::size_t i = 0; i < contact.frictions.size(); ++i)
    check(contact.frictions[i].friction, join_path("contact.friction.pairs", i));
  for (std::size_t i = 0; i < contact.pairs.size(); ++i)
    check(contact.pairs[i].friction.value_or(0), join_path("contact.surfaces", i));
  for (std::size_t i = 0; i < scene.deck.walls.size(); ++i) check(scene.deck.walls[i].friction, join_path("walls", i));
  return warnings;
}

std::vector<Warning> check_tie_hinges(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const TieHinge& hinge : scene.ties->hinges) {
    const auto i = static_cast<std::size_t>(hinge.tie);
    const std::string path = join_path("contact.ties", i) + ".rotations";
    if (scene.deck.places.has(path)) continue;  // a hinge is meant
    const TieDeck& tie = scene.deck.contact.ties[i];
    warnings.push_back(
        warn_at(scene.deck, "tie_hinge", path,
                fmt::format("the tie of '{}' and '{}' holds {} nodes of shells in one row, from node {} to node {} "
                            "(without rotations the row is a hinge, about which the shells turn freely): set "
                            "{}: true, or false if a hinge is meant",
                            tie.a.name, tie.b.name, hinge.nodes, hinge.first, hinge.last, path)));
  }
  return warnings;
}

// A tie moves its nodes a with faces b. Nodes of b between those of a belong to none of them: a force comes in at
// single nodes. A bar of two blocks, 4 x 4 elements tied to 6 x 6, has stresses of 0.67 to 1.18 of the mean, to 12 x 12
// of -0.6 to 2.7; with 6 x 6 or 12 x 12 as side a 0.92 to 1.07 and 1.
std::vector<Warning> check_tie_sides(const CheckedScene& scene) {
  constexpr double most = 1.4;  // size of the faces of a over that of b
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.ties->sizes.size(); ++i) {
    const TieSizes& sizes = scene.ties->sizes[i];
    const TieDeck& tie = deck.contact.ties[i];
    const std::vector<std::size_t> parts = find_named_parts(deck, tie.b);
    const auto is_rigid = [&](std::size_t p) { return deck.parts[p].rigid.has_value(); };
    if (sizes.b == 0 || sizes.a <= most * sizes.b || std::all_of(parts.begin(), parts.end(), is_rigid)) continue;
    warnings.push_back(
        warn_at(deck, "tie_sides", join_path("contact.ties", i) + ".a",
                fmt::format("faces of '{}' are {:.2g} times as large as those of '{}' beneath (the tie holds nodes of "
                            "a; those of b between them stay free, and the stress jumps from one to the next): "
                            "exchange a and b, or match their meshes",
                            tie.a.name, sizes.a / sizes.b, tie.b.name)));
  }
  return warnings;
}

// The zone in which a crack spends its energy has the length M E G / S^2, M = 9 pi / 32 (Rice 1979; Turon et al., Eng.
// Fracture Mech. 74, 2007, who ask for three elements in it).
std::vector<Warning> check_glue_zone(const CheckedScene& scene) {
  constexpr double factor = 0.884, least = 3;  // elements
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.ties->sizes.size(); ++i) {
    const TieDeck& tie = scene.deck.contact.ties[i];
    const std::vector<std::size_t> parts =
        tie.cohesive ? find_deforming_sides(scene.deck, tie) : std::vector<std::size_t>{};
    const double size = scene.ties->sizes[i].a;
    if (parts.empty() || !(size > 0)) continue;
    double modulus = std::numeric_limits<double>::infinity();
    for (const std::size_t p : parts)
      modulus = std::min(modulus, find_stiffness(find_material(scene.deck, scene.deck.parts[p])));
    const CohesiveDeck& glue = *tie.cohesive;
    const auto find_zone = [&](double energy, double strength) {
      return factor * modulus * energy / (strength * strength);
    };
    const double zone = std::min(find_zone(glue.normal_energy, glue.normal_strength),
                                 find_zone(glue.shear_energy, glue.shear_strength));
    if (zone >= least * size) continue;
    warnings.push_back(warn_at(
        scene.deck, "glue_zone", join_path("contact.ties", i) + ".cohesive",
        fmt::format("the crack zone of the cohesive tie of '{}' and '{}' is {:.2g} long, {:.2g} elements of '{}' "
                    "(a crack needs 3 to begin at the right load): use smaller elements, or lower the strengths "
                    "and keep the energies",
                    tie.a.name, tie.b.name, zone, zone / size, tie.a.name)));
  }
  return warnings;
}

// Masses by area of rho h / 2 on either side of the stiffness K: the eigenvalue of glue is K times the sum of the
// inverse masses, twice for a regular mesh at most; that of an element 4 c^2 / h^2.
std::vector<Warning> check_glue_step(const CheckedScene& scene) {
  constexpr double least = 0.5;  // share of the step of the elements
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.deck.contact.ties.size(); ++i) {
    const TieDeck& tie = scene.deck.contact.ties[i];
    const std::vector<std::size_t> parts =
        tie.cohesive ? find_deforming_sides(scene.deck, tie) : std::vector<std::size_t>{};
    if (parts.empty()) continue;
    double of_elements = 0, inverse_mass = 0;
    for (const std::size_t p : parts) {
      const MaterialDeck& material = find_material(scene.deck, scene.deck.parts[p]);
      const PartMeasures& measures = scene.measures->parts[p];
      const double h = measures.shell_thickness > 0 ? measures.shell_thickness : measures.shortest_edge;
      inverse_mass = std::max(inverse_mass, (measures.shell_thickness > 0 ? 1 : 2) / (material.density * h));
      of_elements = std::max(of_elements, 4 * std::pow(find_wave_speed(material) / measures.shortest_edge, 2));
    }
    const double stiffness = std::max(tie.cohesive->normal_stiffness,
                                      tie.cohesive->shear_stiffness.value_or(tie.cohesive->normal_stiffness));
    const double of_glue = 2 * inverse_mass * stiffness, share = 1 / std::sqrt(1 + of_glue / of_elements);
    if (share >= least) continue;
    warnings.push_back(warn_at(
        scene.deck, "glue_step", join_path("contact.ties", i) + ".cohesive",
        fmt::format("the glue of '{}' and '{}' lowers the time step to about {:.1g} of that of their elements (its "
                    "stiffness is {:.2g}): a stiffness of {:.2g} costs half of the step at most",
                    tie.a.name, tie.b.name, share, stiffness, stiffness * 3 * of_elements / of_glue)));
  }
  return warnings;
}

std::vector<Warning> check_contact_tolerance(const CheckedScene& scene) {
  constexpr double most = 0.1;  // share of the penetration that a step without contact would have
  const ContactDeck& contact = scene.deck.contact;
  if (!contact.is_iterated() || contact.tolerance <= most) return {};
  return {warn_at(scene.deck, "contact_tolerance", "contact.tolerance",
                  fmt::format("contact.tolerance is {:g} (so much of the penetration of a step may be left; usual is "
                              "1e-3): lower it",
                              contact.tolerance))};
}

std::vector<Warning> check_tie_distance(const CheckedScene& scene) {
  constexpr double most = 1;  // share of the longest edge: shorter ones may lie across a thin layer
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.deck.contact.ties.size(); ++i) {
    const TieDeck& tie = scene.deck.contact.ties[i];
    double edge = 0;
    for (const std::size_t p : find_named_parts(scene.deck, tie.b))
      edge = std::max(edge, scene.measures->parts[p].longest_edge);
    if (!tie.distance || *tie.distance <= most * edge) continue;
    warnings.push_back(warn_at(scene.deck, "tie_distance", join_path("contact.ties", i) + ".distance",
                               fmt::format("the tie distance is {:g}, but the longest element edge there is {:.3g} "
                                           "(nodes away from the surface are tied too): lower the distance",
                                           *tie.distance, edge)));
  }
  return warnings;
}

}  // namespace percuss
