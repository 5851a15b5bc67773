// One rank has the whole surface: search and check run on the arrays of the mesh, and nothing is sent.

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/pair_limit.hpp"

namespace percuss {
namespace {

std::vector<std::int64_t> list_face_numbers(const SurfaceShare& share) {
  std::vector<std::int64_t> numbers;
  for (const FaceTopology& face : share.faces) numbers.push_back(face.number);
  return numbers;
}

}  // namespace

ContactSurface make_whole_surface(const SurfaceShare& share) {
  SurfaceLists lists;
  lists.nodes = share.nodes.mesh_nodes;
  lists.node_class = share.nodes.classes;
  lists.backs = share.face_backs;
  lists.searched_faces = share.searched_faces;
  lists.node_radius = share.nodes.radii;
  std::vector<int> place(lists.nodes.empty() ? 0 : static_cast<std::size_t>(lists.nodes.back()) + 1, -1);
  for (std::size_t n = 0; n < lists.nodes.size(); ++n) {
    place[static_cast<std::size_t>(lists.nodes[n])] = static_cast<int>(n);
    if (share.nodes.searched[n] != 0) lists.searched_nodes.push_back(static_cast<int>(n));
  }
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    std::array<int, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = place[static_cast<std::size_t>(share.face_corners[f][i])];
    lists.corners.push_back(corners);
    lists.face_class.push_back(share.faces[f].surface_class);
    lists.face_body.push_back(share.faces[f].body);
    if (share.largest_offset > 0) lists.face_offset.push_back(share.faces[f].offset);
  }
  return make_contact_surface(lists, share);
}

LocalFinder::LocalFinder(const SurfaceShare& share, const ContactDeck& deck) : share_(share), edges_(share, deck) {
  scratch_.method = find_method(deck.search);
  check_.keeps_still = deck.reuse_search;
  lists_near_ = deck.reuse_search && share.largest_offset > 0;
  set_surface(make_whole_surface(share), list_face_numbers(share), check_);
  node_numbers_ = to_view("contact::node_numbers", share.nodes.numbers);
  boxes_ = Boxes("contact::boxes", share.searched_faces.size());
}

LocalFinder::LocalFinder(const LocalFinder& of_run, const LookedAt& at)
    : share_(of_run.share_), edges_(of_run.edges_, at.has_edges) {
  scratch_.method = of_run.scratch_.method;
  set_surface(of_run.check_.surface, of_run.check_.face_numbers, check_);
  boxes_ = Boxes("contact::boxes", share_.searched_faces.size());
  if (!at.nodes) return;
  std::vector<int> nodes;
  for (std::size_t n = 0; n < at.nodes->size(); ++n)
    if (share_.nodes.searched[n] != 0 && (*at.nodes)[n] != 0) nodes.push_back(static_cast<int>(n));
  check_.surface.searched_nodes = to_view("contact::looked_at_nodes", nodes);
}

/// A surface that has changed once may do so again: from now on the tree of its search is kept.
void LocalFinder::take_over(const ContactFinder& before) {
  const auto& other = dynamic_cast<const LocalFinder&>(before);  // of the same number of ranks
  check_.counts = other.check_.counts;
  cells_.take_over(other.cells_);
  edges_.take_over(other.edges_);
  if (scratch_.method != SearchMethod::blocks) return;
  scratch_.blocks = other.scratch_.blocks;
  std::vector<std::int64_t> nodes, faces;
  faces.reserve(share_.searched_faces.size());
  for (std::size_t n = 0; n < share_.nodes.searched.size(); ++n)
    if (share_.nodes.searched[n] != 0) nodes.push_back(share_.nodes.numbers[n]);
  for (const int f : share_.searched_faces) faces.push_back(share_.faces[static_cast<std::size_t>(f)].number);
  identify(nodes, faces, scratch_.blocks);
}

std::int64_t LocalFinder::find_candidates(const SurfaceMotion& motion, double margin) {
  found_ = -1;  // by now the touches of the last check may have been written over
  return search_faces(motion, margin) + edges_.find_candidates(motion, margin);
}

