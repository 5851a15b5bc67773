#include "src/contact/plan/plan_contact.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "kernels/core/host_copy.hpp"
#include "src/contact/decomposition/contact_decomposition.hpp"
#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/search/reuse_bound.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Bytes of an item as a run sends it.
constexpr std::int64_t number_bytes = 8;  // of a node
constexpr std::int64_t plan_bytes = 8;    // items of a message that is to follow, when a plan is made (2.4)
constexpr std::int64_t place_bytes = 24;
constexpr std::int64_t box_bytes = 48;
constexpr std::int64_t flag_bytes = 1;         // whether something is wanted
constexpr std::int64_t motion_bytes = 48;      // place and velocity
constexpr std::int64_t history_bytes = 24;     // three faces
constexpr std::int64_t touch_bytes = 200;      // a touch with its node, face and corners
constexpr std::int64_t notice_bytes = 16;      // a corner and its row
constexpr std::int64_t corner_bytes = 4 * 24;  // place, two velocities, inverse mass
constexpr std::int64_t value_bytes = 24;       // a coefficient, an impulse, a correction

/// Items that go from rank to rank; what stays on a rank does not count.
class Flow {
 public:
  void add(int from, int to, std::int64_t items = 1) {
    if (from != to) items_[{from, to}] += items;
  }

  /// A message from every sender to every receiver, of so many bytes an item ...
  void send(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.first, items * bytes, phase, plan);
  }
  /// ... or back along the same ways ...
  void send_back(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.second, items * bytes, phase, plan);
  }
  /// ... or of so many bytes in all.
  void announce(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.first, bytes, phase, plan);
  }
  void announce_back(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.second, bytes, phase, plan);
  }

 private:
  static void count(int rank, std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) {
    Traffic& traffic = plan.ranks[at(rank)].*phase;
    ++traffic.messages;
    traffic.bytes += bytes;
  }

  std::map<std::pair<int, int>, std::int64_t> items_;  // by sender and receiver
};

}  // namespace

/// Who has what in the two decompositions.
struct ContactPlanner::Places {
  Numbering fe;  // of the mesh, with the ranks of the plan
  CutTree tree;
  std::vector<int> rank_of_part;
  std::vector<int> owners;  // [points] ranks

  int find_fe_rank(int mesh_node) const { return fe.find_node_owner(mesh_node); }
};

/// Marks nodes that a rank has been told of.
struct ContactPlanner::Visit {
  std::vector<int> last;  // [mesh nodes] rank that marked it last
  explicit Visit(std::size_t nodes) : last(nodes, -1) {}

  bool is_first(int node, int rank) {
    const bool first = last[at(node)] != rank;
    last[at(node)] = rank;
    return first;
  }
};

/// What a rank learns of the surface around some nodes; RankedFinder does not ask where it knows all faces already.
struct ContactPlanner::Reach {
  const ContactPlanner& planner;
  const Places& places;
  Visit asked, needed, told;
  Flow requests, answers, nodes;  // numbers of nodes, faces around these, nodes of these faces

  Reach(const ContactPlanner& from, const Places& in)
      : planner(from),
        places(in),
        asked(from.whole_.mesh.nodes.size()),
        needed(from.whole_.mesh.nodes.size()),
        told(from.share_.faces.size()) {}

  void need(int node, int rank) {
    if (needed.is_first(node, rank)) nodes.add(places.find_fe_rank(node), rank);
  }

  /// A node whose surrounding faces are read.
  void ask(int node, int rank) {
    if (!asked.is_first(node, rank)) return;
    const OwnedContactNodes& own = planner.share_.nodes;
    const auto n = at(planner.contact_nodes_[at(node)]);
    const int fe_rank = places.find_fe_rank(node);
    requests.add(rank, fe_rank);
    for (int f = own.first_face[n]; f < own.first_face[n + 1]; ++f) {
      const int face = own.faces[at(f)];
      if (told.is_first(face, rank)) answers.add(fe_rank, rank);  // another owner may tell of it, too: seldom
      for (const std::int64_t corner : planner.share_.face(face).corners) need(static_cast<int>(corner), rank);
    }
  }
};

