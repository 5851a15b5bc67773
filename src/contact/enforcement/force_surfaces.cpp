#include "src/contact/enforcement/force_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {
namespace {

void add(SideBits& side, std::uint32_t bit, bool is_first) { (is_first ? side.one : side.other) |= bit; }

/// Number in the whole mesh of the node at a place of the rows.
struct PlaceNumbers {
  decltype(to_host(Array<const int>())) nodes;
  decltype(to_host(Array<const std::int64_t>())) foreign, numbers;
  int num_nodes;

  std::int64_t operator()(int place) const {
    return place < num_nodes ? numbers(at(nodes(at(place)))) : foreign(at(place - num_nodes));
  }
};

/// The direction in which a face pushes, from its corners: that of a tie's row has none of its own.
template <class Places>
Point3 find_push_of_face(const ContactRow& row, const Places& x) {
  const auto corner = [&](int i) { return load_row(x, row.place[i + 1]); };
  return cross(corner(2) - corner(0), corner(3) - corner(1));
}

bool has_node(const FaceTopology& face, std::int64_t node) {
  return std::find(std::begin(face.corners), std::end(face.corners), node) != std::end(face.corners);
}

}  // namespace

bool is_surface(const Deck& deck, const Selector& side) {
  const auto is_it = [&](const PartDeck& part) { return part.name == side.name; };
  return side.inside.has_value() || std::none_of(deck.parts.begin(), deck.parts.end(), is_it);
}

ForceSurfaces::ForceSurfaces(const ContactRanks& ranks, const ChunkedMesh& chunked, const Deck& deck,
                             const SurfaceShare& share, const std::vector<ForceDeck>& forces)
    : numbering_(ranks.numbering),
      share_(share),
      exchange_(ranks.ranks),
      data_(ranks.ranks),
      areas_(ranks, share),
      faces_(share.faces.size()),
      parts_(chunked.mesh.parts.size(), 0) {
  mark_faces(chunked, deck, forces);
  std::vector<int> has(parts_.size() * forces.size());
  for (std::size_t i = 0; i < has.size(); ++i)
    has[i] = static_cast<int>(parts_[i / forces.size()] >> i % forces.size() & 1);
  all_reduce(ranks.ranks, Reduce::largest, has);
  for (std::size_t i = 0; i < has.size(); ++i)
    parts_[i / forces.size()] |= static_cast<std::uint32_t>(has[i]) << i % forces.size();
  faces_ = areas_.extend_to_foreign(std::move(faces_));
}

void ForceSurfaces::mark_faces(const ChunkedMesh& chunked, const Deck& deck, const std::vector<ForceDeck>& forces) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<std::int64_t> numbers = list_element_numbers(chunked);
  const std::vector<ElementFace> exterior = find_exterior_faces(mesh);
  const auto mark = [&](const Selector& side, std::size_t f, bool is_first) {
    if (!is_surface(deck, side)) return;
    for (const ElementFace& face : select_faces(mesh, deck, side, exterior)) {
      const std::int64_t number = find_face_number(numbers[at(face.element)], face.face);
      const auto found = std::lower_bound(share_.faces.begin(), share_.faces.end(), number,
                                          [](const FaceTopology& a, std::int64_t n) { return a.number < n; });
      if (found == share_.faces.end() || found->number != number) continue;
      add(faces_[at(found - share_.faces.begin())], std::uint32_t{1} << f, is_first);
      if (is_first) parts_[at(found->part)] |= std::uint32_t{1} << f;
    }
  };
  for (std::size_t f = 0; f < forces.size(); ++f) {
    for (const Selector& side : forces[f].on) mark(side, f, true);
    for (const Selector& side : forces[f].from) mark(side, f, false);
  }
}

