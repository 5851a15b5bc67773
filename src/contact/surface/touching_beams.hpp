#pragma once
// Beams on the contact surface: their nodes touch faces as nodes with thickness do, their axes touch other edges.

#include <array>
#include <string>
#include <vector>

#include "src/contact/surface/feature_edges.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// [parts] radius with which the beams of each part touch; 0: it has none that do. The same on all ranks.
std::vector<double> find_touching_radii(const Mesh& mesh, const Deck& deck);

/// Whether any part has some.
bool has_touching_beams(const Mesh& mesh, const Deck& deck);

/// A line on each part whose beams touch: with which radius, and from where it is.
std::vector<std::string> describe_touching_beams(const Deck& deck, const std::vector<double>& radii);

/// A beam of this rank that touches.
struct TouchingBeam {
  std::array<int, 2> nodes{};  // of the mesh
  int part = 0, body = 0;
  double radius = 0, length = 0;
  double spring = 0;    // stiffness of each of its nodes; 0 without penalty [force/length]
  EdgeTopology edge{};  // its axis, without number and class; all ends as if several beams continued
};

/// The beams of this rank, in the order of the mesh.
std::vector<TouchingBeam> list_touching_beams(const ChunkedMesh& chunked, const Deck& deck, int rank);

/// Marks the ends of beams by their second wings: of a free end the other end of the beam; where just one beam
/// continues, the other end of that; else the end itself. Collective.
void mark_beam_ends(const Numbering& numbering, const Communicator& ranks, std::vector<FoundEdge>& beams);

}  // namespace percuss