ContactPlanner::ContactPlanner(const ChunkedMesh& whole, const Deck& deck)
    : whole_(whole),
      exchange_(Communicator(MPI_COMM_SELF)),
      share_(build_surface_share(whole, deck, find_ties(whole, deck, exchange_.ranks()), exchange_)),
      x_(to_rows("contact::start_places", whole.mesh.nodes)),
      contact_nodes_(whole.mesh.nodes.size(), -1) {
  for (int n = 0; n < share_.nodes.count(); ++n) {
    contact_nodes_[at(share_.nodes.mesh_nodes[at(n)])] = n;
    if (share_.nodes.searched[at(n)] != 0) searched_nodes_.push_back(n);
  }
  locate_points();
  if (!share_.searched_faces.empty()) find_boxes(deck.contact.reuse_search);
}

/// As ContactDecomposition::locate_points does.
void ContactPlanner::locate_points() {
  for (const int n : searched_nodes_) {
    points_.push_back({whole_.mesh.nodes[at(share_.nodes.mesh_nodes[at(n)])], 2 * share_.nodes.numbers[at(n)]});
  }
  for (const int f : share_.searched_faces) {
    PlacedPoint centre{{0, 0, 0}, 2 * share_.faces[at(f)].number + 1};
    for (const int corner : share_.face_corners[at(f)]) {
      for (std::size_t k = 0; k < 3; ++k) centre.x[k] += whole_.mesh.nodes[at(corner)][k];
    }
    for (double& x : centre.x) x *= 0.25;
    points_.push_back(centre);
  }
}

/// Capture boxes of the faces at rest, widened as a run widens them, and the candidate pairs in them.
void ContactPlanner::find_boxes(bool reuse_search) {
  const SurfaceMotion at_rest{x_, x_, 0};
  ReuseBound bound(exchange_.ranks(), share_, reuse_search);
  const double margin = margin_ = bound.restart(at_rest);
  const Boxes boxes("contact::boxes", share_.searched_faces.size());
  bound_faces(ExecSpace(), share_.bounded_faces(), at_rest, margin, boxes);
  ExecSpace().fence();
  const auto host = to_host(boxes);
  boxes_.resize(share_.searched_faces.size());
  for (std::size_t f = 0; f < boxes_.size(); ++f) {
    for (std::size_t k = 0; k < 6; ++k) boxes_[f][k] = host(f, k);
  }
  find_pairs(boxes, margin);
}

void ContactPlanner::find_pairs(const Boxes& boxes, double margin) {
  const ContactSurface surface = make_whole_surface(share_);
  const std::int64_t limit = find_pair_limit(share_);
  SearchScratch scratch;
  CandidateList found;
  const std::int64_t pairs = find_points_in_boxes(ExecSpace(), surface, x_, boxes, limit, scratch, found);
  refuse_too_many_pairs(pairs, limit, margin);
  const auto offset = to_host(found.offset);
  const auto face = to_host(found.face);
  first_pair_.assign(at(share_.nodes.count()) + 1, 0);
  if (found.num_pairs > 0) first_pair_.assign(offset.data(), offset.data() + first_pair_.size());
  pair_face_.assign(face.data(), face.data() + found.num_pairs);
}

/// Of the candidate faces of a contact node, the one whose centre is nearest; -1 if it has none.
int ContactPlanner::find_nearest_candidate(int node) const {
  const Vec3& x = whole_.mesh.nodes[at(share_.nodes.mesh_nodes[at(node)])];
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = first_pair_[at(node)]; i < first_pair_[at(node) + 1]; ++i) {
    double distance = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double centre = 0;
      for (const int corner : share_.face_corners[at(pair_face_[at(i)])]) {
        centre += 0.25 * whole_.mesh.nodes[at(corner)][k];
      }
      distance += (centre - x[k]) * (centre - x[k]);
    }
    if (distance < least) nearest = pair_face_[at(i)];
    least = std::min(least, distance);
  }
  return nearest;
}

