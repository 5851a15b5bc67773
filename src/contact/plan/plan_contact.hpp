#pragma once
// Predicts on one process the contact decomposition over many ranks at the starting positions: the owners of contact
// nodes and faces, the number of ghost faces, and the messages.
//
// The points and cuts are those of a run (comm/partition/bisect_points.hpp), with capture boxes of the same width.
// Messages follow from the candidate pairs of the start. Every node with candidates counts as touching the nearest of
// its candidate faces. This is more than a scene of separate bodies sends, and about right for bodies face to face.

#include <cstdint>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/partition/bisect_points.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// What one rank would own and send for contact.
struct ContactRankPlan {
  std::int64_t nodes = 0, faces = 0;  // searched nodes and centres of searched faces that it owns
  std::int64_t faces_here = 0;        // faces whose capture boxes reach it
  Traffic telling;                    // sent when ranks learn which nodes and faces they look after
  Traffic search;                     // sent in each search
  Traffic step;                       // sent in each step, besides
  Traffic pass;                       // sent in each pass of the enforcement, of which an iteration is one
  std::int64_t points() const { return nodes + faces; }
};

struct ContactPlan {
  std::vector<ContactRankPlan> ranks;
  std::int64_t ghost_faces = 0;  // copies of faces beyond one each, of all ranks
};

/// The contact surface of a scene and its candidate pairs at the start: made once, for plans of any number of ranks.
class ContactPlanner {
 public:
  /// whole: the mesh on one rank; outlives this. Throws InputError for unknown surfaces, RunError if candidate pairs
  /// are absurdly many.
  ContactPlanner(const ChunkedMesh& whole, const Deck& deck);

  std::int64_t nodes() const { return share_.total_nodes; }  // contact nodes
  std::int64_t faces() const { return share_.total_faces; }  // contact faces
  std::int64_t points() const { return static_cast<std::int64_t>(points_.size()); }

  /// chunk_ranks: [chunks] the rank of each in the FE decomposition.
  ContactPlan plan(const std::vector<int>& chunk_ranks, int rank_count) const;

 private:
  struct Places;
  struct Reach;
  struct Visit;

  void find_boxes(bool reuse_search);
  void find_pairs(const Boxes& boxes, double margin);
  void locate_points();
  int find_nearest_candidate(int node) const;
  int find_point_rank(const Places& places, std::size_t point) const;
  template <class Call>
  void visit_ranks(const Places& places, std::size_t face, double wider, const Call& call) const;
  Places divide(const std::vector<int>& chunk_ranks, int rank_count) const;
  void plan_search(const Places& places, ContactPlan& plan) const;
  void plan_telling(const Places& places, ContactPlan& plan) const;
  void plan_check(const Places& places, ContactPlan& plan) const;
  void plan_enforcement(const Places& places, ContactPlan& plan) const;

  const ChunkedMesh& whole_;
  UnstructuredExchange exchange_;
  const SurfaceShare share_;
  Rows3<double> x_;                           // [mesh nodes] at the start
  std::vector<int> contact_nodes_;            // [mesh nodes] place among the contact nodes, -1: none
  std::vector<PlacedPoint> points_;           // searched nodes, then centres of searched faces
  std::vector<int> searched_nodes_;           // places among the contact nodes
  std::vector<std::array<double, 6>> boxes_;  // [searched faces] lowest x, y, z, highest x, y, z
  double margin_ = 0;                         // that these are wider than they must be [length]
  std::vector<int> first_pair_, pair_face_;   // [contact nodes + 1], [pairs] places in SurfaceShare::faces
};

}  // namespace percuss
