// Messages of ranks for contact, by the steps of a run.

#include <algorithm>
#include <map>

#include "src/contact/check/ranked_check.hpp"
#include "src/contact/enforcement/shared_entries.hpp"
#include "src/contact/plan/contact_flow.hpp"
#include "src/contact/ranks/contact_decomposition.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

// Bytes of an item as a run sends it, besides those of contact_flow.hpp.
constexpr double plan_bytes = 8;  // items of a message that is to follow, when a plan is made (2.4)
constexpr double box_bytes = 48;
constexpr double history_bytes = 24;                       // three faces
constexpr double touch_bytes = RankedCheck::touch_bytes;   // a touch with its node, face and corners
constexpr double notice_bytes = sizeof(RowNotice);         // a corner and its row
constexpr double value_bytes = 24;                         // a coefficient, an impulse
constexpr std::int64_t corner_bytes = sizeof(NodeAnswer);  // place, velocities, inverse mass, spring
constexpr std::int64_t entry_bytes = sizeof(EntryAnswer);  // a row of another rank on a corner

}  // namespace

/// Part of the surface around some nodes that a rank receives; RankedFinder does not ask where it knows all faces
/// already.
struct ContactPlanner::Reach {
  const ContactPlanner& planner;
  const Places& places;
  Visit asked, needed, answered;
  Flow requests, answers, nodes;  // numbers of nodes, faces around these, nodes of these faces

  Reach(const ContactPlanner& from, const Places& in)
      : planner(from),
        places(in),
        asked(from.whole_.mesh.nodes.size()),
        needed(from.whole_.mesh.nodes.size()),
        answered(from.share_.faces.size()) {}

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
      if (answered.is_first(face, rank)) answers.add(fe_rank, rank);  // another owner may tell of it, too: seldom
      for (const std::int64_t corner : planner.share_.face(face).corners) need(static_cast<int>(corner), rank);
    }
  }
};

/// Calls call(rank) for the ranks that the box of a searched face reaches, if it is so much wider.
template <class Call>
void ContactPlanner::visit_ranks(const Places& places, std::size_t face, double wider, const Call& call) const {
  const std::array<double, 6>& box = pairs_.boxes[face];
  visit_reached_ranks(places.tree, std::array{box[0] - wider, box[1] - wider, box[2] - wider},
                      std::array{box[3] + wider, box[4] + wider, box[5] + wider},
                      [&](int part) { call(places.rank_of_part[at(part)]); });
}

/// Nodes to their owners, faces to the ranks that their boxes reach: (5.4) and (5.5).
void ContactPlanner::plan_search(const Places& places, ContactPlan& plan) const {
  Flow nodes, faces;
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i) {
    ++plan.ranks[at(places.owners[i])].nodes;
    nodes.add(find_point_rank(places, i), places.owners[i]);
  }
  for (std::size_t i = 0; i < pairs_.boxes.size(); ++i) {
    const std::size_t point = searched_nodes_.size() + i;
    ++plan.ranks[at(places.owners[point])].faces;
    visit_ranks(places, i, 0, [&](int rank) { ++plan.ranks[at(rank)].faces_here; });
    visit_ranks(places, i, sent_margins * pairs_.margin,
                [&](int rank) { faces.add(find_point_rank(places, point), rank); });
  }
  plan.ghost_faces = -static_cast<std::int64_t>(pairs_.boxes.size());
  for (const ContactRankPlan& rank : plan.ranks) plan.ghost_faces += rank.faces_here;
  const auto telling = &ContactRankPlan::telling, search = &ContactRankPlan::search;
  for (const Flow* flow : {&nodes, &faces}) flow->announce(plan_bytes, telling, plan);
  nodes.send(sizeof(NodeRecord), telling, plan);
  faces.send(sizeof(FaceTopology), telling, plan);
  nodes.send(place_bytes, search, plan);
  faces.send(box_bytes, search, plan);
}

