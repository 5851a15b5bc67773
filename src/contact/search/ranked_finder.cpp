#include "src/contact/search/ranked_finder.hpp"

#include <algorithm>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/surface/face_corners.hpp"
#include "src/index.hpp"

namespace percuss {

namespace {

bool has_lower_number(const FaceTopology& a, const FaceTopology& b) { return a.number < b.number; }

template <class Record>
std::vector<std::int64_t> list_numbers(const std::vector<Record>& records) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(records.size());
  for (const Record& record : records) numbers.push_back(record.number);
  return numbers;
}

std::array<int, 4> find_numbers(const NumberMap& places, const std::int64_t (&wanted)[4]) {
  return {places.find(wanted[0]), places.find(wanted[1]), places.find(wanted[2]), places.find(wanted[3])};
}

/// Numbers the nodes of known faces and of what is behind the searched ones. known: in, its faces; out, all of it.
SurfaceLists list_surface(const std::vector<NodeRecord>& searched_nodes, const std::vector<double>& radii,
                          const std::vector<FaceTopology>& searched_faces, bool has_offsets, KnownSurface& known) {
  SurfaceLists lists;
  NumberMap found;
  found.reserve(searched_nodes.size() + known.faces.size());
  for (const NodeRecord& node : searched_nodes) found.add(node.number);
  std::vector<char> is_searched;
  is_searched.reserve(known.faces.size());
  for (std::size_t f = 0; f < known.faces.size(); ++f) {
    const std::size_t next = lists.searched_faces.size();
    is_searched.push_back(next < searched_faces.size() && searched_faces[next].number == known.faces[f].number ? 1 : 0);
    for (const std::int64_t corner : known.faces[f].corners) found.add(corner);
    if (is_searched[f] == 0) continue;
    lists.searched_faces.push_back(static_cast<int>(f));
    for (const std::int64_t back : known.faces[f].backs) found.add(back);
  }
  known.nodes = found.numbers();
  std::sort(known.nodes.begin(), known.nodes.end());
  const NumberMap places(known.nodes);
  lists.nodes.resize(known.nodes.size());
  std::iota(lists.nodes.begin(), lists.nodes.end(), 0);
  lists.node_class.assign(known.nodes.size(), 0);
  for (const NodeRecord& node : searched_nodes) {
    known.searched_nodes.push_back(places.find(node.number));
    lists.node_class[at(known.searched_nodes.back())] = node.surface_class;
  }
  if (!radii.empty()) lists.node_radius.assign(known.nodes.size(), 0);
  for (std::size_t n = 0; n < radii.size(); ++n) lists.node_radius[at(known.searched_nodes[n])] = radii[n];
  lists.searched_nodes = known.searched_nodes;
  for (std::size_t f = 0; f < known.faces.size(); ++f) {
    const FaceTopology& face = known.faces[f];
    lists.corners.push_back(find_numbers(places, face.corners));
    lists.backs.push_back(is_searched[f] != 0 ? find_numbers(places, face.backs) : std::array<int, 4>{-1, -1, -1, -1});
    lists.face_class.push_back(face.surface_class);
    lists.face_body.push_back(face.body);
    if (has_offsets) lists.face_offset.push_back(face.offset);
  }
  return lists;
}

}  // namespace

RankedFinder::RankedFinder(const ContactRanks& ranks, const SurfaceShare& share, const ContactDeck& deck)
    : ranks_(ranks),
      share_(share),
      exchange_(ranks.ranks),
      data_(ranks.ranks),
      decomposition_(ranks.ranks, share, deck.rebalance),
      check_(ranks, share, data_, deck.reuse_search),
      edges_(ranks, share, deck) {
  scratch_.method = find_method(deck.search);
}

Traffic RankedFinder::traffic() const {
  Traffic sum = traffic_before_;
  for (const Traffic& part : {data_.traffic(), check_.traffic(), decomposition_.traffic(), edges_.traffic()}) {
    sum.messages += part.messages;
    sum.bytes += part.bytes;
  }
  return sum;
}

void RankedFinder::take_over(const ContactFinder& before) {
  const auto& other = dynamic_cast<const RankedFinder&>(before);  // of the same number of ranks
  check_.space().counts = other.check_.space().counts;
  decomposition_.take_over(other.decomposition_);
  decomposition_clock_ = other.decomposition_clock_;
  traffic_before_ = other.traffic();
  scratch_.blocks = other.scratch_.blocks;
}

