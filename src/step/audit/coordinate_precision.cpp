#include "src/step/audit/coordinate_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Strains that are nothing but round-off from here on leave no result.
constexpr double largest_spacing = 1e-3;

/// Contact takes depths below depth_tolerance of the largest coordinate for round-off, and tells nodes from faces by
/// new_band of the face: with this spacing of doubles over the edge the two are equal.
constexpr double largest_spacing_of_contact = epsilon * contact_limits::new_band / contact_limits::depth_tolerance;

struct WorstElement {
  double spacing = 0;        // over its shortest edge
  double coordinate = 0;     // the largest that counts for it
  std::int64_t number = -1;  // in the whole mesh
  int part = 0;
};

bool has_contact(const Deck& deck) {
  return deck.contact.surfaces != ContactDeck::Surfaces::none || !deck.contact.ties.empty() || !deck.walls.empty();
}

double find_shortest_edge(const Mesh& mesh, std::size_t e) {
  const std::span<const int> corners = mesh.corners(e);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : mesh.topology_of(e).edges()) {
    const int from = corners[static_cast<std::size_t>(a)], to = corners[static_cast<std::size_t>(b)];
    const Vec3 edge = subtract(mesh.nodes[static_cast<std::size_t>(to)], mesh.nodes[static_cast<std::size_t>(from)]);
    shortest = std::min(shortest, dot(edge, edge));
  }
  return std::sqrt(shortest);
}

double find_largest_coordinate(const Mesh& mesh, std::size_t e) {
  double largest = 0;
  for (const int corner : mesh.corners(e)) {
    for (const double x : mesh.nodes[static_cast<std::size_t>(corner)]) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// Worst element of this rank. Contact measures everything by the largest coordinate of the scene.
WorstElement find_own_worst(const ChunkedMesh& chunked, bool in_contact) {
  const Mesh& mesh = chunked.mesh;
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) farthest = std::max({farthest, std::abs(mesh.low[k]), std::abs(mesh.high[k])});
  WorstElement worst;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double coordinate = in_contact ? farthest : find_largest_coordinate(mesh, e);
    const double spacing = epsilon * coordinate / find_shortest_edge(mesh, e);
    if (spacing <= worst.spacing) continue;
    worst = {spacing, coordinate, find_element_number(chunked, static_cast<int>(e)), mesh.part_of(e)};
  }
  return worst;
}

/// Worst element of all ranks; of equals the one with the lowest number.
WorstElement find_worst(const ChunkedMesh& chunked, bool in_contact) {
  const Communicator ranks = find_ranks(chunked.mesh);
  WorstElement own = find_own_worst(chunked, in_contact);
  double largest = own.spacing;
  all_reduce(ranks, Reduce::largest, largest);
  std::int64_t number =
      own.spacing == largest && own.number >= 0 ? own.number : std::numeric_limits<std::int64_t>::max();
  all_reduce(ranks, Reduce::least, number);
  double figures[2] = {own.number == number ? own.coordinate : 0, own.number == number ? double(own.part) : 0};
  all_reduce(ranks, Reduce::largest, figures);
  return {largest, figures[0], number, static_cast<int>(figures[1])};
}

std::string name_there(const ChunkedMesh& chunked, std::int64_t number) {
  const int element = find_local_element(chunked, number);
  return broadcast_text(find_ranks(chunked.mesh), element < 0 ? "" : name_element(chunked.mesh, element),
                        chunked.numbering.find_element_owner(number));
}

}  // namespace

std::vector<Warning> check_coordinate_precision(const Deck& deck, const ChunkedMesh& chunked) {
  const bool in_contact = has_contact(deck);
  const WorstElement worst = find_worst(chunked, in_contact);
  if (worst.spacing <= noted_spacing) return {};
  const std::string element = name_there(chunked, worst.number);
  const double limit = in_contact ? largest_spacing_of_contact : largest_spacing;
  const std::string problem = fmt::format(
      "at coordinates as large as {:.6g} the resolution of double precision is {:.2g} of the shortest edge of {}",
      worst.coordinate, worst.spacing, element);
  const char* const remedy = "move the scene to the origin with `at` of its parts (this also moves meshes from files)";
  const std::string place = deck.where(deck.parts.at(static_cast<std::size_t>(worst.part)).place);
  if (worst.spacing > limit) {
    throw InputError(fmt::format("{}: error: {} ({} needs {:.2g}): {}", place, problem,
                                 in_contact ? "contact" : "a run", limit, remedy));
  }
  return {
      {"coordinate_precision", fmt::format("{} (strains below that are round-off): {}", problem, remedy), place, 0, 1}};
}

}  // namespace percuss