/// Surface data that a rank receives: the faces around its nodes and around those of its ghost faces. With their names
/// it then requests the motion of nodes and the history.
void ContactPlanner::plan_telling(const Places& places, ContactPlan& plan) const {
  std::vector<std::vector<int>> nodes(plan.ranks.size()), faces(plan.ranks.size());  // by rank, mesh nodes and faces
  Flow history;
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i) {
    nodes[at(places.owners[i])].push_back(share_.nodes.mesh_nodes[at(searched_nodes_[i])]);
    history.add(find_point_rank(places, i), places.owners[i]);
  }
  for (std::size_t i = 0; i < pairs_.boxes.size(); ++i)
    visit_ranks(places, i, sent_margins * pairs_.margin,
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

/// Counts what a rank is sent for the check of some pairs, a number of times a step: (5.6) and (5.7). lists: how often
/// in a step it requests some of it.
void ContactPlanner::send_check(const Places& places, const FacesOfNodes& pairs, double times, double lists,
                                ContactPlan& plan) const {
  std::vector<std::vector<int>> checked(plan.ranks.size());  // by rank, places among the contact nodes
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i)
    if (pairs.has(searched_nodes_[i])) checked[at(places.owners[i])].push_back(searched_nodes_[i]);
  Reach reach(*this, places);
  Visit faces(share_.faces.size());
  Flow history;
  for (int rank = 0; rank < static_cast<int>(checked.size()); ++rank) {
    for (const int n : checked[at(rank)]) {
      const int node = share_.nodes.mesh_nodes[at(n)];
      history.add(places.find_fe_rank(node), rank);
      reach.need(node, rank);
      reach.ask(node, rank);
      for (int i = pairs.first[at(n)]; i < pairs.first[at(n) + 1]; ++i) {
        const int face = pairs.face[at(i)];
        if (!faces.is_first(face, rank)) continue;
        for (const int corner : share_.face_corners[at(face)]) reach.ask(corner, rank);
        for (const int back : share_.face_backs[at(face)]) reach.need(back, rank);
      }
    }
  }
  const auto step = &ContactRankPlan::step;
  reach.nodes.send(motion_bytes, step, plan, times);
  history.send(history_bytes, step, plan, times);
  history.send_back(0, step, plan, times);  // touches; their bytes are plan_check()'s
  reach.nodes.send_back(flag_bytes, step, plan, lists);
  history.send_back(flag_bytes, step, plan, lists);
}

/// All pairs in the first step after a search, near ones until they are listed again, and then those of which they are.
void ContactPlanner::plan_check(const Places& places, ContactPlan& plan) const {
  const double searches = 1 / steps_per_search_, lists = 1 / pairs_.steps_per_list;
  if (!pairs_.lists_near) {
    send_check(places, pairs_.all, 1, 0, plan);
  } else {
    send_check(places, pairs_.all, searches, searches, plan);
    send_check(places, pairs_.reachable, std::max(0.0, lists - searches), lists, plan);
    send_check(places, pairs_.near, 1 - std::max(lists, searches), 0, plan);
  }
  std::vector<int> owners(at(share_.nodes.count()), -1);  // [contact nodes]
  for (std::size_t i = 0; i < searched_nodes_.size(); ++i) owners[at(searched_nodes_[i])] = places.owners[i];
  for (const Row& row : rows_) {
    if (!row.is_sent) continue;
    const int home = places.find_fe_rank(row.nodes[0]), rank = owners[at(contact_nodes_[at(row.nodes[0])])];
    if (home != rank) plan.ranks[at(rank)].step.bytes += touch_bytes;
  }
}

int ContactPlanner::find_row_rank(const Places& places, const Row& row) const {
  return row.edge >= 0 ? places.find_home(share_.edges[at(row.edge)]) : places.find_fe_rank(row.nodes[0]);
}

void ContactPlanner::count_contacts(const Places& places, ContactPlan& plan) const {
  for (const Row& row : rows_) {
    ContactRankPlan& rank = plan.ranks[at(find_row_rank(places, row))];
    ++rank.contacts;
    rank.is_touched = true;
  }
}

/// Plans what rows exchange with all ranks that have rows on the same nodes, and with the owners of these.
void ContactPlanner::plan_enforcement(const Places& places, ContactPlan& plan) const {
  std::vector<std::map<int, std::int64_t>> rows(whole_.mesh.nodes.size());  // of a node: how many each rank has on it
  for (const Row& row : rows_) {
    const int rank = find_row_rank(places, row);
    for (const int node : row.nodes)
      if (node >= 0) ++rows[at(node)][rank];
  }
  Flow notices, answers, swaps;
  for (std::size_t node = 0; node < rows.size(); ++node) {
    if (rows[node].empty()) continue;
    const int owner = places.find_fe_rank(static_cast<int>(node));
    plan.ranks[at(owner)].is_touched = true;
    rows[node].try_emplace(owner, 0);
    std::int64_t all = 0;
    for (const auto& [rank, count] : rows[node]) all += count;
    for (const auto& [rank, count] : rows[node]) {
      if (rank == owner) continue;
      notices.add(rank, owner, count);
      answers.add(owner, rank, corner_bytes + entry_bytes * (all - count));
    }
    for (const auto& [rank, count] : rows[node]) {
      if (count == 0) continue;
      for (const auto& [other, unused] : rows[node]) swaps.add(rank, other, count);
    }
  }
  const auto step = &ContactRankPlan::step, pass = &ContactRankPlan::pass;
  notices.send(notice_bytes, step, plan);
  answers.send(1, step, plan);
  swaps.send(value_bytes, step, plan);  // coefficients; then impulses, again and again
  swaps.send(value_bytes, pass, plan);
}

}  // namespace percuss