/// Both sides of each row that gives something.
void ForceSurfaces::add_queries(const RowSystem& system, const Array<const std::int64_t>& node_numbers) {
  queries_.clear();
  const PlaceNumbers number{to_host(system.nodes), to_host(system.foreign_number), to_host(node_numbers),
                            system.num_nodes};
  const auto rows = to_host(system.rows);
  const auto x = to_host(system.at.x);
  for (int r = 0; r < system.num_rows; ++r) {
    const ContactRow& row = rows(at(r));
    if (row.force.x == 0 && row.force.y == 0 && row.force.z == 0) continue;
    const bool is_edge = row.kind == RowKind::edges;
    const Point3 push = row.kind == RowKind::tie ? find_push_of_face(row, x) : row.normal;
    queries_.push_back({-1, number(row.place[0]), is_edge ? number(row.place[1]) : -1, {push.x, push.y, push.z}, r, 0});
    if (row.kind == RowKind::wall) continue;
    if (is_edge)
      queries_.push_back({-1, number(row.place[2]), number(row.place[3]), {-push.x, -push.y, -push.z}, r, 1});
    else
      queries_.push_back({row.face, -1, -1, {}, r, 1});
  }
}

int ForceSurfaces::find_owner(const Query& query) const {
  return query.node >= 0 ? numbering_.find_node_owner(query.node)
                         : numbering_.find_element_owner(find_element_of_face(query.face));
}

SideBits ForceSurfaces::answer(const Query& query) const {
  if (query.node >= 0) {
    const auto& numbers = share_.nodes.numbers;
    const auto node = std::lower_bound(numbers.begin(), numbers.end(), query.node);
    if (node == numbers.end() || *node != query.node) return {};
    return answer_node(query, static_cast<int>(node - numbers.begin()));
  }
  const auto found = std::lower_bound(share_.faces.begin(), share_.faces.end(), query.face,
                                      [](const FaceTopology& a, std::int64_t n) { return a.number < n; });
  return found != share_.faces.end() && found->number == query.face ? faces_[at(found - share_.faces.begin())]
                                                                    : SideBits{};
}

/// Sides of the face around a contact node whose normal opposes the push most.
SideBits ForceSurfaces::answer_node(const Query& query, int node) const {
  const Rows3<const double>& areas = areas_.nodes().around.areas;
  SideBits bits;
  double most = -2;
  for (int k = share_.nodes.first_face[at(node)]; k < share_.nodes.first_face[at(node) + 1]; ++k) {
    const int face = share_.nodes.faces[at(k)];
    if (query.second >= 0 && !has_node(share_.face(face), query.second)) continue;
    const Point3 area = load_row(areas, face), push{query.push[0], query.push[1], query.push[2]};
    const double size = std::sqrt(dot(area, area) * dot(push, push));
    const double against = size > 0 ? -dot(area, push) / size : -1;
    if (!(against > most)) continue;
    most = against;
    bits = faces_[at(face)];
  }
  return bits;
}

/// Asks other ranks for the sides that this rank does not know.
void ForceSurfaces::ask_others(std::vector<RowSurfaces>& found) {
  std::vector<int> owners;
  std::vector<Query> asked;
  for (const Query& query : queries_) {
    const int owner = find_owner(query);
    if (owner == exchange_.ranks().rank()) continue;
    owners.push_back(owner);
    asked.push_back(query);
  }
  int some = asked.empty() ? 0 : 1;
  all_reduce(exchange_.ranks(), Reduce::largest, some);
  if (some == 0) return;
  const SendOrder order = order_by_destination(owners);
  const ExchangePlan plan = exchange_.plan(order.to);
  const std::vector<Query> sent = ItemExchange::arrange(order, asked);
  std::vector<SideBits> answers;
  for (const Query& query : data_.exchange(plan, sent)) answers.push_back(answer(query));
  const std::vector<SideBits> received = data_.exchange(reverse(plan), answers);
  for (std::size_t k = 0; k < received.size(); ++k) {
    RowSurfaces& row = found[at(sent[k].row)];
    (sent[k].is_pushing != 0 ? row.pushing : row.pushed) = received[k];
  }
}

Array<const RowSurfaces> ForceSurfaces::find(const RowSystem& system, const Array<const std::int64_t>& node_numbers,
                                             const Rows3<const double>& x) {
  areas_.update(x);
  add_queries(system, node_numbers);
  std::vector<RowSurfaces> found(at(std::max(1, system.num_rows)));
  const int own = exchange_.ranks().rank();
  for (const Query& query : queries_) {
    if (find_owner(query) != own) continue;
    RowSurfaces& row = found[at(query.row)];
    (query.is_pushing != 0 ? row.pushing : row.pushed) = answer(query);
  }
  if (exchange_.ranks().size() > 1) ask_others(found);
  return to_view("contact::row_surfaces", found);
}

}  // namespace percuss
