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

/// Keeps the answers for the nodes that this rank owns, each node once.
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
  if (counts.tied > 0 || tie.may_be_empty || tie.sticks == TieDeck::Sticks::on_contact) return;
  const std::string text = fmt::format(
      "{}: error: tie of '{}' and '{}' ties nothing ({} nodes of '{}' are farther than {} from it, {} are already "
      "shared by the mesh, {} are tied by an earlier tie): set the tie's distance, or "
      "empty: ignore",
      deck.where(tie.place), name_side(tie.a), name_side(tie.b), counts.apart, name_side(tie.a),
      tie.distance ? fmt::format("{:g}", *tie.distance) : fmt::format("{:g} of a face", default_tie_distance),
      counts.joined, counts.earlier);
  if (tie.when.from.empty()) throw InputError(text);
  throw RunError(text);
}

/// Living nodes and faces of both sides of a tie.
struct TieSides {
  SurfaceNodes a;
  std::vector<ElementFace> b, both_of_b;
};
TieSides select_sides(const TieScene& scene, std::size_t t) {
  const Mesh& mesh = scene.chunked.mesh;
  const TieDeck& tie = scene.deck.contact.ties[t];
  TieSides sides{select_surface_nodes(mesh, scene.deck, tie.a), select_faces(mesh, scene.deck, tie.b), {}};
  if (mesh.eroded.any) {
    const auto is_dead = [&](const ElementFace& face) { return mesh.eroded.dead[at(face.element)] != 0; };
    std::erase_if(sides.a.faces, is_dead);
    std::erase_if(sides.b, is_dead);
    std::erase_if(sides.a.nodes, [&](int node) { return mesh.eroded.nodes[at(node)] != ErodedMesh::held; });
  }
  sides.both_of_b = add_other_sides(mesh, sides.b);
  part_sides(scene.ranks, scene.deck, tie, sides.a, sides.both_of_b);
  return sides;
}

/// Gives the owners of nodes what was found for them.
void keep_found(const TieScene& scene, std::size_t t, const std::vector<int>& nodes, std::vector<ClosestFace> answers,
                TiedSurfaces& ties) {
  std::vector<int> owners;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    answers[n].found.node = scene.chunked.mesh.node_numbers[at(nodes[n])];
    owners.push_back(scene.chunked.numbering.find_node_owner(answers[n].found.node));
  }
  std::vector<ClosestFace> owned = ItemExchange(scene.ranks).send(owners, answers);
  std::stable_sort(owned.begin(), owned.end(),
                   [](const ClosestFace& p, const ClosestFace& q) { return p.found.node < q.found.node; });
  TieCounts counts;
  keep_owned(owned, static_cast<int>(t), ties.nodes, counts);
  reduce(scene.ranks, counts);
  ties.counts[t] = counts;
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
  TiedSurfaces ties;
  const std::size_t count = deck.contact.ties.size();
  ties.faces.resize(count);
  ties.known.resize(count);
  ties.counts.resize(count);
  for (std::size_t t = 0; t < count; ++t)
    if (deck.contact.ties[t].when.from.empty()) add_tied_nodes({chunked, deck, ranks, chunked.mesh.nodes}, t, ties);
  return ties;
}

void add_tied_nodes(const TieScene& scene, std::size_t t, TiedSurfaces& ties) {
  const auto& [chunked, deck, ranks, places] = scene;
  const TieDeck& tie = deck.contact.ties[t];
  ItemExchange exchange(ranks);
  const TieSides sides = select_sides(scene, t);
  const std::vector<int>& nodes = sides.a.nodes;
  refuse_no_rotations(chunked, ranks, deck, tie, nodes);
  const std::vector<double> thickness = find_node_thickness(chunked, sides.a, exchange);
  const TieSearch search{places, nodes, thickness, sides.b, tie.distance, tie.can_fail() ? &sides.a.faces : nullptr};
  std::vector<ClosestFace> answers = find_closest_faces(chunked, search, exchange);
  leave_out_what_lies_behind(chunked, search, answers, exchange);
  ties.faces[t] = {add_other_sides(chunked.mesh, keep_tied_faces(chunked.mesh, sides.a.faces, nodes, answers)),
                   sides.both_of_b};
  ties.known[t].clear();
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (is_tied(answers[n])) ties.known[t].push_back(chunked.mesh.node_numbers[at(nodes[n])]);
  keep_found(scene, t, nodes, answers, ties);
  refuse_nothing(deck, tie, ties.counts[t]);
  if (ties.counts[t].tied == 0) ties.faces[t] = {};
}