/// The rank that has a point in the FE decomposition.
int ContactPlanner::find_point_rank(const Places& places, std::size_t point) const {
  if (point < searched_nodes_.size()) return places.find_fe_rank(share_.nodes.mesh_nodes[at(searched_nodes_[point])]);
  const int face = share_.searched_faces[point - searched_nodes_.size()];
  return places.fe.find_element_owner(share_.faces[at(face)].number / 6);
}

/// Calls call(rank) for the ranks that the box of a searched face reaches, if it is so much wider.
template <class Call>
void ContactPlanner::visit_ranks(const Places& places, std::size_t face, double wider, const Call& call) const {
  const std::array<double, 6>& box = boxes_[face];
  visit_reached_ranks(places.tree, std::array{box[0] - wider, box[1] - wider, box[2] - wider},
                      std::array{box[3] + wider, box[4] + wider, box[5] + wider},
                      [&](int part) { call(places.rank_of_part[at(part)]); });
}

ContactPlanner::Places ContactPlanner::divide(const std::vector<int>& chunk_ranks, int rank_count) const {
  Places places{whole_.numbering, {rank_count, to_view("contact::cuts", bisect_points(points_, rank_count))}, {}, {}};
  places.fe.ranks = chunk_ranks;
  std::vector<std::vector<int>> parts(at(rank_count));
  for (std::size_t p = 0; p < points_.size(); ++p) {
    places.owners.push_back(find_owner(places.tree, points_[p].x, points_[p].id));
    parts[at(find_point_rank(places, p))].push_back(places.owners.back());
  }
  std::vector<Overlap> overlaps;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    const std::vector<Overlap> own = find_overlaps(static_cast<int>(r), parts[r]);
    overlaps.insert(overlaps.end(), own.begin(), own.end());
  }
  places.rank_of_part = assign_parts(std::move(overlaps), rank_count);
  for (int& owner : places.owners) owner = places.rank_of_part[at(owner)];
  return places;
}

/// Nodes to their owners, faces to the ranks that their boxes reach: (5.4) and (5.5).
void ContactPlanner::plan_search(const Places& places, ContactPlan& plan) const {
  Flow nodes, faces;
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i) {
    ++plan.ranks[at(places.owners[i])].nodes;
    nodes.add(find_point_rank(places, i), places.owners[i]);
  }
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const std::size_t point = searched_nodes_.size() + i;
    ++plan.ranks[at(places.owners[point])].faces;
    visit_ranks(places, i, 0, [&](int rank) { ++plan.ranks[at(rank)].faces_here; });
    visit_ranks(places, i, told_margins * margin_, [&](int rank) { faces.add(find_point_rank(places, point), rank); });
  }
  plan.ghost_faces = -static_cast<std::int64_t>(boxes_.size());
  for (const ContactRankPlan& rank : plan.ranks) plan.ghost_faces += rank.faces_here;
  const auto telling = &ContactRankPlan::telling, search = &ContactRankPlan::search;
  for (const Flow* flow : {&nodes, &faces}) flow->announce(plan_bytes, telling, plan);
  nodes.send(sizeof(NodeRecord), telling, plan);
  faces.send(sizeof(FaceTopology), telling, plan);
  nodes.send(place_bytes, search, plan);
  faces.send(box_bytes, search, plan);
}

