#include "src/step/loads/blast_pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comm/first_finding.hpp"
#include "src/deck/units.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/loads/blast_wave.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

constexpr double kilo = 1e3;  // Pa in kPa, ms in s

/// Middle and outward normal of a face at time 0.
struct FacePlace {
  Vec3 middle{}, normal{};
};

FacePlace find_place(const Mesh& mesh, const ElementFace& face) {
  const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
  FacePlace place;
  ElementCorners corner{};
  double count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    corner[i] = mesh.nodes[at(nodes[i])];
    if (nodes[i] == nodes[(i + 1) % 4]) continue;  // a triangle has one twice
    for (std::size_t k = 0; k < 3; ++k) place.middle[k] += corner[i][k];
    count += 1;
  }
  for (double& component : place.middle) component /= count;
  const Vec3 area = find_shell_area(corner);
  const double size = find_shell_area_size(corner);
  for (std::size_t k = 0; k < 3 && size > 0; ++k) place.normal[k] = area[k] / size;
  return place;
}

/// Distance in m over the cube root of the charge in kg.
double find_scaled_distance(const BlastDeck& blast, const Units& units, const Vec3& middle) {
  return units.length.in_si * find_distance(middle, blast.center) / std::cbrt(units.mass.in_si * blast.charge);
}

}  // namespace

Pulse find_blast_pulse(const BlastDeck& blast, const Units& units, const Vec3& middle, const Vec3& normal) {
  const Vec3 ray = subtract(middle, blast.center);
  const double distance = find_distance(middle, blast.center), cosine = std::max(0.0, -dot(normal, ray) / distance);
  const BlastWave wave = find_blast_wave(units.mass.in_si * blast.charge, units.length.in_si * distance, blast.burst);
  const double pressure = kilo / units.in_si(dimensions::stress), time = 1 / (kilo * units.time.in_si);
  const double of_reflected = cosine * cosine, of_incident = 1 + of_reflected - 2 * cosine;
  return {blast.time + wave.arrival * time,
          wave.duration * time,
          {pressure * of_reflected * wave.reflected, pressure * of_incident * wave.incident},
          {find_decay(wave.reflected, wave.duration, wave.reflected_impulse),
           find_decay(wave.incident, wave.duration, wave.incident_impulse)},
          blast.has_negative_phase};
}

void require_blast_range(const Deck& deck, const PressureDeck& load, const ChunkedMesh& chunked,
                         const std::vector<ElementFace>& faces) {
  const Units units = *find_units(deck.units);
  const BlastRange range = find_blast_range(load.blast->burst);
  std::int64_t first = no_finding;
  std::string text;
  for (const ElementFace& face : faces) {
    const double z = find_scaled_distance(*load.blast, units, find_place(chunked.mesh, face).middle);
    const std::int64_t number = find_element_number(chunked, face.element);
    if ((z >= range.least && z <= range.largest) || number >= first) continue;
    first = number;
    text = fmt::format(
        "{} is at a scaled distance of {:.3g} m/kg^(1/3) from the charge (the curves reach from {:g} to "
        "{:g}): move the charge, or select other faces",
        name_element(chunked.mesh, face.element), z, range.least, range.largest);
  }
  if (const auto refused = agree_on_first(find_ranks(chunked.mesh), first, text))
    throw InputError(fmt::format("{}: error: {}", deck.where(load.where.place), *refused));
}

std::vector<Pulse> list_blast_pulses(const Deck& deck, const PressureDeck& load, const Mesh& mesh,
                                     const std::vector<ElementFace>& faces) {
  const Units units = *find_units(deck.units);
  std::vector<Pulse> pulses;
  for (const ElementFace& face : faces) {
    const FacePlace place = find_place(mesh, face);
    pulses.push_back(find_blast_pulse(*load.blast, units, place.middle, place.normal));
  }
  return pulses;
}

}  // namespace percuss