void stick_nodes(const TieScene& scene, std::size_t t, const std::vector<std::int64_t>& numbers, TiedSurfaces& ties) {
  const Mesh& mesh = scene.chunked.mesh;
  ItemExchange exchange(scene.ranks);
  const TieSides sides = select_sides(scene, t);
  const std::vector<double> half = find_node_thickness(scene.chunked, sides.a, exchange);
  std::vector<int> nodes;
  std::vector<double> thickness;
  for (std::size_t n = 0; n < sides.a.nodes.size(); ++n) {
    const std::int64_t number = mesh.node_numbers[at(sides.a.nodes[n])];
    if (!std::binary_search(numbers.begin(), numbers.end(), number)) continue;
    nodes.push_back(sides.a.nodes[n]);
    if (!half.empty()) thickness.push_back(half[n]);
  }
  const TieDeck& tie = scene.deck.contact.ties[t];
  const TieSearch search{scene.places, nodes,        thickness,
                         sides.b,      tie.distance, tie.can_fail() ? &sides.a.faces : nullptr};
  TieCounts all = ties.counts[t];
  keep_found(scene, t, nodes, find_closest_faces(scene.chunked, search, exchange), ties);
  all.tied += ties.counts[t].tied;
  ties.counts[t] = all;
}

std::array<std::vector<ElementFace>, 2> list_tied_faces(const TieScene& scene, std::size_t t,
                                                        const std::vector<std::int64_t>& tied) {
  const Mesh& mesh = scene.chunked.mesh;
  TieSides sides = select_sides(scene, t);
  std::erase_if(sides.a.faces, [&](const ElementFace& face) {
    const std::array<int, 4> corners = mesh.elements.face_nodes(face);
    return std::none_of(corners.begin(), corners.end(), [&](int node) {
      return std::binary_search(tied.begin(), tied.end(), mesh.node_numbers[at(node)]);
    });
  });
  return {add_other_sides(mesh, std::move(sides.a.faces)), sides.both_of_b};
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

std::string describe_tie(const Deck& deck, const TiedSurfaces& ties, std::size_t t) {
  const TieDeck& tie = deck.contact.ties[t];
  const TieCounts& c = ties.counts[t];
  const bool has_thickness = c.widest < c.farthest;
  const double widest = c.widest > rounding * c.farthest ? c.widest : 0;
  std::string line =
      fmt::format("{} node{} of '{}' tied to '{}' (up to {:.4g} away{}), {} not in reach", c.tied,
                  c.tied == 1 ? "" : "s", name_side(tie.a), name_side(tie.b), c.farthest,
                  has_thickness ? fmt::format(", {:.4g} beyond the thickness of shells", widest) : "", c.apart);
  if (c.tied == 0 && tie.sticks == TieDeck::Sticks::at_start)
    line = fmt::format("tie of '{}' and '{}' is ignored: it ties nothing, {} nodes not in reach", name_side(tie.a),
                       name_side(tie.b), c.apart);
  if (tie.rotations) line += ", with the rotations of shells and beams";
  if (c.joined > 0) line += fmt::format(", {} joined by the mesh", c.joined);
  if (c.earlier > 0) line += fmt::format(", {} tied by an earlier tie", c.earlier);
  if (tie.sticks == TieDeck::Sticks::on_contact) line += "; others stick as they come into contact";
  return line;
}

std::vector<std::string> describe_ties(const Deck& deck, const TiedSurfaces& ties) {
  std::vector<std::string> lines;
  for (std::size_t t = 0; t < ties.counts.size(); ++t) {
    const TieDeck& tie = deck.contact.ties[t];
    if (tie.when.from.empty())
      lines.push_back(describe_tie(deck, ties, t));
    else
      lines.push_back(fmt::format("tie of '{}' and '{}' begins with sensor '{}'", name_side(tie.a), name_side(tie.b),
                                  tie.when.from));
  }
  return lines;
}

}  // namespace percuss
