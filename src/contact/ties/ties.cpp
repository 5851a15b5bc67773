#include "src/contact/ties/ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/contact/ties/tie_search.hpp"
#include "src/contact/ties/tie_thickness.hpp"
#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Share of a distance that is none.
constexpr double rounding = 1e-9;

bool is_tied(const ClosestFace& answer) { return answer.joined == 0 && answer.found.face >= 0; }

/// The faces of which some node is tied.
std::vector<ElementFace> keep_tied_faces(const Mesh& mesh, const std::vector<ElementFace>& faces,
                                         const std::vector<int>& nodes, const std::vector<ClosestFace>& answers) {
  std::vector<ElementFace> kept;
  for (const ElementFace& f : faces) {
    const std::array<int, 4> corners = mesh.elements.face_nodes(f);
    const bool some = std::any_of(corners.begin(), corners.end(), [&](int node) {
      const auto place = std::lower_bound(nodes.begin(), nodes.end(), node);
      return place != nodes.end() && *place == node &&
             is_tied(answers[static_cast<std::size_t>(place - nodes.begin())]);
    });
    if (some) kept.push_back(f);
  }
  return kept;
}

/// What the owners of the nodes keep; each node once.
void keep_owned(const std::vector<ClosestFace>& answers, int tie, std::vector<TiedNode>& kept, TieCounts& counts) {
  std::vector<TiedNode> fresh;
  std::int64_t last = -1;
  for (const ClosestFace& answer : answers) {
    if (answer.found.node == last) continue;
    last = answer.found.node;
    const auto known = std::lower_bound(kept.begin(), kept.end(), last,
                                        [](const TiedNode& t, std::int64_t number) { return t.node < number; });
    if (answer.joined != 0) {
      ++counts.joined;
    } else if (answer.found.face < 0) {
      ++counts.apart;
    } else if (known != kept.end() && known->node == last) {
      ++counts.earlier;
    } else {
      ++counts.tied;
      counts.farthest = std::max(counts.farthest, answer.distance);
      counts.widest = std::max(counts.widest, answer.gap);
      fresh.push_back(answer.found);
      fresh.back().tie = tie;
    }
  }
  kept.insert(kept.end(), fresh.begin(), fresh.end());
  std::sort(kept.begin(), kept.end(), [](const TiedNode& a, const TiedNode& b) { return a.node < b.node; });
}

void reduce(const Communicator& ranks, TieCounts& counts) {
  std::int64_t sums[4] = {counts.tied, counts.apart, counts.joined, counts.earlier};
  all_reduce(ranks, Reduce::sum, sums);
  double largest[2] = {counts.farthest, counts.widest};
  all_reduce(ranks, Reduce::largest, largest);
  counts.farthest = largest[0];
  counts.widest = largest[1];
  counts.tied = sums[0];
  counts.apart = sums[1];
  counts.joined = sums[2];
  counts.earlier = sums[3];
}

std::string name_side(const Selector& side) { return side.name.empty() ? "all" : side.name; }

/// Refuses a tie of faces that are on both sides. A set of nodes lies on faces of other surfaces too: these are left
/// out.
void part_sides(const Communicator& ranks, const Deck& deck, const TieDeck& tie, SurfaceNodes& a,
                const std::vector<ElementFace>& b) {
  std::vector<ElementFace> others;
  std::set_difference(a.faces.begin(), a.faces.end(), b.begin(), b.end(), std::back_inserter(others));
  int some = !a.is_node_set && others.size() < a.faces.size() ? 1 : 0;
  a.faces = std::move(others);
  all_reduce(ranks, Reduce::largest, some);
  if (some != 0)
    throw InputError(
        fmt::format("{}: error: tie of '{}' and '{}' ties a surface to itself (both sides have the same faces): name "
                    "two different surfaces",
                    deck.where(tie.place), name_side(tie.a), name_side(tie.b)));
}

void refuse_nothing(const Deck& deck, const TieDeck& tie, const TieCounts& counts) {
  if (counts.tied > 0 || tie.may_be_empty) return;
  throw InputError(fmt::format(
      "{}: error: tie of '{}' and '{}' ties nothing ({} nodes of '{}' are farther than {} from it, {} are already "
      "shared by the mesh, {} are tied by an earlier tie): set the tie's distance, or "
      "empty: ignore",
      deck.where(tie.place), name_side(tie.a), name_side(tie.b), counts.apart, name_side(tie.a),
      tie.distance ? fmt::format("{:g}", *tie.distance) : fmt::format("{:g} of a face", default_tie_distance),
      counts.joined, counts.earlier));
}

/// Refuses a tie of rotations whose nodes have none.
void refuse_no_rotations(const ChunkedMesh& chunked, const Communicator& ranks, const Deck& deck, const TieDeck& tie,
                         const std::vector<int>& nodes) {
  if (!tie.rotations) return;
  const Mesh& mesh = chunked.mesh;
  int some = 0;
  for (std::size_t e = 0; e < mesh.elements.size() && some == 0; ++e) {
    if (!mesh.topology_of(e).is_surface() && !mesh.topology_of(e).is_line()) continue;
    for (const int node : mesh.corners(e)) some |= std::binary_search(nodes.begin(), nodes.end(), node) ? 1 : 0;
  }
  all_reduce(ranks, Reduce::largest, some);
  if (some == 0)
    throw InputError(
        fmt::format("{}: error: tie of '{}' and '{}' ties rotations, but no node of '{}' has one (only nodes of "
                    "shells and beams have): remove rotations, or name the shell as a",
                    deck.where(tie.place), name_side(tie.a), name_side(tie.b), name_side(tie.a)));
}

}  // namespace

