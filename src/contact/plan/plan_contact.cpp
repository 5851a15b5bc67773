#include "src/contact/plan/plan_contact.hpp"

#include "kernels/core/host_copy.hpp"
#include "src/contact/plan/contact_flow.hpp"
#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/search/reuse_bound.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/index.hpp"

namespace percuss {
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
  const std::int64_t pairs = find_candidate_pairs(ExecSpace(), surface, {x_, boxes}, limit, scratch, found);
  refuse_too_many_pairs(pairs, limit, margin);
  const auto offset = to_host(found.offset);
  const auto face = to_host(found.face);
  first_pair_.assign(at(share_.nodes.count()) + 1, 0);
  if (found.num_pairs > 0) first_pair_.assign(offset.data(), offset.data() + first_pair_.size());
  pair_face_.assign(face.data(), face.data() + found.num_pairs);
}

/// The rank that has a point in the FE decomposition.
int ContactPlanner::find_point_rank(const Places& places, std::size_t point) const {
  if (point < searched_nodes_.size()) return places.find_fe_rank(share_.nodes.mesh_nodes[at(searched_nodes_[point])]);
  const int face = share_.searched_faces[point - searched_nodes_.size()];
  return places.fe.find_element_owner(find_element_of_face(share_.faces[at(face)].number));
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