SearchLoad RankedFinder::load() const {
  return {static_cast<std::int64_t>(decomposition_.nodes().size()), decomposition_.count_reaching_here()};
}

void RankedFinder::send_contact_data_to_previous_owners(const SurfaceMotion& motion) {
  const Phase phase = decompose();
  decomposition_.send_contact_data_to_previous_owners(motion);
}

void RankedFinder::rebalance() {
  const Phase phase = decompose();
  decomposition_.rebalance();
}

void RankedFinder::share_cuts() {
  const Phase phase = decompose();
  decomposition_.share_cuts();
}

void RankedFinder::send_points_to_owners(const SurfaceMotion& motion) {
  {
    const Phase phase = decompose();
    decomposition_.send_points_to_owners();
  }
  edges_.send_points_to_owners(motion, decomposition_);
}

void RankedFinder::find_reached_ranks(const SurfaceMotion& motion, double margin) {
  {
    const Phase phase = decompose();
    decomposition_.find_reached_ranks(motion, margin);
  }
  edges_.find_reached_ranks(motion, margin);
}

void RankedFinder::send_overlapping_faces(const SurfaceMotion& motion) {
  {
    const Phase phase = decompose();
    decomposition_.send_overlapping_faces();
  }
  if (decomposition_.has_changed()) redefine_surface();
  edges_.send_overlapping_edges(motion);
}

std::int64_t RankedFinder::find_candidates(const SurfaceMotion& /*motion*/, double margin) {
  const std::int64_t of_faces = search_faces(margin);
  return of_faces + edges_.find_candidates(margin);
}

void RankedFinder::check_pairs(const SurfaceMotion& motion, const ContactHistory& history) {
  check_.check(motion, history);
  edges_.check(motion, history.edges);
}

int RankedFinder::send_results_to_fe_owners(const ContactHistory& history, Array<RowTouch>& touches) {
  std::vector<RowTouch> rows = check_.send_results_to_fe_owners();
  edges_.append_touches(history.edges, rows);
  reserve(touches, static_cast<int>(rows.size()));
  Kokkos::View<const RowTouch*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> host(rows.data(),
                                                                                                 rows.size());
  copy_values(Kokkos::subview(touches, std::pair<std::size_t, std::size_t>(0, rows.size())), host);
  return static_cast<int>(rows.size());
}

/// The surface that this rank knows is another now: the faces that reach it, and those around its nodes and theirs.
void RankedFinder::redefine_surface() {
  number_surface(ask_for_faces_around(list_nodes_of_unknown_faces()));
  // From search to search, ranks see other faces.
  if (scratch_.method == SearchMethod::blocks)
    identify(list_numbers(decomposition_.nodes()), list_numbers(decomposition_.faces()), scratch_.blocks);
}

/// The searched nodes of this rank with faces around them that it does not know yet, and the other corners of its
/// faces. Ascending.
std::vector<std::int64_t> RankedFinder::list_nodes_of_unknown_faces() const {
  const std::vector<NodeRecord>& searched = decomposition_.nodes();
  NumberMap places;
  places.reserve(searched.size() + decomposition_.faces().size());
  for (const NodeRecord& node : searched) places.add(node.number);
  std::vector<int> faces(searched.size(), 0);  // around each that this rank received
  for (const FaceTopology& face : decomposition_.faces()) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto place = at(places.add(face.corners[i]));
      if (place < faces.size() && !is_repeated(face.corners, i)) ++faces[place];
    }
  }
  std::vector<std::int64_t> unknown;
  for (std::size_t n = 0; n < searched.size(); ++n)
    if (faces[n] < searched[n].faces) unknown.push_back(searched[n].number);
  unknown.insert(unknown.end(), places.numbers().begin() + static_cast<std::ptrdiff_t>(searched.size()),
                 places.numbers().end());
  std::sort(unknown.begin(), unknown.end());
  return unknown;
}