TiedSurfaces find_ties(const ChunkedMesh& chunked, const Deck& deck, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  TiedSurfaces ties;
  if (deck.contact.ties.empty()) return ties;
  ItemExchange exchange(ranks);
  for (const TieDeck& tie : deck.contact.ties) {
    SurfaceNodes a = select_surface_nodes(mesh, deck, tie.a);
    const std::vector<ElementFace> b = select_faces(mesh, deck, tie.b), sides_of_b = add_other_sides(mesh, b);
    const std::vector<int>& nodes = a.nodes;
    part_sides(ranks, deck, tie, a, sides_of_b);
    refuse_no_rotations(chunked, ranks, deck, tie, nodes);
    const std::vector<double> thickness = find_node_thickness(chunked, a, exchange);
    std::vector<ClosestFace> answers = find_closest_faces(chunked, {nodes, thickness, b, tie.distance}, exchange);
    leave_out_what_lies_behind(chunked, nodes, tie.distance, answers, exchange);
    ties.faces.push_back({add_other_sides(mesh, keep_tied_faces(mesh, a.faces, nodes, answers)), sides_of_b});
    std::vector<int> owners;
    std::vector<std::int64_t>& known = ties.known.emplace_back();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      answers[n].found.node = mesh.node_numbers[at(nodes[n])];
      if (is_tied(answers[n])) known.push_back(answers[n].found.node);
      owners.push_back(chunked.numbering.find_node_owner(answers[n].found.node));
    }
    std::vector<ClosestFace> owned = exchange.send(owners, answers);
    std::stable_sort(owned.begin(), owned.end(),
                     [](const ClosestFace& p, const ClosestFace& q) { return p.found.node < q.found.node; });
    TieCounts counts;
    keep_owned(owned, static_cast<int>(ties.counts.size()), ties.nodes, counts);
    reduce(ranks, counts);
    refuse_nothing(deck, tie, counts);
    if (counts.tied == 0) ties.faces.back() = {};
    ties.counts.push_back(counts);
  }
  return ties;
}

TiedSurfaces keep_living_ties(const ChunkedMesh& chunked, const TiedSurfaces& ties, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  if (!ties.any() || !mesh.eroded.any) return ties;
  const auto is_dead = [&](const ElementFace& face) { return mesh.eroded.dead[at(face.element)] != 0; };
  const std::vector<std::int64_t> numbers = list_element_numbers(chunked);
  std::vector<std::int64_t> dead_faces;
  TiedSurfaces left = ties;
  left.nodes.clear();
  for (auto& sides : left.faces) {
    for (const ElementFace& face : sides[1])
      if (is_dead(face)) dead_faces.push_back(find_face_number(numbers[at(face.element)], face.face));
    for (auto& side : sides) side.erase(std::remove_if(side.begin(), side.end(), is_dead), side.end());
  }
  dead_faces = gather_items(ranks, dead_faces);
  std::sort(dead_faces.begin(), dead_faces.end());
  for (const TiedNode& tied : ties.nodes) {
    const bool is_held = mesh.eroded.nodes[at(find_number(mesh.node_numbers, tied.node))] == ErodedMesh::held;
    if (is_held && !std::binary_search(dead_faces.begin(), dead_faces.end(), tied.face)) left.nodes.push_back(tied);
  }
  return left;
}

std::vector<std::string> describe_ties(const Deck& deck, const TiedSurfaces& ties) {
  std::vector<std::string> lines;
  for (std::size_t t = 0; t < ties.counts.size(); ++t) {
    const TieDeck& tie = deck.contact.ties[t];
    const TieCounts& c = ties.counts[t];
    const bool has_thickness = c.widest < c.farthest;
    const double widest = c.widest > rounding * c.farthest ? c.widest : 0;
    std::string line =
        fmt::format("{} node{} of '{}' tied to '{}' (up to {:.4g} away{}), {} not in reach", c.tied,
                    c.tied == 1 ? "" : "s", name_side(tie.a), name_side(tie.b), c.farthest,
                    has_thickness ? fmt::format(", {:.4g} beyond the thickness of shells", widest) : "", c.apart);
    if (c.tied == 0)
      line = fmt::format("tie of '{}' and '{}' is ignored: it ties nothing, {} nodes not in reach", name_side(tie.a),
                         name_side(tie.b), c.apart);
    if (tie.rotations) line += ", with the rotations of shells and beams";
    if (c.joined > 0) line += fmt::format(", {} joined by the mesh", c.joined);
    if (c.earlier > 0) line += fmt::format(", {} tied by an earlier tie", c.earlier);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace percuss
