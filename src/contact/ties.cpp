#include "src/contact/ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "comm/item_exchange.hpp"
#include "src/contact/surface_share.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Point3 to_point(const Vec3& x) { return {x[0], x[1], x[2]}; }

/// Lowest x, y, z, highest x, y, z; empty at first.
struct Box {
  static constexpr double far = std::numeric_limits<double>::infinity();
  double low[3] = {far, far, far}, high[3] = {-far, -far, -far};

  void add(const Vec3& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  void widen(double by) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] -= by;
      high[k] += by;
    }
  }
  bool holds(const Vec3& x) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (!(x[k] >= low[k] && x[k] <= high[k])) return false;
    return true;
  }
};

/// A face of side b on its rank.
struct Face {
  std::int64_t number = 0;
  std::array<int, 4> corners{};  // mesh nodes
  int element = 0;
  double reach = 0;  // within which nodes are tied to it
  double size = 0;   // shortest edge
};

/// Where is the closest face? Asked of every rank whose faces may be in reach.
struct Query {
  std::int64_t node = -1;
  Vec3 x{};
  int asker = 0;
};

/// The closest face of one rank.
struct Answer {
  double distance = std::numeric_limits<double>::infinity();
  int joined = 0;  // the node is a corner of side b
  TiedNode found;

  bool is_better_than(const Answer& other) const {
    return distance != other.distance ? distance < other.distance : found.face < other.found.face;
  }
};

FacePoints load_face(const Mesh& mesh, const Face& face, const Vec3& origin) {
  FacePoints points;
  for (std::size_t i = 0; i < 4; ++i) points.corner[i] = to_point(mesh.nodes[at(face.corners[i])]) - to_point(origin);
  return points;
}

std::vector<Face> list_faces(const ChunkedMesh& chunked, const std::vector<ElementFace>& selected,
                             const std::optional<double>& distance) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<std::int64_t> numbers = number_elements(chunked);
  std::vector<Face> faces;
  for (const ElementFace& f : selected) {
    Face face;
    face.number = 6 * numbers[at(f.element)] + f.face;
    face.element = f.element;
    for (std::size_t i = 0; i < 4; ++i) face.corners[i] = mesh.elements[at(f.element)][at(hex_faces[f.face][i])];
    face.size = find_shortest_edge(load_face(mesh, face, mesh.nodes[at(face.corners[0])]));
    face.reach = distance.value_or(default_tie_distance * face.size);
    faces.push_back(face);
  }
  return faces;
}

Box find_reach(const Mesh& mesh, const Face& face) {
  Box box;
  for (const int corner : face.corners) box.add(mesh.nodes[at(corner)]);
  box.widen(face.reach);
  return box;
}

/// Judges one node by one face; the face must not belong to an element of the node.
void judge(const Mesh& mesh, const Face& face, const Query& query, Answer& best) {
  for (const int corner : face.corners)
    if (mesh.node_numbers[at(corner)] == query.node) best.joined = 1;
  for (const int node : mesh.elements[at(face.element)])
    if (mesh.node_numbers[at(node)] == query.node) return;
  const FacePoints points = load_face(mesh, face, query.x);
  const FacePoint closest = find_closest_point(points);
  if (!(closest.distance <= face.reach)) return;
  Answer answer;
  answer.distance = closest.distance;
  answer.found.node = query.node;
  answer.found.face = face.number;
  if (!answer.is_better_than(best)) return;
  for (std::size_t i = 0; i < 4; ++i) {
    answer.found.corners[i] = mesh.node_numbers[at(face.corners[i])];
    answer.found.geometry.weight[i] = closest.weight[i];
  }
  answer.found.geometry.offset = -interpolate(points, closest.weight);
  answer.found.geometry.face = center_face(points);
  answer.found.geometry.size = face.size;
  answer.joined = best.joined;
  best = answer;
}

/// The closest face of this rank for each query: nodes sorted along the axis on which they lie farthest apart.
std::vector<Answer> answer_queries(const Mesh& mesh, const std::vector<Face>& faces,
                                   const std::vector<Query>& queries) {
  std::vector<Answer> answers(queries.size());
  if (queries.empty()) return answers;
  Box all;
  for (const Query& query : queries) all.add(query.x);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (all.high[k] - all.low[k] > all.high[axis] - all.low[axis]) axis = k;
  std::vector<std::size_t> order(queries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return queries[a].x[axis] < queries[b].x[axis]; });
  for (const Face& face : faces) {
    const Box box = find_reach(mesh, face);
    auto next = std::lower_bound(order.begin(), order.end(), box.low[axis],
                                 [&](std::size_t i, double low) { return queries[i].x[axis] < low; });
    for (; next != order.end() && queries[*next].x[axis] <= box.high[axis]; ++next)
      if (box.holds(queries[*next].x)) judge(mesh, face, queries[*next], answers[*next]);
  }
  return answers;
}

