// The search in the contact decomposition, when it is due: candidate pairs, and what their check will read.

#include "src/contact/search/ranked_finder.hpp"

#include <algorithm>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/surface/face_corners.hpp"

namespace percuss {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool comes_before(const FaceTopology& a, const FaceTopology& b) { return a.number < b.number; }

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

/// Marks the nodes whose motion the check of a list of pairs reads. is_wanted: out, [nodes].
template <class Space>
void mark_read_nodes(const Space& space, const ContactSurface& surface, const CandidateList& pairs,
                     const Array<int>& is_wanted) {
  const ContactSurface s = surface;
  const Array<const int> faces = pairs.faces, is_boxed = pairs.is_boxed, nodes = pairs.nodes;
  Kokkos::parallel_for(
      "contact::clear_wanted", RangeOf<Space>(space, 0, s.num_nodes), KOKKOS_LAMBDA(int n) { is_wanted(n) = 0; });
  Kokkos::parallel_for(
      "contact::want_nodes", RangeOf<Space>(space, 0, pairs.num_nodes),
      KOKKOS_LAMBDA(int i) { Kokkos::atomic_assign(&is_wanted(nodes(i)), 1); });
  Kokkos::parallel_for(
      "contact::want_corners", RangeOf<Space>(space, 0, pairs.num_faces), KOKKOS_LAMBDA(int i) {
        const int f = faces(i);
        for (int c = 0; c < 4; ++c) {
          Kokkos::atomic_assign(&is_wanted(s.face_corners(f, c)), 1);
          if (is_boxed(i) != 0) Kokkos::atomic_assign(&is_wanted(s.face_backs(f, c)), 1);
        }
      });
  space.fence();
}

}  // namespace

RankedFinder::RankedFinder(const ContactRanks& ranks, const SurfaceShare& share, const ContactDeck& deck)
    : ranks_(ranks),
      share_(share),
      contact_nodes_(share.nodes.numbers),
      exchange_(ranks.ranks),
      data_(ranks.ranks),
      history_data_(ranks.ranks),
      decomposition_(ranks.ranks, share, deck.rebalance),
      edges_(ranks, share, deck) {
  scratch_.method = find_method(deck.search);
  check_.keeps_still = deck.reuse_search;
}

Traffic RankedFinder::traffic() const {
  Traffic sum = traffic_before_;
  for (const Traffic& part : {data_.traffic(), history_data_.traffic(), decomposition_.traffic(), edges_.traffic()}) {
    sum.messages += part.messages;
    sum.bytes += part.bytes;
  }
  return sum;
}

void RankedFinder::take_over(const ContactFinder& before) {
  const auto& other = dynamic_cast<const RankedFinder&>(before);  // of the same number of ranks
  check_.counts = other.check_.counts;
  decomposition_.take_over(other.decomposition_);
  decomposition_clock_ = other.decomposition_clock_;
  traffic_before_ = other.traffic();
  scratch_.blocks = other.scratch_.blocks;
}

SearchLoad RankedFinder::load() const {
  return {static_cast<std::int64_t>(decomposition_.nodes().size()), decomposition_.count_reaching_here()};
}

std::int64_t RankedFinder::search(const SurfaceMotion& motion, double margin) {
  {
    const Phase phase("percuss::contact_rcb", decomposition_clock_);
    decomposition_.update(motion, margin);  // (5.1) to (5.5)
  }
  if (decomposition_.has_changed()) redefine_surface();
  const std::int64_t of_faces = search_faces(margin);
  return of_faces + edges_.search(motion, margin, decomposition_);
}

/// The surface that this rank knows is another now: the faces that reach it, and those around its nodes and theirs.
void RankedFinder::redefine_surface() {
  number_surface(ask_for_faces_around(list_nodes_of_unknown_faces()));
  motion_.name(ranks_, exchange_, data_, nodes_);
  const std::vector<std::int64_t> searched = list_numbers(decomposition_.nodes());
  history_.name(exchange_, data_, NodeOwners(ranks_.numbering).find(searched), searched,
                [&](std::int64_t number) { return find_contact_node(number); });
  // From search to search, ranks see other faces.
  if (scratch_.method == SearchMethod::blocks)
    identify(searched, list_numbers(decomposition_.faces()), scratch_.blocks);
}

