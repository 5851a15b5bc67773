#include "src/contact/surface/touching_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <tuple>

#include "comm/exchange/item_exchange.hpp"
#include "src/deck/embedded_parts.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// An end of a beam on its way to the owner of its node, and back with what is there.
struct BeamEnd {
  std::int64_t node = 0, other = 0;  // it, and the other end of the beam
  std::int64_t wing = 0;             // EdgeTopology::wings
  int rank = 0;
};

bool is_before_end(const BeamEnd& a, const BeamEnd& b) {
  return std::tie(a.node, a.other, a.rank) < std::tie(b.node, b.other, b.rank);
}

/// Whether beams of a part touch: all where all surfaces do, else those of parts that a pair names; none in solids.
bool may_touch(const Mesh& mesh, const Deck& deck, const std::string& part) {
  const ContactDeck& contact = deck.contact;
  if (is_embedded(deck, part)) return false;
  if (contact.surfaces == ContactDeck::Surfaces::all) return contact.beams;
  const auto means = [&](const Selector& side) {
    if (side.inside || (!side.name.empty() && side.name != part)) return false;
    return contact.beams || names_beams_alone(mesh, side);
  };
  return std::any_of(contact.pairs.begin(), contact.pairs.end(),
                     [&](const SurfacePairDeck& pair) { return means(pair.a) || means(pair.b); });
}

/// E L / 2: a bar that is pressed from the side resists about as a layer of its own thickness.
double find_beam_spring(const MaterialDeck& material, double length) {
  const LameConstants moduli = find_moduli(material);
  const double youngs = moduli.mu * (3 * moduli.lambda + 2 * moduli.mu) / (moduli.lambda + moduli.mu);
  return 0.5 * youngs * length;
}

}  // namespace

std::vector<double> find_touching_radii(const Mesh& mesh, const Deck& deck) {
  std::vector<double> radii(mesh.parts.size(), 0);
  if (deck.contact.surfaces == ContactDeck::Surfaces::none) return radii;
  for (const ElementBlock& block : mesh.elements.blocks) {  // the same on all ranks
    const PartDeck& part = deck.parts[at(block.part)];
    if (!find_topology(block.topology).is_line() || !part.section || !may_touch(mesh, deck, part.name)) continue;
    radii[at(block.part)] = part.contact_radius.value_or(find_contact_radius(*part.section));
  }
  return radii;
}

bool has_touching_beams(const Mesh& mesh, const Deck& deck) {
  const std::vector<double> radii = find_touching_radii(mesh, deck);
  return std::any_of(radii.begin(), radii.end(), [](double radius) { return radius > 0; });
}

std::vector<std::string> describe_touching_beams(const Deck& deck, const std::vector<double>& radii) {
  std::vector<std::string> lines;
  for (std::size_t p = 0; p < radii.size(); ++p) {
    if (radii[p] == 0) continue;
    const PartDeck& part = deck.parts[p];
    const bool is_round =
        std::holds_alternative<RoundSection>(*part.section) || std::holds_alternative<TubeSection>(*part.section);
    const char* const from = part.contact_radius ? "contact_radius"
                             : is_round          ? "that of the section"
                                                 : "the circle with the area of the section";
    lines.push_back(fmt::format("beams of part '{}' touch with radius {:.4g} ({})", part.name, radii[p], from));
  }
  return lines;
}

std::vector<TouchingBeam> list_touching_beams(const ChunkedMesh& chunked, const Deck& deck, int rank) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<double> radii = find_touching_radii(mesh, deck);
  std::vector<TouchingBeam> beams;
  const std::vector<std::int64_t> numbers = list_element_numbers(chunked);
  const bool has_springs = deck.contact.enforcement == ContactDeck::Enforcement::penalty;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double radius = radii[at(mesh.part_of(e))];
    if (radius == 0 || !mesh.topology_of(e).is_line()) continue;
    if (!mesh.eroded.dead.empty() && mesh.eroded.dead[e] != 0) continue;
    const std::span<const int> corners = mesh.corners(e);
    TouchingBeam beam{{corners[0], corners[1]}, mesh.part_of(e), mesh.bodies[e], radius};
    beam.length = find_distance(mesh.nodes[at(corners[0])], mesh.nodes[at(corners[1])]);
    if (has_springs) beam.spring = find_beam_spring(deck.materials[at(mesh.block_of(e).material)], beam.length);
    EdgeTopology& edge = beam.edge;
    for (std::size_t i = 0; i < 2; ++i) edge.ends[i] = mesh.node_numbers[at(corners[i])];
    if (edge.ends[1] < edge.ends[0]) std::swap(edge.ends[0], edge.ends[1]);
    for (std::size_t i = 0; i < 4; ++i) edge.wings[i] = edge.ends[i % 2];
    edge.elements[0] = edge.elements[1] = numbers[e];
    edge.home = rank;
    edge.offset = radius;
    beams.push_back(beam);
  }
  return beams;
}

void mark_beam_ends(const Numbering& numbering, const Communicator& ranks, std::vector<FoundEdge>& beams) {
  std::vector<BeamEnd> sent;
  std::vector<int> to;
  for (const FoundEdge& beam : beams) {
    const auto& ends = beam.edge.ends;
    for (std::size_t i = 0; i < 2; ++i) {
      sent.push_back({ends[i], ends[1 - i], ends[i], ranks.rank()});
      to.push_back(numbering.find_node_owner(ends[i]));
    }
  }
  std::vector<BeamEnd> ends = ItemExchange(ranks).send(to, sent);
  std::sort(ends.begin(), ends.end(), is_before_end);
  sent.clear();
  to.clear();
  for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
    while (last < ends.size() && ends[last].node == ends[first].node) ++last;
    if (last - first > 2) continue;
    for (std::size_t i = first; i < last; ++i) {
      ends[i].wing = ends[last - first == 1 ? i : first + last - 1 - i].other;
      // Two beams between the same nodes end there like several.
      if (last - first == 2 && ends[i].wing == ends[i].other) ends[i].wing = ends[i].node;
      sent.push_back(ends[i]);
      to.push_back(ends[i].rank);
    }
  }
  std::vector<BeamEnd> marked = ItemExchange(ranks).send(to, sent);
  std::sort(marked.begin(), marked.end(), is_before_end);
  for (FoundEdge& beam : beams) {
    EdgeTopology& edge = beam.edge;
    for (std::size_t i = 0; i < 2; ++i) {
      const BeamEnd end{edge.ends[i], edge.ends[1 - i], 0, ranks.rank()};
      const auto found = std::lower_bound(marked.begin(), marked.end(), end, is_before_end);
      if (found != marked.end() && !is_before_end(end, *found)) edge.wings[2 + i] = found->wing;
    }
  }
}

}  // namespace percuss
