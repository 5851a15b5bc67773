#include "src/contact/plan/plan_contact.hpp"

#include <limits>

#include "kernels/core/host_copy.hpp"
#include "src/contact/plan/contact_flow.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/index.hpp"

namespace percuss {
ContactPlanner::ContactPlanner(const ChunkedMesh& whole, const Deck& deck, const ContactScene& scene)
    : whole_(whole),
      exchange_(Communicator(MPI_COMM_SELF)),
      ties_(find_ties(whole, deck, exchange_.ranks())),
      share_(build_surface_share(whole, deck, ties_, exchange_)),
      steps_per_search_(deck.contact.reuse_search ? scene.steps_per_search : 1),
      pairs_(find_start_pairs(deck, share_, scene.motion, steps_per_search_)),
      contact_nodes_(whole.mesh.nodes.size(), -1) {
  for (int n = 0; n < share_.nodes.count(); ++n) {
    contact_nodes_[at(share_.nodes.mesh_nodes[at(n)])] = n;
    if (share_.nodes.searched[at(n)] != 0) searched_nodes_.push_back(n);
  }
  locate_points();
  list_rows(deck, scene);
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

/// The candidate face of a contact node whose centre is nearest; -1 if it has none.
int ContactPlanner::find_nearest_candidate(int node) const {
  const Vec3& x = whole_.mesh.nodes[at(share_.nodes.mesh_nodes[at(node)])];
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = pairs_.all.first[at(node)]; i < pairs_.all.first[at(node) + 1]; ++i) {
    double distance = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double centre = 0;
      for (const int corner : share_.face_corners[at(pairs_.all.face[at(i)])]) {
        centre += 0.25 * whole_.mesh.nodes[at(corner)][k];
      }
      distance += (centre - x[k]) * (centre - x[k]);
    }
    if (distance < least) nearest = pairs_.all.face[at(i)];
    least = std::min(least, distance);
  }
  return nearest;
}

void ContactPlanner::list_rows(const Deck& deck, const ContactScene& scene) {
  const auto add = [&](int node, int face) {
    const std::array<int, 4>& c = share_.face_corners[at(face)];
    rows_.push_back({{share_.nodes.mesh_nodes[at(node)], c[0], c[1], c[2], c[3]}, -1, true});
  };
  if (scene.touches == PlannedTouches::start)
    for (const auto& [node, face] : pairs_.touches) add(node, face);
  else
    for (const int node : searched_nodes_)
      if (const int face = find_nearest_candidate(node); face >= 0) add(node, face);
  for (const auto& [a, b] : pairs_.edge_touches) {
    const std::int64_t(&of_a)[2] = share_.edges[at(a)].ends, (&of_b)[2] = share_.edges[at(b)].ends;
    rows_.push_back({{static_cast<int>(of_a[0]), static_cast<int>(of_a[1]), static_cast<int>(of_b[0]),
                      static_cast<int>(of_b[1]), -1},
                     a});
  }
  for (const TiedNode& tied : ties_.nodes) {
    if (deck.contact.ties[at(tied.tie)].cohesive) continue;  // glue is a force, without a row
    Row row{{static_cast<int>(tied.node), -1, -1, -1, -1}};
    for (std::size_t i = 0; i < 4; ++i) row.nodes[i + 1] = static_cast<int>(tied.corners[i]);
    rows_.push_back(row);
  }
  if (deck.walls.empty()) return;
  for (const int node : find_walled_nodes(whole_, deck, share_, scene.motion))
    rows_.push_back({{node, -1, -1, -1, -1}});
}

/// The rank that has a point in the FE decomposition.
int ContactPlanner::find_point_rank(const Places& places, std::size_t point) const {
  if (point < searched_nodes_.size()) return places.find_fe_rank(share_.nodes.mesh_nodes[at(searched_nodes_[point])]);
  const int face = share_.searched_faces[point - searched_nodes_.size()];
  return places.fe.find_element_owner(find_element_of_face(share_.faces[at(face)].number));
}

ContactPlanner::Places ContactPlanner::divide(const std::vector<int>& chunk_ranks, int rank_count) const {
  Places places{
      whole_.numbering, {rank_count, to_view("contact::cuts", bisect_points(points_, rank_count))}, {}, {}, {}};
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
  find_edge_owners(places);
  for (int& owner : places.owners) owner = places.rank_of_part[at(owner)];
  return places;
}

ContactPlan ContactPlanner::plan(const std::vector<int>& chunk_ranks, int rank_count) const {
  ContactPlan plan;
  plan.ranks.resize(at(rank_count));
  if (points_.empty() && rows_.empty()) return plan;
  const Places places = divide(chunk_ranks, rank_count);
  plan_search(places, plan);
  count_contacts(places, plan);
  if (rank_count == 1) return plan;  // nothing is sent
  plan_telling(places, plan);
  plan_check(places, plan);
  plan_edge_search(places, plan);
  plan_edge_check(places, plan);
  plan_enforcement(places, plan);
  return plan;
}

}  // namespace percuss
