// The search in the contact decomposition, when it is due: candidate pairs, and what their check will read.

#include "src/contact/ranked_finder.hpp"

#include <algorithm>
#include <numeric>

#include "comm/item_exchange.hpp"
#include "comm/sized_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/number_map.hpp"
#include "src/contact/pair_limit.hpp"

namespace percuss {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void sort_unique(std::vector<std::int64_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::array<int, 4> find_numbers(const NumberMap& places, const std::int64_t (&wanted)[4]) {
  return {places.find(wanted[0]), places.find(wanted[1]), places.find(wanted[2]), places.find(wanted[3])};
}

SurfaceLists list_search_surface(const std::vector<NodeRecord>& nodes, const std::vector<FaceRecord>& faces) {
  SurfaceLists lists;
  std::vector<std::int64_t> numbers;
  for (const NodeRecord& node : nodes) {
    numbers.push_back(node.number);
    lists.node_class.push_back(node.surface_class);
  }
  lists.nodes.resize(nodes.size());
  std::iota(lists.nodes.begin(), lists.nodes.end(), 0);
  lists.searched_nodes = lists.nodes;
  const NumberMap places(numbers);
  for (const FaceRecord& record : faces) {
    lists.corners.push_back(find_numbers(places, record.face.corners));
    lists.backs.push_back(find_numbers(places, record.face.backs));
    lists.face_class.push_back(record.face.surface_class);
    lists.face_body.push_back(record.face.body);
  }
  lists.searched_faces.resize(faces.size());
  std::iota(lists.searched_faces.begin(), lists.searched_faces.end(), 0);
  return lists;
}

Boxes copy_boxes(const std::vector<FaceRecord>& faces) {
  const Boxes boxes("contact::received_boxes", faces.size());
  const auto host = Kokkos::create_mirror_view(boxes);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 6; ++k) host(f, k) = faces[f].box[k];
  }
  Kokkos::deep_copy(boxes, host);
  return boxes;
}

Rows3<double> copy_places(const std::vector<NodeRecord>& nodes) {
  const Rows3<double> x("contact::received_places", nodes.size());
  const auto host = Kokkos::create_mirror_view(x);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) host(n, k) = nodes[n].x[k];
  }
  Kokkos::deep_copy(x, host);
  return x;
}

}  // namespace

RankedFinder::RankedFinder(const ContactRanks& ranks, const SurfaceShare& share, ContactDeck::Rebalance rebalance,
                           SearchMethod method)
    : ranks_(ranks),
      share_(share),
      exchange_(ranks.ranks),
      data_(ranks.ranks),
      decomposition_(ranks.ranks, share, rebalance),
      edges_(ranks, share, method) {
  scratch_.method = method;
}

Traffic RankedFinder::traffic() const {
  const Traffic &own = data_.traffic(), &decomposition = decomposition_.traffic(), edges = edges_.traffic();
  return {traffic_before_.messages + own.messages + decomposition.messages + edges.messages,
          traffic_before_.bytes + own.bytes + decomposition.bytes + edges.bytes};
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
  return {static_cast<std::int64_t>(decomposition_.nodes().size()),
          static_cast<std::int64_t>(decomposition_.faces().size())};
}

int RankedFinder::find_mesh_node(std::int64_t number) const { return find_number(ranks_.mesh.node_numbers, number); }
int RankedFinder::find_contact_node(std::int64_t number) const { return find_number(share_.nodes.numbers, number); }

// (5.6), first half: which nodes are in which boxes, on every rank by itself.
std::int64_t RankedFinder::find_points_in_boxes_here(std::int64_t limit) {
  const std::vector<NodeRecord>& nodes = decomposition_.nodes();
  const std::vector<FaceRecord>& faces = decomposition_.faces();
  const ContactSurface surface = make_contact_surface(list_search_surface(nodes, faces), share_);
  const Boxes boxes = copy_boxes(faces);
  const Rows3<double> x = copy_places(nodes);
  if (scratch_.method == SearchMethod::blocks) {  // from search to search, ranks see other faces
    std::vector<std::int64_t> node_numbers, face_numbers;
    node_numbers.reserve(nodes.size());
    face_numbers.reserve(faces.size());
    for (const NodeRecord& node : nodes) node_numbers.push_back(node.number);
    for (const FaceRecord& face : faces) face_numbers.push_back(face.face.number);
    identify(node_numbers, face_numbers, scratch_.blocks);
  }
  std::int64_t pairs = 0;
  run_where_it_pays(static_cast<int>(faces.size()) / 2, [&](const auto& space) {
    pairs = find_points_in_boxes(space, surface, x, boxes, limit, scratch_, found_);
  });
  return pairs;
}

