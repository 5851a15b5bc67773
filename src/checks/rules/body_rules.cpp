// Masses, rigid bodies and cross sections that do not fit the parts that have them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "src/checks/rules.hpp"
#include "src/checks/unit_systems.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// All parts of a rigid body together.
struct BodyMeasures {
  Vec3 low{}, high{};
  double mass = 0;

  double size() const { return find_distance(low, high); }
};

const std::string& name_body(const PartDeck& part) { return part.rigid->body.empty() ? part.name : part.rigid->body; }

BodyMeasures measure_body(const CheckedScene& scene, const std::string& name) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BodyMeasures body{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    if (!scene.deck.parts[p].rigid || name_body(scene.deck.parts[p]) != name) continue;
    const PartMeasures& part = scene.measures->parts[p];
    for (std::size_t k = 0; k < 3; ++k) {
      body.low[k] = std::min(body.low[k], part.low[k]);
      body.high[k] = std::max(body.high[k], part.high[k]);
    }
    body.mass += part.mass;
  }
  return body;
}

/// Distance of a place from the box of a body.
double find_distance(const Vec3& place, const BodyMeasures& body) {
  Vec3 out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = std::max({body.low[k] - place[k], place[k] - body.high[k], 0.0});
  return std::sqrt(dot(out, out));
}

/// The longest dimension that the constants of a cross section stand for: the edge of a square of this area, and of
/// squares of these moments of inertia over the area.
double find_section_size(const BeamSection& section) {
  const double inertia = std::max(section.inertia_y, section.inertia_z);
  return std::max(std::sqrt(section.area), std::sqrt(12 * inertia / section.area));
}

/// Whether a section is thinner than a hair in all units that the deck can be meant in, and far thinner than its beams
/// are long: that of a strut in metres beside lengths in millimetres, and no wire.
bool is_hair(const CheckedScene& scene, double size, const PartMeasures& part) {
  constexpr double hair = 3e-4;                        // [m] its largest size in SI ...
  constexpr double slender = 3e-4, of_element = 0.01;  // ... its shares of the part and of an element
  if (size > slender * part.extent() || size > of_element * part.longest_edge) return false;
  const std::vector<Units> systems = find_meant_units(scene.deck);
  return !systems.empty() && std::all_of(systems.begin(), systems.end(), [&](const Units& units) {
    return size * units.in_si(dimensions::length) < hair;
  });
}

/// The softest of the parts that an end of a weld may name [pressure].
double find_least_modulus(const Deck& deck, const WeldDeck& weld) {
  double least = std::numeric_limits<double>::infinity();
  for (const SpringEndDeck& end : weld.between) {
    for (const std::size_t p : find_named_parts(deck, end.where)) {
      const LameConstants c = find_moduli(find_material(deck, deck.parts[p]));
      if (c.mu > 0) least = std::min(least, c.mu * (3 * c.lambda + 2 * c.mu) / (c.lambda + c.mu));
    }
  }
  return least;
}

}  // namespace

std::vector<Warning> check_added_mass(const CheckedScene& scene) {
  constexpr double most = 1000 * (1 - 1e-9);  // a car on its crash tube has some 500 times the mass of the tube
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < scene.deck.added_masses.size(); ++i) {
    const AddedMassDeck& added = scene.deck.added_masses[i];
    double mass = 0;
    for (const std::size_t p : find_named_parts(scene.deck, added.where)) mass += scene.measures->parts[p].mass;
    if (added.mass < most * mass) continue;
    warnings.push_back(warn_at(scene.deck, "added_mass", join_path("added_mass", i) + ".mass",
                               fmt::format("the added mass {:g} is {:.4g} times the mass {:.3g} of the parts that get "
                                           "it (tonnes beside kilograms are 1000 times): check its unit",
                                           added.mass, added.mass / mass, mass)));
  }
  return warnings;
}

std::vector<Warning> check_rigid_mass(const CheckedScene& scene) {
  // A body may stand for one that is far larger than its mesh: a car, a drop tower. It is hardly ever lighter.
  constexpr double most = 1000 * (1 - 1e-9), least = 0.01;
  std::vector<Warning> warnings;
  for (const PartDeck& part : scene.deck.parts) {
    if (!part.rigid || !part.rigid->mass) continue;
    const double mass = *part.rigid->mass, own = measure_body(scene, name_body(part)).mass;
    if (mass < most * own && mass > least * own) continue;
    warnings.push_back(warn_at(scene.deck, "rigid_mass", "parts." + part.name + ".rigid.mass",
                               fmt::format("rigid.mass of part '{}' is {:g}, but its elements have a mass of {:.3g} by "
                                           "their density ({:.2g} times as much; kilograms and tonnes differ by 1000): "
                                           "check its unit, or leave it out",
                                           part.name, mass, own, mass / own)));
  }
  return warnings;
}

