#include "src/contact/plan/start_pairs.hpp"

#include "kernels/contact/rows/row_system.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/search/reuse_bound.hpp"
#include "src/contact/surface/number_map.hpp"
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

/// The pairs of nodes and faces.
class FacePairs {
 public:
  FacePairs(const Deck& deck, const SurfaceShare& share, const SurfaceMotion& motion) : share_(share), motion_(motion) {
    std::vector<std::int64_t> numbers;
    for (const FaceTopology& face : share.faces) numbers.push_back(face.number);
    set_surface(make_whole_surface(share), numbers, check_);
    check_.keeps_still = false;
    scratch_.method = find_method(deck.contact.search);
  }

  void find(const NearWay& way, StartPairs& found) {
    const Boxes boxes("contact::boxes", share_.searched_faces.size());
    bound_faces(ExecSpace(), share_.bounded_faces(), motion_, found.margin, boxes);
    ExecSpace().fence();
    found.boxes = list_values<6>(boxes, share_.searched_faces.size());
    const std::int64_t limit = std::min(find_pair_limit(share_), most_indexed_pairs);
    const std::int64_t pairs =
        find_candidate_pairs(ExecSpace(), check_.surface, {motion_.x, boxes}, limit, scratch_, check_.candidates);
    refuse_too_many_pairs(pairs, find_pair_limit(share_), found.margin);
    refuse_crowded_ranks(pairs > most_indexed_pairs ? 1 : 0);
    list_concerned(ExecSpace(), check_.surface, scratch_.concerned, check_.candidates);
    check_.near.ask(way);
    if (pairs > 0) check_candidates(motion_, check_);
    list(found);
  }

 private:
  void list(StartPairs& found) const {
    const int nodes = share_.nodes.count();
    found.all = list_faces(check_.candidates, nodes);
    found.reachable = list_faces(check_.reachable_pairs(), nodes);
    found.near = list_faces(check_.checked_pairs(), nodes);
    if (check_.touches.count == 0) return;
    const auto by_node = to_host(check_.touches.by_node);
    for (int n = 0; n < nodes; ++n) {
      if (!found.near.has(n)) continue;
      for (int i = 0; i < by_node(n).count; ++i) found.touches.push_back({n, by_node(n).touch[i].face});
    }
  }

  const SurfaceShare& share_;
  SurfaceMotion motion_;
  CheckSpace check_;
  SearchScratch scratch_;
};

/// The pairs of edges.
void find_edges(const Deck& deck, const SurfaceShare& share, const SurfaceMotion& motion, const NearWay& way,
                StartPairs& found) {
  const auto find_row = [&](std::int64_t number) {
    return share.nodes.mesh_nodes[at(find_number(share.nodes.numbers, number))];
  };
  EdgeSpace space;
  space.keeps_still = false;
  set_edge_surface(make_edge_surface(share.edges, find_row, share), space);
  divide_again(space.surface.ends, motion.x, share.edge_piece, found.divided_edges);
  const EdgePointLists lists = list_edge_points(found.divided_edges, space.surface.ends, {});
  const Rows3<double> places("contact::edge_places", at(lists.points.num_points));
  const Boxes boxes("contact::edge_boxes", share.edges.size());
  EdgeSearchScratch scratch;
  scratch.points.method = find_method(deck.contact.search);
  const ExecSpace exec;
  place_edge_points(exec, lists.points, motion.x, places);
  const Point3 half = find_half_piece(exec, lists.points, motion.x);
  bound_edges(exec, lists.points.ends, motion, find_edge_margin(half, found.margin, 2 * share.largest_offset), boxes);
  const EdgeQuery query{lists.names, places, motion.x, boxes, find_edge_slack(half, found.margin)};
  const std::int64_t limit = std::min(find_edge_pair_limit(share), most_indexed_pairs);
  refuse_too_many_pairs(find_edge_pairs(exec, space.surface, query, limit, scratch, space.pairs), limit, found.margin);
  found.edge_boxes = list_values<6>(boxes, share.edges.size());
  found.edge_points = list_values<3>(places, places.extent(0));
  space.near.ask(way.near);
  if (space.pairs.num_pairs > 0) check_edge_pairs(motion, {}, space);
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
  if (!share.searched_faces.empty())
    FacePairs(deck, share, motion).find(lists.way, found);
  else
    found.all.first = found.reachable.first = found.near.first = std::vector<int>(at(share.nodes.count()) + 1, 0);
  if (!share.edges.empty()) find_edges(deck, share, motion, lists.way, found);
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