/// Puts the pairs on the host and lists the nodes and faces that have any.
void RankedFinder::list_pairs() {
  const std::size_t num_nodes = decomposition_.nodes().size();
  const auto offset = to_host(found_.offset);
  const auto face = to_host(found_.face);
  first_pair_.assign(offset.data(), offset.data() + num_nodes + 1);
  pair_face_.assign(face.data(), face.data() + found_.num_pairs);
  checked_.clear();
  for (std::size_t n = 0; n < num_nodes; ++n) {
    if (first_pair_[n] < first_pair_[n + 1]) checked_.push_back(static_cast<int>(n));
  }
  candidate_faces_ = pair_face_;
  std::sort(candidate_faces_.begin(), candidate_faces_.end());
  candidate_faces_.erase(std::unique(candidate_faces_.begin(), candidate_faces_.end()), candidate_faces_.end());
}

std::int64_t RankedFinder::search(const SurfaceMotion& motion, double margin) {
  {
    const Phase phase("percuss::contact_rcb", decomposition_clock_);
    decomposition_.update(motion, margin);
  }
  const std::int64_t of_faces = search_faces(margin);
  return of_faces + edges_.search(motion, margin, decomposition_);
}

std::int64_t RankedFinder::search_faces(double margin) {
  const std::int64_t limit = find_pair_limit(share_);
  const std::int64_t pairs = find_points_in_boxes_here(std::min(limit, most_indexed_pairs));
  std::int64_t sums[3] = {pairs, static_cast<std::int64_t>(decomposition_.faces().size()),
                          pairs > most_indexed_pairs ? 1 : 0};
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, sums, 3, MPI_INT64_T, MPI_SUM, ranks_.ranks.handle()); },
           "MPI_Allreduce");
  total_pairs_ = sums[0];
  refuse_too_many_pairs(total_pairs_, limit, margin);
  refuse_crowded_ranks(sums[2]);
  decomposition_.note_ghost_faces(sums[1] - share_.total_searched_faces);
  check_.candidates.num_pairs = 0;
  check_.candidates.num_nodes = 0;
  check_.near.forget();
  if (total_pairs_ == 0) return 0;
  list_pairs();
  std::vector<std::int64_t> nodes;
  for (const int n : checked_) nodes.push_back(decomposition_.nodes()[at(n)].number);
  for (const int f : candidate_faces_) {
    const auto& corners = decomposition_.faces()[at(f)].face.corners;
    nodes.insert(nodes.end(), std::begin(corners), std::end(corners));
  }
  sort_unique(nodes);
  build_check_space(ask_for_faces_around(nodes));
  return total_pairs_;
}

/// Asks the FE owners of nodes for all faces around these.
std::vector<FaceTopology> RankedFinder::ask_for_faces_around(const std::vector<std::int64_t>& nodes) {
  const Subscription asked = subscribe_to_contact_nodes(nodes);
  const OwnedContactNodes& own = share_.nodes;
  std::vector<int> counts;
  std::vector<FaceTopology> faces;
  for (const int n : asked.published) {
    counts.push_back(own.first_face[at(n) + 1] - own.first_face[at(n)]);
    for (int f = own.first_face[at(n)]; f < own.first_face[at(n) + 1]; ++f)
      faces.push_back(share_.face(own.faces[at(f)]));
  }
  const ExchangePlan answer = reverse(asked.request);
  std::vector<FaceTopology> received = exchange_sized(data_, answer, sum_by_run(answer.to, counts), faces);
  std::sort(received.begin(), received.end(),
            [](const FaceTopology& a, const FaceTopology& b) { return a.number < b.number; });
  received.erase(std::unique(received.begin(), received.end(),
                             [](const FaceTopology& a, const FaceTopology& b) { return a.number == b.number; }),
                 received.end());
  return received;
}

