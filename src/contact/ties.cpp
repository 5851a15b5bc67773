#include "src/contact/ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "src/contact/gather_items.hpp"
#include "src/contact/number_map.hpp"
#include "src/contact/surface_share.hpp"
#include "src/contact/tie_search.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Nodes of faces, ascending.
std::vector<int> list_nodes(const Mesh& mesh, const std::vector<ElementFace>& faces) {
  std::vector<int> nodes;
  for (const ElementFace& f : faces)
    for (const int corner : hex_faces[f.face]) nodes.push_back(mesh.elements[at(f.element)][at(corner)]);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

bool is_tied(const ClosestFace& answer) { return answer.joined == 0 && answer.found.face >= 0; }

/// The faces of which some node is tied.
std::vector<ElementFace> keep_tied_faces(const Mesh& mesh, const std::vector<ElementFace>& faces,
                                         const std::vector<int>& nodes, const std::vector<ClosestFace>& answers) {
  std::vector<ElementFace> kept;
  for (const ElementFace& f : faces) {
    const bool some = std::any_of(hex_faces[f.face], hex_faces[f.face] + 4, [&](int corner) {
      const int node = mesh.elements[at(f.element)][at(corner)];
      return is_tied(
          answers[static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin())]);
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
      fresh.push_back(answer.found);
      fresh.back().tie = tie;
    }
  }
  kept.insert(kept.end(), fresh.begin(), fresh.end());
  std::sort(kept.begin(), kept.end(), [](const TiedNode& a, const TiedNode& b) { return a.node < b.node; });
}

void reduce(const Communicator& ranks, TieCounts& counts) {
  std::int64_t sums[4] = {counts.tied, counts.apart, counts.joined, counts.earlier};
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, sums, 4, MPI_INT64_T, MPI_SUM, ranks.handle()); }, "MPI_Allreduce");
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, &counts.farthest, 1, MPI_DOUBLE, MPI_MAX, ranks.handle()); },
           "MPI_Allreduce");
  counts.tied = sums[0];
  counts.apart = sums[1];
  counts.joined = sums[2];
  counts.earlier = sums[3];
}

std::string name_side(const Selector& side) { return side.name.empty() ? "all" : side.name; }

void refuse_self(const Communicator& ranks, const Deck& deck, const TieDeck& tie, const std::vector<ElementFace>& a,
                 const std::vector<ElementFace>& b) {
  std::vector<ElementFace> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  int some = both.empty() ? 0 : 1;
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, &some, 1, MPI_INT, MPI_MAX, ranks.handle()); }, "MPI_Allreduce");
  if (some != 0)
    throw InputError(
        fmt::format("{}: error: tie of '{}' and '{}' ties a surface to itself (both sides have the same "
                    "faces) name two surfaces",
                    deck.where(tie.place), name_side(tie.a), name_side(tie.b)));
}

void refuse_nothing(const Deck& deck, const TieDeck& tie, const TieCounts& counts) {
  if (counts.tied > 0) return;
  throw InputError(fmt::format(
      "{}: error: tie of '{}' and '{}' ties nothing ({} nodes of '{}' are farther than {} from it, {} the mesh joins, "
      "{} "
      "are tied by an earlier tie) set the tie's distance",
      deck.where(tie.place), name_side(tie.a), name_side(tie.b), counts.apart, name_side(tie.a),
      tie.distance ? fmt::format("{:g}", *tie.distance) : fmt::format("{:g} of a face", default_tie_distance),
      counts.joined, counts.earlier));
}

}  // namespace

TiedSurfaces find_ties(const ChunkedMesh& chunked, const Deck& deck, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  TiedSurfaces ties;
  if (deck.contact.ties.empty()) return ties;
  ItemExchange exchange(ranks);
  for (const TieDeck& tie : deck.contact.ties) {
    const std::vector<ElementFace> a = select_faces(mesh, deck, tie.a), b = select_faces(mesh, deck, tie.b);
    refuse_self(ranks, deck, tie, a, b);
    const std::vector<int> nodes = list_nodes(mesh, a);
    std::vector<ClosestFace> answers = find_closest_faces(chunked, b, tie.distance, nodes, exchange);
    ties.faces.push_back({keep_tied_faces(mesh, a, nodes, answers), b});
    std::vector<int> owners;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      answers[n].found.node = mesh.node_numbers[at(nodes[n])];
      owners.push_back(chunked.numbering.find_node_owner(answers[n].found.node));
    }
    std::vector<ClosestFace> owned = exchange.send(owners, answers);
    std::stable_sort(owned.begin(), owned.end(),
                     [](const ClosestFace& p, const ClosestFace& q) { return p.found.node < q.found.node; });
    TieCounts counts;
    keep_owned(owned, static_cast<int>(ties.counts.size()), ties.nodes, counts);
    reduce(ranks, counts);
    refuse_nothing(deck, tie, counts);
    ties.counts.push_back(counts);
  }
  return ties;
}

TiedSurfaces keep_living_ties(const ChunkedMesh& chunked, const TiedSurfaces& ties, const Communicator& ranks) {
  if (!ties.any()) return ties;
  const Mesh& mesh = chunked.mesh;
  const auto is_dead = [&](const ElementFace& face) { return mesh.eroded.dead[at(face.element)] != 0; };
  const std::vector<std::int64_t> numbers = list_element_numbers(chunked);
  std::vector<std::int64_t> dead_faces;
  TiedSurfaces left = ties;
  left.nodes.clear();
  for (auto& sides : left.faces) {
    for (const ElementFace& face : sides[1])
      if (is_dead(face)) dead_faces.push_back(6 * numbers[at(face.element)] + face.face);
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
    std::string line = fmt::format("{} node{} of '{}' tied to '{}' (up to {:.4g} away), {} not in reach", c.tied,
                                   c.tied == 1 ? "" : "s", name_side(tie.a), name_side(tie.b), c.farthest, c.apart);
    if (c.joined > 0) line += fmt::format(", {} joined by the mesh", c.joined);
    if (c.earlier > 0) line += fmt::format(", {} tied by an earlier tie", c.earlier);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace percuss
