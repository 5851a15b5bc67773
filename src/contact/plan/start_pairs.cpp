#include "src/contact/plan/start_pairs.hpp"

#include "kernels/contact/rows/row_system.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/reuse_bound.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

template <std::size_t N, class Rows>
std::vector<std::array<double, N>> list_values(const Rows& rows, std::size_t count) {
  const auto host = to_host(rows);
  std::vector<std::array<double, N>> list(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < N; ++k) list[i][k] = host(i, k);
  return list;
}

FacesOfNodes list_faces(const CandidateList& pairs, int nodes) {
  FacesOfNodes list;
  list.first.assign(at(nodes) + 1, 0);
  if (pairs.num_pairs == 0) return list;
  const auto offset = to_host(pairs.offset), face = to_host(pairs.face);
  list.first.assign(offset.data(), offset.data() + list.first.size());
  list.face.assign(face.data(), face.data() + pairs.num_pairs);
  return list;
}

PairsOfEdges list_edges(const EdgePairs& pairs) {
  PairsOfEdges list;
  const auto a = to_host(pairs.a), b = to_host(pairs.b);
  for (int p = 0; p < pairs.num_pairs; ++p) list.push_back({a(p), b(p)});
  return list;
}

/// Check and lists of the pairs of nodes and faces of the last search.
void list_face_pairs(const SurfaceShare& share, const SurfaceMotion& motion, LocalFinder& finder, StartPairs& found) {
  CheckSpace& check = finder.faces();
  const int nodes = share.nodes.count();
  found.boxes = list_values<6>(finder.boxes(), share.searched_faces.size());
  if (check.candidates.num_pairs > 0) check_candidates(motion, check);
  found.all = list_faces(check.candidates, nodes);
  found.reachable = list_faces(check.reachable_pairs(), nodes);
  found.near = list_faces(check.checked_pairs(), nodes);
  if (check.touches.count == 0) return;
  const auto by_node = to_host(check.touches.by_node);
  for (int n = 0; n < nodes; ++n) {
    if (!found.near.has(n)) continue;
    for (int i = 0; i < by_node(n).count; ++i) found.touches.push_back({n, by_node(n).touch[i].face});
  }
}

/// Lists the pairs of edges.
void list_edge_pairs(const SurfaceShare& share, const SurfaceMotion& motion, LocalEdges& edges, StartPairs& found) {
  const EdgeSpace& space = edges.space();
  found.divided_edges = edges.divided_edges();
  found.edge_boxes = list_values<6>(edges.boxes(), share.edges.size());
  found.edge_points = list_values<3>(edges.places(), at(edges.piece_count()));
  if (space.pairs.num_pairs > 0) edges.check(motion, {});
  found.edges = list_edges(space.pairs);
  found.near_edges = list_edges(space.checked_pairs());
  const auto touching = to_host(space.touches.list);
  for (int k = 0; k < space.touches.count; ++k) found.edge_touches.push_back(found.near_edges[at(touching(k))]);
}

}  // namespace

StartPairs find_start_pairs(const Deck& deck, const SurfaceShare& share, const SurfaceMotion& motion,
                            double steps_per_search) {
  StartPairs found;
  found.divided_edges = share.edges;
  ReuseBound bound(Communicator(MPI_COMM_SELF), share, deck.contact.reuse_search);
  found.margin = bound.restart(motion);
  const PlannedLists lists =
      deck.contact.reuse_search ? plan_near_lists(found.margin, steps_per_search) : PlannedLists{};
  found.lists_near = lists.way.near > 0;
  found.steps_per_list = found.lists_near ? lists.steps : steps_per_search;
  ContactDeck contact = deck.contact;
  contact.reuse_search = false;  // what is at rest at the start is checked, too
  LocalFinder finder(share, contact);
  finder.search(motion, found.margin);
  finder.narrow(lists.way);
  list_face_pairs(share, motion, finder, found);
  if (!share.edges.empty()) list_edge_pairs(share, motion, finder.edges(), found);
  return found;
}

std::vector<int> find_walled_nodes(const ChunkedMesh& whole, const Deck& deck, const SurfaceShare& share,
                                   const SurfaceMotion& motion) {
  const WallPairs walls = build_walls(whole, deck, share);
  RowInputs inputs;
  inputs.motion = motion;
  inputs.looks_inside = false;  // nothing has been pushed
  RowSystem system;
  count_rows(ExecSpace(), inputs, {{}, 0, walls}, system);
  ExecSpace().fence();
  const auto near = to_host(system.near_walls);
  const auto node = to_host(walls.node);
  std::vector<int> nodes;
  nodes.reserve(at(system.num_rows));
  for (int i = 0; i < system.num_rows; ++i) nodes.push_back(node(at(near(at(i)))));
  return nodes;
}

}  // namespace percuss
