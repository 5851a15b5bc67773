#pragma once
// The feature edges of the contact surface: where two faces of a body meet at a convex angle at the start of the run,
// where a shell ends, and where two shells meet at an angle. Beams that touch are edges without faces.

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "comm/exchange/unstructured_exchange.hpp"
#include "kernels/contact/surface/edge_surface.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

struct SurfaceShare;

/// A feature edge in messages between ranks.
struct EdgeTopology {
  std::int64_t number = -1;    // 128 * number of its lower node + place among that node's edges
  std::int64_t ends[2]{};      // node numbers, ascending
  std::int64_t wings[4]{};     // corners of the first face, then of the second, next to end 0 and next to end 1; of a
                               // beam its ends, then mark_beam_ends()
  std::int64_t elements[2]{};  // numbers of the elements behind the faces
  int surface_class = 0;       // which of the named surfaces it lies on, as a class
  int home = 0;                // rank that has the first face's element: it remembers the edge's contacts
  int pieces = 1;              // that search sees, each as a point
  double offset = 0;           // half the thickness of its shells, radius of a beam, 0 of solids [length]
  int is_blunt = 0;            // EdgeSurface::is_blunt
  EdgeScale scale{};           // by which features pass between the nodes of lines (is_blunt 2), and across ridges (3)
};

/// An edge of the surface by the numbers of its nodes.
struct EdgeEnds {
  std::int64_t lower = -1, upper = -1;

  auto operator<=>(const EdgeEnds&) const = default;
};

/// An edge before its class is known.
struct FoundEdge {
  EdgeTopology edge;
  int face_classes[2] = {0, 0};  // FaceTopology::surface_class of its faces
  int part = 0;                  // of the first
  double length = 0;             // at time 0
};

/// The feature edges whose home this rank is, ascending in number, with the blunt ones, and with the lines of smooth
/// surfaces between whose nodes a longer feature edge of another part can pass, with the ridges across faces that have
/// warped, and with beams that touch. share: with its faces and beams; folds: edges that have become sharp in the run,
/// and diagonals of warped faces, of all ranks, ascending; passing: by part, the longest feature edge of any other
/// part, 0 where none can pass between the nodes of the part; found where it is empty, the same as long as the faces
/// are. Throws InputError, on all ranks, if more than 128 edges have the same lower node. Collective.
std::vector<FoundEdge> find_feature_edges(const ChunkedMesh& chunked, const SurfaceShare& share,
                                          UnstructuredExchange& exchange, const std::vector<EdgeEnds>& folds,
                                          std::vector<double>& passing);

/// Number of pieces of at most this length into which an edge is divided.
int count_pieces(double length, double piece);

/// Divides edges into pieces of at most 1.25 times the mean length of all ranks' edges that are no lines of smooth
/// surfaces (and 2.5 times that of all), which it returns. lengths: [edges]. Collective.
double divide_edges(const Communicator& ranks, const std::vector<double>& lengths, std::vector<EdgeTopology>& edges);

}  // namespace percuss