std::vector<Warning> check_rigid_inertia(const CheckedScene& scene) {
  constexpr double most_away = 10;           // sizes of the body: what it stands for may be larger than its mesh
  constexpr double least = 0.02, most = 10;  // radius of gyration over the size; a ball has 0.18
  std::vector<Warning> warnings;
  for (const PartDeck& part : scene.deck.parts) {
    if (!part.rigid) continue;
    const BodyMeasures body = measure_body(scene, name_body(part));
    const std::string path = "parts." + part.name + ".rigid.";
    if (part.rigid->center) {
      const double away = find_distance(*part.rigid->center, body);
      if (away > most_away * body.size())
        warnings.push_back(
            warn_at(scene.deck, "rigid_inertia", path + "center",
                    fmt::format("the centre of mass of rigid part '{}' is {:.3g} away from the body, which "
                                "is {:.3g} long (it turns about that point): check its unit",
                                part.name, away, body.size())));
    }
    if (!part.rigid->inertia) continue;
    const auto& inertia = *part.rigid->inertia;
    const double mass = part.rigid->mass.value_or(body.mass);
    const double radius = std::sqrt(std::max({inertia[0], inertia[1], inertia[2]}) / mass);
    if (radius >= least * body.size() && radius <= most * body.size()) continue;
    warnings.push_back(
        warn_at(scene.deck, "rigid_inertia", path + "inertia",
                fmt::format("the inertia of rigid part '{}' is that of its mass {:.3g} at a radius of {:.3g} (the body "
                            "is {:.3g} long): check its unit, mass length^2",
                            part.name, mass, radius, body.size())));
  }
  return warnings;
}

std::vector<Warning> check_beam_section(const CheckedScene& scene) {
  constexpr double most = 1, least = 1e-5;  // share of the longest edge of the part's box
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    if (!part.section) continue;
    const double size = find_section_size(make_beam_section(*part.section)), length = scene.measures->parts[p].extent();
    const bool is_fit = size <= most * length && size >= least * length;
    if (is_fit && !is_hair(scene, size, scene.measures->parts[p])) continue;
    warnings.push_back(warn_at(scene.deck, "beam_section", "parts." + part.name + ".section",
                               fmt::format("the section of part '{}' is about {:.2g} across, its beams reach over "
                                           "{:.3g} (beams are slender, and thicker than a hair): check its unit",
                                           part.name, size, length)));
  }
  return warnings;
}

// Saint-Venant's torsion constant is the least integral of the squares of both shear strains over all warpings. The
// warping c y z gives (1 - c)^2 I_y + (1 + c)^2 I_z, whose least is 4 I_y I_z / (I_y + I_z): that of an ellipse.
std::vector<Warning> check_section_torsion(const CheckedScene& scene) {
  constexpr double most = 1.02;  // share of the bound: rounded tables
  std::vector<Warning> warnings;
  for (const PartDeck& part : scene.deck.parts) {
    const auto* section = part.section ? std::get_if<BeamSection>(&*part.section) : nullptr;
    if (section == nullptr) continue;
    const double bound = 4 * section->inertia_y * section->inertia_z / (section->inertia_y + section->inertia_z);
    if (section->torsion <= most * bound) continue;
    warnings.push_back(warn_at(
        scene.deck, "section_torsion", "parts." + part.name + ".section.general.torsion",
        fmt::format("the torsion constant {:g} of part '{}' is above 4 Iy Iz / (Iy + Iz) = {:.4g} (no section has "
                    "more; the polar moment of area is that of round ones alone): give Saint-Venant's constant",
                    section->torsion, part.name, bound)));
  }
  return warnings;
}

std::vector<Warning> check_weld_strength(const CheckedScene& scene) {
  constexpr double least = 1e-5, most = 0.1;  // share of Young's modulus; spot welds of metals have 0.001 to 0.005
  std::vector<Warning> warnings;
  for (const WeldDeck& weld : scene.deck.welds) {
    if (!weld.radius) continue;
    const double modulus = find_least_modulus(scene.deck, weld);
    const double area = std::numbers::pi * *weld.radius * *weld.radius;
    for (const auto& [key, strength] : {std::pair("normal", weld.normal_strength), {"shear", weld.shear_strength}}) {
      if (!strength || !std::isfinite(modulus)) continue;
      const double share = *strength / (area * modulus);
      if (share >= least && share <= most) continue;
      warnings.push_back(warn_at(scene.deck, "weld_strength", "welds." + weld.name + ".failure." + key,
                                 fmt::format("the {} strength {:g} of weld '{}' is {:.1e} of Young's modulus on its "
                                             "disc (spot welds of metals have 0.001 to 0.005): check its unit, force",
                                             key, *strength, weld.name, share)));
    }
  }
  return warnings;
}

std::vector<Warning> check_shell_reference(const CheckedScene& scene) {
  constexpr double most = 10;  // thicknesses: stacked sheets are a few apart
  std::vector<Warning> warnings;
  for (const PartDeck& part : scene.deck.parts) {
    if (!part.thickness || std::abs(part.offset) <= most * *part.thickness) continue;
    warnings.push_back(warn_at(scene.deck, "shell_reference", "parts." + part.name + ".reference",
                               fmt::format("the mesh of part '{}' is {:g} off the middle of its shells, {:.3g} times "
                                           "their thickness (they bend as stiff as that lever makes them): check its "
                                           "unit",
                                           part.name, std::abs(part.offset), std::abs(part.offset) / *part.thickness)));
  }
  return warnings;
}

}  // namespace percuss