/// The searched nodes of this rank around which there are more faces than it was told of, and the other corners of
/// faces, of which it does not know. Ascending.
std::vector<std::int64_t> RankedFinder::list_nodes_of_unknown_faces() const {
  const std::vector<NodeRecord>& searched = decomposition_.nodes();
  NumberMap places;
  places.reserve(searched.size() + decomposition_.faces().size());
  for (const NodeRecord& node : searched) places.add(node.number);
  std::vector<int> faces(searched.size(), 0);  // around each that this rank was told of
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

/// Asks the FE owners of nodes for all faces around these. Each tells of a face once.
std::vector<FaceTopology> RankedFinder::ask_for_faces_around(const std::vector<std::int64_t>& nodes) {
  RemoteItems asked;
  asked.name(exchange_, data_, NodeOwners(ranks_.numbering).find(nodes), nodes,
             [&](std::int64_t number) { return find_contact_node(number); });
  const OwnedContactNodes& own = share_.nodes;
  std::vector<int> told(share_.faces.size() + share_.told_faces.size(), -1);  // the last who was
  std::vector<FaceTopology> faces;
  const auto tell = [&](int whom, int node) {
    for (int f = own.first_face[at(node)]; f < own.first_face[at(node) + 1]; ++f) {
      const int face = own.faces[at(f)];
      if (told[at(face)] == whom) continue;
      told[at(face)] = whom;
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
    return std::binary_search(searched.begin(), searched.end(), face, comes_before);
  });
  std::sort(more.begin(), more.end(), comes_before);
  more.erase(std::unique(more.begin(), more.end(),
                         [](const FaceTopology& a, const FaceTopology& b) { return a.number == b.number; }),
             more.end());
  faces_.resize(searched.size() + more.size());
  std::merge(searched.begin(), searched.end(), more.begin(), more.end(), faces_.begin(), comes_before);

  SurfaceLists lists;
  NumberMap found;
  found.reserve(decomposition_.nodes().size() + faces_.size());
  for (const NodeRecord& node : decomposition_.nodes()) found.add(node.number);
  std::vector<char> is_searched;
  is_searched.reserve(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const std::size_t next = lists.searched_faces.size();
    is_searched.push_back(next < searched.size() && searched[next].number == faces_[f].number ? 1 : 0);
    for (const std::int64_t corner : faces_[f].corners) found.add(corner);
    if (is_searched[f] == 0) continue;
    lists.searched_faces.push_back(static_cast<int>(f));
    for (const std::int64_t back : faces_[f].backs) found.add(back);
  }
  nodes_ = found.numbers();
  std::sort(nodes_.begin(), nodes_.end());
  const NumberMap places(nodes_);
  lists.nodes.resize(nodes_.size());
  std::iota(lists.nodes.begin(), lists.nodes.end(), 0);
  lists.node_class.assign(nodes_.size(), 0);
  searched_nodes_.clear();
  for (const NodeRecord& node : decomposition_.nodes()) {
    searched_nodes_.push_back(places.find(node.number));
    lists.node_class[at(searched_nodes_.back())] = node.surface_class;
  }
  lists.searched_nodes = searched_nodes_;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const FaceTopology& face = faces_[f];
    lists.corners.push_back(find_numbers(places, face.corners));
    lists.backs.push_back(is_searched[f] != 0 ? find_numbers(places, face.backs) : std::array<int, 4>{-1, -1, -1, -1});
    lists.face_class.push_back(face.surface_class);
    lists.face_body.push_back(face.body);
    if (share_.largest_offset > 0) lists.face_offset.push_back(face.offset);
  }
  set_surface(make_contact_surface(lists, share_), list_numbers(faces_), check_);
  reserve(places_, check_.surface.num_nodes);
}