/// What a rank learns of the surface: the faces around its nodes and those of the faces that it was told of, by whose
/// names it then asks for the motion of nodes and for history.
void ContactPlanner::plan_telling(const Places& places, ContactPlan& plan) const {
  std::vector<std::vector<int>> nodes(plan.ranks.size()), faces(plan.ranks.size());  // by rank, mesh nodes and faces
  Flow history;
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i) {
    nodes[at(places.owners[i])].push_back(share_.nodes.mesh_nodes[at(searched_nodes_[i])]);
    history.add(find_point_rank(places, i), places.owners[i]);
  }
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    visit_ranks(places, i, told_margins * margin_,
                [&](int rank) { faces[at(rank)].push_back(share_.searched_faces[i]); });
  Reach reach(*this, places);
  for (int rank = 0; rank < static_cast<int>(nodes.size()); ++rank) {
    for (const int node : nodes[at(rank)]) reach.ask(node, rank);
    for (const int face : faces[at(rank)]) {
      for (const int corner : share_.face_corners[at(face)]) reach.ask(corner, rank);
      for (const int back : share_.face_backs[at(face)]) reach.need(back, rank);
    }
  }
  const auto telling = &ContactRankPlan::telling, search = &ContactRankPlan::search;
  reach.requests.announce(plan_bytes, telling, plan);
  reach.requests.send(number_bytes, telling, plan);
  reach.answers.send(sizeof(FaceTopology), telling, plan);
  for (const Flow* named : {&reach.nodes, &history}) {
    named->announce_back(plan_bytes, telling, plan);
    named->send_back(number_bytes, telling, plan);
    named->send_back(flag_bytes, search, plan);
  }
}

/// What a rank is sent for the check of its candidate pairs, in every step: (5.6) and (5.7).
void ContactPlanner::plan_check(const Places& places, ContactPlan& plan) const {
  std::vector<std::vector<int>> checked(plan.ranks.size());  // by rank, places among the contact nodes
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i) {
    const int n = searched_nodes_[i];
    if (first_pair_[at(n)] < first_pair_[at(n) + 1]) checked[at(places.owners[i])].push_back(n);
  }
  Reach reach(*this, places);
  Visit faces(share_.faces.size());
  Flow history;
  for (int rank = 0; rank < static_cast<int>(checked.size()); ++rank) {
    for (const int n : checked[at(rank)]) {
      const int node = share_.nodes.mesh_nodes[at(n)];
      history.add(places.find_fe_rank(node), rank);
      reach.need(node, rank);
      reach.ask(node, rank);
      for (int i = first_pair_[at(n)]; i < first_pair_[at(n) + 1]; ++i) {
        const int face = pair_face_[at(i)];
        if (!faces.is_first(face, rank)) continue;
        for (const int corner : share_.face_corners[at(face)]) reach.ask(corner, rank);
        for (const int back : share_.face_backs[at(face)]) reach.need(back, rank);
      }
    }
  }
  const auto step = &ContactRankPlan::step;
  reach.nodes.send(motion_bytes, step, plan);
  history.send(history_bytes, step, plan);
  history.send_back(touch_bytes, step, plan);
}

/// What rows exchange with the owners of the corners of their faces.
void ContactPlanner::plan_enforcement(const Places& places, ContactPlan& plan) const {
  Flow corners;
  for (const int n : searched_nodes_) {
    const int face = find_nearest_candidate(n);
    if (face < 0) continue;
    const int rank = places.find_fe_rank(share_.nodes.mesh_nodes[at(n)]);
    for (const int corner : share_.face_corners[at(face)]) corners.add(rank, places.find_fe_rank(corner));
  }
  const auto step = &ContactRankPlan::step, pass = &ContactRankPlan::pass;
  corners.announce(plan_bytes, step, plan);
  corners.send(notice_bytes, step, plan);
  corners.send_back(corner_bytes, step, plan);
  for (const auto phase : {step, pass}) {  // coefficients; then impulses and corrections, again and again
    corners.send(value_bytes, phase, plan);
    corners.send_back(value_bytes, phase, plan);
  }
}

ContactPlan ContactPlanner::plan(const std::vector<int>& chunk_ranks, int rank_count) const {
  ContactPlan plan;
  plan.ranks.resize(at(rank_count));
  if (boxes_.empty()) return plan;
  const Places places = divide(chunk_ranks, rank_count);
  plan_search(places, plan);
  if (rank_count == 1) return plan;  // nothing is sent
  plan_telling(places, plan);
  plan_check(places, plan);
  plan_enforcement(places, plan);
  return plan;
}

}  // namespace percuss
