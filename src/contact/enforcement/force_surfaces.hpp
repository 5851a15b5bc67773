#pragma once
// The named surfaces among the sides of forces of contact: which of them each side of a row lies on.
//
// A row counts for one face on each side. Of a face that is touched, it is this face. Of a node, or of an edge, it is
// that of the faces around it that looks most against the push, of equals the one of the lowest number. So surfaces
// that share nodes share no force: what surfaces that make up a part get is what the part gets.

#include <optional>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/unstructured_exchange.hpp"
#include "src/contact/enforcement/node_areas.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Whether a side of a force is no whole part.
bool is_surface(const Deck& deck, const Selector& side);

/// The faces of named surfaces, of a contact surface until it is redefined.
class ForceSurfaces {
 public:
  /// forces: those of contact and walls. share outlives this. Throws InputError, on all ranks, for unknown surfaces.
  /// Collective, as are all calls.
  ForceSurfaces(const ContactRanks& ranks, const ChunkedMesh& chunked, const Deck& deck, const SurfaceShare& share,
                const std::vector<ForceDeck>& forces);

  /// Sides of this rank's rows, which are solved. x: [mesh nodes] positions at n, node_numbers: [mesh nodes].
  Array<const RowSurfaces> find(const RowSystem& system, const Array<const std::int64_t>& node_numbers,
                                const Rows3<const double>& x);

  /// [parts] the forces whose first side has faces of the part, on any rank: bit f.
  const std::vector<std::uint32_t>& parts() const { return parts_; }

 private:
  /// A side of a row, to be looked up where it is known.
  struct Query {
    std::int64_t face = -1;               // number of the face; -1: to be chosen
    std::int64_t node = -1, second = -1;  // among the faces around this node that have the second one, too, if any
    double push[3] = {0, 0, 0};           // direction in which it is pushed
    int row = 0, is_pushing = 0;
  };

  void mark_faces(const ChunkedMesh& chunked, const Deck& deck, const std::vector<ForceDeck>& forces);
  void add_queries(const RowSystem& system, const Array<const std::int64_t>& node_numbers);
  void ask_others(std::vector<RowSurfaces>& found);
  int find_owner(const Query& query) const;
  SideBits answer(const Query& query) const;
  SideBits answer_node(const Query& query, int node) const;

  const Numbering& numbering_;
  const SurfaceShare& share_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  NodeAreas areas_;
  std::vector<SideBits> faces_;  // [faces of the share, foreign faces]
  std::vector<std::uint32_t> parts_;
  std::vector<Query> queries_;
};

}  // namespace percuss