// (5.6), first half: which nodes are in which boxes, on every rank by itself.
std::int64_t RankedFinder::find_points_in_boxes_here(std::int64_t limit) {
  const ContactSurface& surface = check_.surface;
  const Array<const int> nodes = surface.searched_nodes;
  const Rows3<const double> found = decomposition_.places();
  const Rows3<double> x = places_;
  std::int64_t pairs = 0;
  run_where_it_pays(static_cast<int>(decomposition_.faces().size()) / 2, [&](const auto& space) {
    Kokkos::parallel_for(
        "contact::searched_places", RangeOf<std::decay_t<decltype(space)>>(space, 0, static_cast<int>(nodes.extent(0))),
        KOKKOS_LAMBDA(int i) { store_row(x, nodes(i), load_row(found, i)); });
    pairs = find_points_in_boxes(space, surface, x, decomposition_.boxes(), limit, scratch_, check_.candidates);
    if (pairs <= limit) list_concerned(space, surface, scratch_.concerned, check_.candidates);
  });
  return pairs;
}

std::int64_t RankedFinder::search_faces(double margin) {
  const std::int64_t limit = find_pair_limit(share_);
  const std::int64_t pairs = find_points_in_boxes_here(std::min(limit, most_indexed_pairs));
  std::int64_t sums[3] = {pairs, decomposition_.reaching_faces(), pairs > most_indexed_pairs ? 1 : 0};
  all_reduce(ranks_.ranks, Reduce::sum, sums);
  total_pairs_ = sums[0];
  refuse_too_many_pairs(total_pairs_, limit, margin);
  refuse_crowded_ranks(sums[2]);
  decomposition_.note_ghost_faces(sums[1] - share_.total_searched_faces);
  check_.near.forget();
  read_ = base_ = &of_all_;
  asked_ = {};
  if (total_pairs_ > 0) of_all_ = select(check_.candidates);
  return total_pairs_;
}

/// Tells the FE owners what the check of a list of pairs reads. Collective.
RankedFinder::CheckPart RankedFinder::select(const CandidateList& pairs) {
  reserve(wanted_, check_.surface.num_nodes);
  run_where_it_pays(check_.surface.num_nodes / 10,
                    [&](const auto& space) { mark_read_nodes(space, check_.surface, pairs, wanted_); });
  const auto marks = to_host(wanted_);
  CheckPart part;
  part.motion = motion_.select(data_, {marks.data(), marks.data() + check_.surface.num_nodes});
  const auto nodes = to_host(pairs.nodes);
  std::vector<char> is_checked;
  is_checked.reserve(searched_nodes_.size());
  int next = 0;
  for (const int n : searched_nodes_) {
    is_checked.push_back(next < pairs.num_nodes && nodes(next) == n ? 1 : 0);
    next += is_checked.back();
  }
  part.history = history_.select(history_data_, is_checked);
  const auto list_rows = [&](const std::vector<int>& searched) {
    std::vector<int> rows;
    rows.reserve(searched.size());
    for (const int i : searched) rows.push_back(searched_nodes_[at(i)]);
    return to_view("contact::history_rows", rows);
  };
  part.history_rows = list_rows(part.history.asked);
  part.own_history_rows = list_rows(part.history.own);
  part.own_history_places = to_view("contact::own_history", part.history.own_places);
  part.published_history = to_view("contact::published_history", part.history.published);
  return part;
}

void RankedFinder::narrow(const NearWay& way) {
  check_.near.ask(way);
  asked_ = way;
  if (!way.keeps_first) base_ = &of_all_;
  read_ = base_;
}

/// After a check that made lists: from now on what is read for these. All ranks come here in the same step, also those
/// that have not found theirs worth it.
void RankedFinder::select_near() {
  if (asked_.search > 0) {
    of_reachable_ = select(check_.reachable_pairs());
    base_ = &of_reachable_;
  }
  read_ = base_;
  if (asked_.near > 0) {
    of_near_ = select(check_.checked_pairs());
    read_ = &of_near_;
  }
  asked_ = {};
}

}  // namespace percuss