/// What the FE owners of contact nodes have of these.
Subscription RankedFinder::subscribe_to_contact_nodes(const std::vector<std::int64_t>& numbers) {
  std::vector<int> owners;
  owners.reserve(numbers.size());
  for (const std::int64_t number : numbers) owners.push_back(ranks_.numbering.find_node_owner(number));
  return subscribe(exchange_, data_, owners, numbers, [&](std::int64_t number) { return find_contact_node(number); });
}

/// The surface of the check: candidate faces, the faces around all nodes concerned, and all their nodes.
void RankedFinder::build_check_space(std::vector<FaceTopology> faces) {
  check_faces_ = std::move(faces);
  std::vector<std::int64_t> face_numbers;
  for (const FaceTopology& face : check_faces_) face_numbers.push_back(face.number);
  std::vector<int> place_of_candidate;  // of each candidate face
  std::vector<char> is_candidate(check_faces_.size(), 0);
  for (const int f : candidate_faces_) {
    place_of_candidate.push_back(find_number(face_numbers, decomposition_.faces()[at(f)].face.number));
    is_candidate[at(place_of_candidate.back())] = 1;
  }
  check_nodes_.clear();
  for (const int n : checked_) check_nodes_.push_back(decomposition_.nodes()[at(n)].number);
  const std::vector<std::int64_t> checked_numbers = check_nodes_;
  for (std::size_t f = 0; f < check_faces_.size(); ++f) {
    const FaceTopology& face = check_faces_[f];
    check_nodes_.insert(check_nodes_.end(), std::begin(face.corners), std::end(face.corners));
    if (is_candidate[f] != 0) check_nodes_.insert(check_nodes_.end(), std::begin(face.backs), std::end(face.backs));
  }
  sort_unique(check_nodes_);

  SurfaceLists lists;
  lists.nodes.resize(check_nodes_.size());
  std::iota(lists.nodes.begin(), lists.nodes.end(), 0);
  lists.node_class.assign(check_nodes_.size(), 0);
  const NumberMap places(check_nodes_);
  for (std::size_t f = 0; f < check_faces_.size(); ++f) {
    const FaceTopology& face = check_faces_[f];
    lists.corners.push_back(find_numbers(places, face.corners));
    lists.backs.push_back(is_candidate[f] != 0 ? find_numbers(places, face.backs) : std::array<int, 4>{-1, -1, -1, -1});
    lists.face_class.push_back(face.surface_class);
    lists.face_body.push_back(face.body);
    if (share_.largest_offset > 0) lists.face_offset.push_back(face.offset);
  }
  CandidateList& candidates = check_.candidates;
  std::vector<int> offset(check_nodes_.size() + 1, 0), pairs;
  checked_nodes_.clear();
  for (const std::int64_t number : checked_numbers) checked_nodes_.push_back(places.find(number));
  for (std::size_t i = 0; i < checked_.size(); ++i) {
    const auto n = at(checked_[i]);
    lists.node_class[at(checked_nodes_[i])] = decomposition_.nodes()[n].surface_class;
    offset[at(checked_nodes_[i]) + 1] = first_pair_[n + 1] - first_pair_[n];
  }
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  for (const int f : pair_face_) {  // nodes ascend here as there
    const auto place = std::lower_bound(candidate_faces_.begin(), candidate_faces_.end(), f) - candidate_faces_.begin();
    pairs.push_back(place_of_candidate[static_cast<std::size_t>(place)]);
  }
  set_surface(make_contact_surface(lists, share_), face_numbers, check_);
  candidates.num_pairs = static_cast<int>(pairs.size());
  candidates.num_nodes = static_cast<int>(checked_nodes_.size());
  candidates.num_faces = static_cast<int>(check_faces_.size());
  candidates.offset = to_view("contact::candidate_offset", offset);
  candidates.face = to_view("contact::candidate_face", pairs);
  candidates.nodes = to_view("contact::candidate_nodes", checked_nodes_);
  std::vector<int> all_faces(check_faces_.size());
  std::iota(all_faces.begin(), all_faces.end(), 0);
  candidates.faces = to_view("contact::candidate_faces", all_faces);
  candidates.is_boxed = to_view("contact::boxed_faces", std::vector<int>(is_candidate.begin(), is_candidate.end()));

  motion_.ask(ranks_, exchange_, data_, check_nodes_);
  history_ = subscribe_to_contact_nodes(checked_numbers);
}

}  // namespace percuss
