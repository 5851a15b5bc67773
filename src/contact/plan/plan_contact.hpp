#pragma once
// Predicts on one process the contact decomposition over many ranks at the starting positions: the owners of contact
// nodes and faces, the number of ghost faces, and the messages.
//
// The points and cuts are those of a run (comm/partition/bisect_points.hpp), with capture boxes of the same width.
// Messages follow from what a search and a check find at the start: pairs that are near, and contacts.

#include <cstdint>
#include <vector>

#include "comm/partition/bisect_points.hpp"
#include "src/contact/plan/start_pairs.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Messages of a rank and their bytes, of a step a mean.
struct PlannedTraffic {
  double messages = 0, bytes = 0;
};

/// Contact nodes, faces and messages of one planned rank.
struct ContactRankPlan {
  std::int64_t nodes = 0, faces = 0;  // searched nodes and centres of searched faces that it owns
  std::int64_t faces_here = 0;        // faces whose capture boxes reach it
  std::int64_t contacts = 0;          // rows that it solves
  PlannedTraffic telling;             // sent when ranks learn which nodes and faces they look after
  PlannedTraffic search;              // sent in each search
  PlannedTraffic step;                // sent in each step, besides
  PlannedTraffic pass;                // sent in each pass of the enforcement, of which an iteration is one
  bool is_touched = false;            // whether it has contacts or nodes that those of others touch
  std::int64_t points() const { return nodes + faces; }
};

struct ContactPlan {
  std::vector<ContactRankPlan> ranks;
  std::int64_t ghost_faces = 0;  // copies of faces beyond one each, of all ranks
};

/// The contacts between bodies that a plan takes to be there.
enum class PlannedTouches {
  start,  // contacts that a check finds at the start
  near    // each node touches the nearest of its candidate faces
};

/// Scene of a plan.
struct ContactScene {
  SurfaceMotion motion;         // of the mesh nodes at the start
  double steps_per_search = 1;  // until candidate pairs are searched again
  PlannedTouches touches = PlannedTouches::start;
};

/// The contact surface of a scene and its pairs at the start: made once, for plans of any number of ranks.
class ContactPlanner {
 public:
  /// whole: the mesh on one rank; outlives this. Throws InputError for unknown surfaces, RunError if candidate pairs
  /// are absurdly many.
  ContactPlanner(const ChunkedMesh& whole, const Deck& deck, const ContactScene& scene);

  std::int64_t nodes() const { return share_.total_nodes; }  // contact nodes
  std::int64_t faces() const { return share_.total_faces; }  // contact faces
  std::int64_t points() const { return static_cast<std::int64_t>(points_.size()); }
  /// Contacts that the plan counts: rows of nodes and faces, of edges, of ties and of walls.
  std::int64_t contacts() const { return static_cast<std::int64_t>(rows_.size()); }

  /// chunk_ranks: [chunks] the rank of each in the FE decomposition.
  ContactPlan plan(const std::vector<int>& chunk_ranks, int rank_count) const;

 private:
  struct Places;
  struct Reach;
  struct Visit;
  struct EdgeTree;
  struct Named;

  /// A row of the enforcement: the nodes that it moves, and by which its rank is known.
  struct Row {
    std::array<int, 5> nodes{-1, -1, -1, -1, -1};  // mesh nodes; of edges four, of walls one
    int edge = -1;                                 // whose home has it; -1: the rank of the first node does
    bool is_sent = false;  // the contact rank of its node has found it and sends it to that rank
  };

  void locate_points();
  void list_rows(const Deck& deck, const ContactScene& scene);
  int find_nearest_candidate(int node) const;
  int find_point_rank(const Places& places, std::size_t point) const;
  int find_row_rank(const Places& places, const Row& row) const;
  void count_contacts(const Places& places, ContactPlan& plan) const;
  template <class Call>
  void visit_ranks(const Places& places, std::size_t face, double wider, const Call& call) const;
  Places divide(const std::vector<int>& chunk_ranks, int rank_count) const;
  void find_edge_owners(Places& places) const;
  void plan_search(const Places& places, ContactPlan& plan) const;
  void plan_telling(const Places& places, ContactPlan& plan) const;
  void plan_check(const Places& places, ContactPlan& plan) const;
  void send_check(const Places& places, const FacesOfNodes& pairs, double times, double lists, ContactPlan& plan) const;
  Named name_edges(const Places& places, const PairsOfEdges& pairs) const;
  void plan_edge_search(const Places& places, ContactPlan& plan) const;
  void plan_edge_check(const Places& places, ContactPlan& plan) const;
  void send_edge_check(const Places& places, const PairsOfEdges& pairs, double times, ContactPlan& plan) const;
  void plan_enforcement(const Places& places, ContactPlan& plan) const;

  const ChunkedMesh& whole_;
  UnstructuredExchange exchange_;
  const TiedSurfaces ties_;
  const SurfaceShare share_;
  const double steps_per_search_;
  const StartPairs pairs_;
  std::vector<int> contact_nodes_;   // [mesh nodes] place among the contact nodes, -1: none
  std::vector<PlacedPoint> points_;  // searched nodes, then centres of searched faces
  std::vector<int> searched_nodes_;  // places among the contact nodes
  std::vector<Row> rows_;
};

}  // namespace percuss