/// Requests from the FE owners of nodes all faces around these. Each sends a face once.
std::vector<FaceTopology> RankedFinder::ask_for_faces_around(const std::vector<std::int64_t>& nodes) {
  RemoteItems asked;
  asked.name(exchange_, data_, NodeOwners(ranks_.numbering).find(nodes), nodes,
             [&](std::int64_t number) { return check_.find_contact_node(number); });
  const OwnedContactNodes& own = share_.nodes;
  std::vector<int> last_rank(share_.faces.size() + share_.foreign_faces.size(), -1);  // the last rank that got each
  std::vector<FaceTopology> faces;
  const auto tell = [&](int whom, int node) {
    for (int f = own.first_face[at(node)]; f < own.first_face[at(node) + 1]; ++f) {
      const int face = own.faces[at(f)];
      if (last_rank[at(face)] == whom) continue;
      last_rank[at(face)] = whom;
      faces.push_back(share_.face(face));
    }
  };
  std::vector<int> counts;
  const ExchangePlan answer = reverse(asked.all().request);
  for (const PeerRun& run : answer.to) {
    const std::size_t before = faces.size();
    for (std::int64_t k = run.first; k < run.first + run.count; ++k)
      tell(run.rank, asked.all().published[static_cast<std::size_t>(k)]);
    counts.push_back(static_cast<int>(faces.size() - before));
  }
  std::vector<FaceTopology> received = data_.exchange_sized(answer, counts, faces);
  faces.clear();
  for (const int node : asked.all().own_places) tell(ranks_.ranks.rank(), node);
  received.insert(received.end(), faces.begin(), faces.end());
  return received;
}

/// Numbers the nodes and faces that this rank knows: those of the decomposition and more, in any order, some of them
/// twice.
void RankedFinder::number_surface(std::vector<FaceTopology> more) {
  const std::vector<FaceTopology>& searched = decomposition_.faces();
  std::erase_if(more, [&](const FaceTopology& face) {
    return std::binary_search(searched.begin(), searched.end(), face, has_lower_number);
  });
  std::sort(more.begin(), more.end(), has_lower_number);
  more.erase(std::unique(more.begin(), more.end(),
                         [](const FaceTopology& a, const FaceTopology& b) { return a.number == b.number; }),
             more.end());
  KnownSurface known;
  known.faces.resize(searched.size() + more.size());
  std::merge(searched.begin(), searched.end(), more.begin(), more.end(), known.faces.begin(), has_lower_number);
  const SurfaceLists lists =
      list_surface(decomposition_.nodes(), decomposition_.radii(), searched, share_.largest_offset > 0, known);
  check_.take_surface(std::move(known), make_contact_surface(lists, share_), exchange_);
  reserve(places_, check_.space().surface.num_nodes);
}

/// Pairs of nodes and the boxes that they are in, on every rank by itself.
std::int64_t RankedFinder::find_candidate_pairs_here(std::int64_t limit) {
  const ContactSurface& surface = check_.space().surface;
  CandidateList& candidates = check_.space().candidates;
  const Array<const int> nodes = surface.searched_nodes;
  const Rows3<const double> found = decomposition_.places();
  const Rows3<double> x = places_;
  std::int64_t pairs = 0;
  const int items = static_cast<int>(decomposition_.faces().size()) / 2;
  loop_where_it_pays(
      "contact::searched_places", static_cast<int>(nodes.extent(0)), items,
      KOKKOS_LAMBDA(int i) { store_row(x, nodes(i), load_row(found, i)); });
  run_where_it_pays(items, [&](const auto& space) {
    pairs = find_candidate_pairs(space, surface, {x, decomposition_.boxes()}, limit, scratch_, candidates);
    if (pairs <= limit) list_concerned(space, surface, scratch_.concerned, candidates);
  });
  return pairs;
}

std::int64_t RankedFinder::search_faces(double margin) {
  const std::int64_t limit = find_pair_limit(share_);
  const std::int64_t pairs = find_candidate_pairs_here(std::min(limit, most_indexed_pairs));
  std::int64_t sums[3] = {pairs, decomposition_.reaching_faces(), pairs > most_indexed_pairs ? 1 : 0};
  all_reduce(ranks_.ranks, Reduce::sum, sums);
  refuse_too_many_pairs(sums[0], limit, margin);
  refuse_crowded_ranks(sums[2]);
  decomposition_.decide_rebalance(sums[1] - share_.total_searched_faces);
  check_.begin_pairs(sums[0]);
  return sums[0];
}

}  // namespace percuss