/// One box of each rank.
std::vector<Box> gather_boxes(const Communicator& ranks, const Box& own) {
  std::vector<Box> boxes(at(ranks.size()));
  static_assert(sizeof(Box) == 6 * sizeof(double));
  wait_mpi([&] { return MPI_Allgather(&own, 6, MPI_DOUBLE, boxes.data(), 6, MPI_DOUBLE, ranks.handle()); },
           "MPI_Allgather");
  return boxes;
}

/// Nodes of faces, ascending.
std::vector<int> list_nodes(const Mesh& mesh, const std::vector<ElementFace>& faces) {
  std::vector<int> nodes;
  for (const ElementFace& f : faces)
    for (const int corner : hex_faces[f.face]) nodes.push_back(mesh.elements[at(f.element)][at(corner)]);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The closest face of any rank for each of `nodes`.
std::vector<Answer> find_closest_faces(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<int>& nodes,
                                       ItemExchange& exchange) {
  Box own;
  for (const Face& face : faces) {
    const Box reach = find_reach(mesh, face);
    own.add({reach.low[0], reach.low[1], reach.low[2]});
    own.add({reach.high[0], reach.high[1], reach.high[2]});
  }
  const std::vector<Box> boxes = gather_boxes(exchange.ranks(), own);
  std::vector<int> destinations;
  std::vector<Query> queries;
  for (const int n : nodes) {
    for (std::size_t r = 0; r < boxes.size(); ++r) {
      if (!boxes[r].holds(mesh.nodes[at(n)])) continue;
      destinations.push_back(static_cast<int>(r));
      queries.push_back({mesh.node_numbers[at(n)], mesh.nodes[at(n)], exchange.ranks().rank()});
    }
  }
  const std::vector<Query> asked = exchange.send(destinations, queries);
  std::vector<Answer> given = answer_queries(mesh, faces, asked);
  std::vector<int> askers;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    given[i].found.node = asked[i].node;
    askers.push_back(asked[i].asker);
  }
  std::vector<Answer> best(nodes.size());
  for (const Answer& answer : exchange.send(askers, given)) {
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), answer.found.node,
                                        [&](int n, std::int64_t number) { return mesh.node_numbers[at(n)] < number; });
    Answer& so_far = best[static_cast<std::size_t>(place - nodes.begin())];
    const int joined = std::max(so_far.joined, answer.joined);
    if (answer.is_better_than(so_far)) so_far = answer;
    so_far.joined = joined;
  }
  return best;
}

bool is_tied(const Answer& answer) { return answer.joined == 0 && answer.found.face >= 0; }

/// The faces of which some node is tied.
std::vector<ElementFace> keep_tied_faces(const Mesh& mesh, const std::vector<ElementFace>& faces,
                                         const std::vector<int>& nodes, const std::vector<Answer>& answers) {
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
void keep_owned(const std::vector<Answer>& answers, int tie, std::vector<TiedNode>& kept, TieCounts& counts) {
  std::vector<TiedNode> fresh;
  std::int64_t last = -1;
  for (const Answer& answer : answers) {
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
    std::vector<Answer> answers = find_closest_faces(mesh, list_faces(chunked, b, tie.distance), nodes, exchange);
    ties.faces.push_back({keep_tied_faces(mesh, a, nodes, answers), b});
    std::vector<int> owners;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      answers[n].found.node = mesh.node_numbers[at(nodes[n])];
      owners.push_back(chunked.numbering.find_node_owner(answers[n].found.node));
    }
    std::vector<Answer> owned = exchange.send(owners, answers);
    std::stable_sort(owned.begin(), owned.end(),
                     [](const Answer& p, const Answer& q) { return p.found.node < q.found.node; });
    TieCounts counts;
    keep_owned(owned, static_cast<int>(ties.counts.size()), ties.nodes, counts);
    reduce(ranks, counts);
    refuse_nothing(deck, tie, counts);
    ties.counts.push_back(counts);
  }
  return ties;
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
