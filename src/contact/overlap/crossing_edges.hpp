#pragma once
// The edges that go through faces where parts cross at the start, and which of them are meant to.

#include <vector>

#include "src/contact/overlap/pierced_faces.hpp"
#include "src/contact/overlap/start_crossings.hpp"

namespace percuss {

struct CrossingEdge {
  PiercingEdge piercing;
  PartCrossing::Contact contact = PartCrossing::Contact::never;
  bool is_held = false;  // a tie, a constraint or a solid around it holds what goes through what
};

/// Kinds of elements of the parts.
struct PartKinds {
  std::vector<char> solid;        // [parts]
  std::vector<double> thickness;  // [parts] least of its shells, 0: it has none [length]

  bool is_solid(int part) const { return solid[static_cast<std::size_t>(part)] != 0; }
  bool has_faces(int part) const { return is_solid(part) || thickness[static_cast<std::size_t>(part)] > 0; }
};

PartKinds find_part_kinds(const Mesh& mesh);

/// All beams of this rank, whether they touch or not.
std::vector<TravellingEdge> list_beams(const CrossingScene& scene, const HostPlaces& x);

/// Crossing edges by ends and body, the same on all ranks. Collective.
std::vector<CrossingEdge> find_crossing_edges(const CrossingScene& scene, const Rows3<const double>& x,
                                              const std::vector<TravellingEdge>& beams);

}  // namespace percuss