std::int64_t LocalFinder::search_faces(const SurfaceMotion& motion, double margin) {
  const ContactSurface& surface = check_.surface;
  if (surface.searched_nodes.extent(0) == 0) return 0;
  const std::int64_t limit = std::min(find_pair_limit(share_), most_indexed_pairs);
  std::int64_t pairs = 0;
  // A search is some eighty launches, most of them of the sorts.
  run_where_it_pays(static_cast<int>(share_.searched_faces.size()) / 2, [&](const auto& space) {
    bound_faces(space, share_.bounded_faces(), motion, margin, boxes_);
    pairs = find_candidate_pairs(space, surface, {motion.x, boxes_}, limit, scratch_, all_);
    if (pairs <= limit) list_concerned(space, surface, scratch_.concerned, all_);
  });
  refuse_too_many_pairs(pairs, find_pair_limit(share_), margin);
  refuse_crowded_ranks(pairs > most_indexed_pairs ? 1 : 0);
  check_.candidates = all_;
  check_.near.forget();
  cells_.forget();
  return pairs;
}

void LocalFinder::check_pairs(const SurfaceMotion& motion, const ContactHistory& history) {
  found_before_ = found_;
  of_faces_ = check_faces(motion, history);
  found_ = of_faces_ + edges_.check(motion, history.edges);
}

/// This rank is the FE owner of all; touches that have not changed stay where they are.
int LocalFinder::send_results_to_fe_owners(const ContactHistory& /*history*/, Array<RowTouch>& touches) {
  if (has_found_nothing_new() && found_ == found_before_) return found_;
  if (of_faces_ > 0) {
    run_where_it_pays(of_faces_, [&](const auto& space) {
      collect_touches(space, check_.surface, check_.checked_pairs(), check_.touches,
                      {check_.face_numbers, node_numbers_}, touches);
    });
  }
  edges_.append_touches(of_faces_, touches);
  return found_;
}

int LocalFinder::check_faces(const SurfaceMotion& motion, const ContactHistory& history) {
  if (all_.num_pairs == 0) {
    forget_touches(check_);
    return 0;
  }
  const CandidateList& read = lists_near_ ? all_ : check_.read_pairs();
  const Array<const int> nodes = read.nodes;
  const Array<const std::int64_t> numbers = check_.face_numbers, old = history.face;
  const Array<int> history_face = check_.history_face;
  loop_where_it_pays(
      "contact::load_history", read.num_nodes, read.num_nodes, KOKKOS_LAMBDA(int i) {
        for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
          const int record = contact_limits::max_touches * nodes(i) + slot;
          history_face(record) = find_remembered_face(numbers, old(record), history_face(record));
        }
      });
  if (lists_near_) {
    cells_.update(check_.make_inputs(motion), all_);
    check_.candidates = cells_.choose(all_);
    check_.counts.candidates += all_.num_pairs - check_.candidates.num_pairs;
    check_.counts.left_out += all_.num_pairs - check_.candidates.num_pairs;
  }
  check_candidates(motion, check_);
  return check_.touches.count;
}

std::vector<Penetration> LocalFinder::find_penetrations(const SurfaceMotion& motion) {
  if (all_.num_pairs == 0) return {};
  check_.candidates = all_;
  const PenetrationTable table = measure_candidates(motion, check_);
  const auto depth = to_host(table.depth), ratio = to_host(table.ratio), limit = to_host(table.limit);
  const auto size = to_host(check_.faces.size);
  const auto face = to_host(table.face);
  std::vector<Penetration> found;
  for (int n = 0; n < check_.surface.num_nodes; ++n) {
    if (face(n) < 0) continue;
    const FaceTopology& of = share_.faces[static_cast<std::size_t>(face(n))];
    found.push_back({n, of.number, depth(n), ratio(n), size(face(n)), of.part, limit(n)});
  }
  return found;
}

std::vector<EdgePenetration> LocalFinder::find_edge_penetrations(const SurfaceMotion& motion) {
  return edges_.find_penetrations(motion);
}

std::vector<PartGap> LocalFinder::find_gaps(const SurfaceMotion& motion) {
  std::vector<int> parts;
  for (const FaceTopology& face : share_.faces) parts.push_back(face.part);
  check_.candidates = all_;
  return measure_gaps(motion, check_, parts);
}

SearchLoad LocalFinder::load() const {
  return {static_cast<std::int64_t>(check_.surface.searched_nodes.extent(0)),
          static_cast<std::int64_t>(share_.searched_faces.size())};
}

std::vector<int> LocalFinder::node_ranks() const {
  return std::vector<int>(check_.surface.searched_nodes.extent(0), 0);
}

}  // namespace percuss
