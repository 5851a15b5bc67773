#include "src/contact/ties/tie_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "src/contact/surface/surface_share.hpp"
#include "src/contact/ties/tie_thickness.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

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
  double reach = 0;      // how far from its surface nodes are tied to it
  double thickness = 0;  // half that of a shell
  double box_reach = 0;  // how far from its mesh any node is
  double size = 0;       // shortest edge
};

/// Where is the closest face? Asked of every rank whose faces may be in reach.
struct Query {
  std::int64_t node = -1;
  Vec3 x{};
  double thickness = 0;  // half that of shells
  int asker = 0;
  Vec3 outward{};  // unit normal of a face of side a at the node; zero: any face of side b will do
};

FacePoints load_face(const std::vector<Vec3>& x, const Face& face, const Vec3& origin) {
  FacePoints points;
  for (std::size_t i = 0; i < 4; ++i) points.corner[i] = to_point(x[at(face.corners[i])]) - to_point(origin);
  return points;
}

std::vector<Face> list_faces(const ChunkedMesh& chunked, const TieSearch& search) {
  const Mesh& mesh = chunked.mesh;
  const double thickest = find_largest_half_thickness(mesh);
  const std::vector<std::int64_t> numbers = list_element_numbers(chunked);
  std::vector<Face> faces;
  for (const ElementFace& f : search.faces) {
    Face face;
    face.number = find_face_number(numbers[at(f.element)], f.face);
    face.element = f.element;
    face.corners = mesh.elements.face_nodes(f);
    face.size = find_shortest_edge(load_face(search.places, face, search.places[at(face.corners[0])]));
    face.reach = search.distance.value_or(default_tie_distance * face.size);
    face.thickness = find_half_thickness(mesh, f);
    face.box_reach = face.reach + (face.thickness + thickest);
    faces.push_back(face);
  }
  return faces;
}

Box find_reach(const std::vector<Vec3>& x, const Face& face) {
  Box box;
  for (const int corner : face.corners) box.add(x[at(corner)]);
  box.widen(face.box_reach);
  return box;
}

/// TiedNode::side. Nodes on a solid are outside of it, wherever the gap or the overlap of the start puts them.
int find_side(const TieGeometry& tie, bool is_shell) {
  constexpr double least = 1e-6;  // share of the face
  if (!is_shell) return 1;
  const double height = dot(find_face_normal(tie.face), tie.offset);
  if (height > least * tie.size) return 1;
  return height < -least * tie.size ? -1 : 0;
}

/// Distances that differ by round-off are one.
double find_key(double distance, double size) {
  constexpr double least = 1e-6;
  return distance <= least * size ? 0 : static_cast<double>(static_cast<float>(distance));
}

/// ClosestFace::facing, in quarters; shells look both ways.
int find_facing(const TieGeometry& tie, const Face& face, const Query& query) {
  constexpr double classes = 4;
  const double cosine = dot(find_face_normal(tie.face), to_point(query.outward));
  const bool is_shell = face.thickness > 0 || query.thickness > 0;
  return static_cast<int>(std::lround(classes * (is_shell ? -std::abs(cosine) : cosine)));
}

/// Judges one node by one face; the face must not belong to an element of the node.
void judge(const Mesh& mesh, const std::vector<Vec3>& x, const Face& face, const Query& query, ClosestFace& best) {
  for (const int corner : face.corners)
    if (mesh.node_numbers[at(corner)] == query.node) best.joined = 1;
  for (const int node : mesh.corners(at(face.element)))
    if (mesh.node_numbers[at(node)] == query.node) return;
  const FacePoints points = load_face(x, face, query.x);
  const FacePoint closest = find_closest_point(points);
  const double gap = closest.distance - (face.thickness + query.thickness);
  if (!(gap <= face.reach)) return;
  ClosestFace answer;
  answer.distance = closest.distance;
  answer.gap = gap;
  answer.found.node = query.node;
  answer.found.face = face.number;
  answer.found.geometry.face = center_face(points);
  const bool is_any = query.outward == Vec3{};
  answer.key = is_any ? closest.distance : find_key(closest.distance, face.size);
  answer.facing = is_any ? 0 : find_facing(answer.found.geometry, face, query);
  if (!answer.is_better_than(best)) return;
  for (std::size_t i = 0; i < 4; ++i) {
    answer.found.corners[i] = mesh.node_numbers[at(face.corners[i])];
    answer.found.geometry.weight[i] = closest.weight[i];
  }
  answer.found.geometry.offset = -interpolate(points, closest.weight);
  answer.found.geometry.size = face.size;
  answer.found.side = find_side(answer.found.geometry, face.thickness > 0);
  if (query.thickness > 0) answer.found.own_share = query.thickness / (query.thickness + face.thickness);
  answer.joined = best.joined;
  best = answer;
}

/// The closest face of this rank for each query: nodes sorted along the axis on which they lie farthest apart.
std::vector<ClosestFace> answer_queries(const Mesh& mesh, const std::vector<Vec3>& x, const std::vector<Face>& faces,
                                        const std::vector<Query>& queries) {
  std::vector<ClosestFace> answers(queries.size());
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
    const Box box = find_reach(x, face);
    auto next = std::lower_bound(order.begin(), order.end(), box.low[axis],
                                 [&](std::size_t i, double low) { return queries[i].x[axis] < low; });
    for (; next != order.end() && queries[*next].x[axis] <= box.high[axis]; ++next)
      if (box.holds(queries[*next].x)) judge(mesh, x, face, queries[*next], answers[*next]);
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

/// The normals of the faces of side a at each node, as many as this rank has; where there are none, one of no length.
std::vector<std::vector<Vec3>> list_outward(const Mesh& mesh, const TieSearch& search) {
  std::vector<std::vector<Vec3>> outward(search.nodes.size());
  for (std::size_t f = 0; search.facing != nullptr && f < search.facing->size(); ++f) {
    Face face;
    face.corners = mesh.elements.face_nodes((*search.facing)[f]);
    const Point3 normal = find_face_normal(center_face(load_face(search.places, face, Vec3{})));
    for (const int node : face.corners) {
      const auto place = std::lower_bound(search.nodes.begin(), search.nodes.end(), node);
      if (place != search.nodes.end() && *place == node)
        outward[static_cast<std::size_t>(place - search.nodes.begin())].push_back({normal.x, normal.y, normal.z});
    }
  }
  for (std::vector<Vec3>& normals : outward)
    if (normals.empty()) normals.push_back({});
  return outward;
}

/// The best answer for each node of this rank.
std::vector<ClosestFace> keep_best(const Mesh& mesh, const std::vector<int>& nodes,
                                   const std::vector<ClosestFace>& answers) {
  std::vector<ClosestFace> best(nodes.size());
  for (const ClosestFace& answer : answers) {
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), answer.found.node,
                                        [&](int n, std::int64_t number) { return mesh.node_numbers[at(n)] < number; });
    ClosestFace& so_far = best[static_cast<std::size_t>(place - nodes.begin())];
    const int joined = std::max(so_far.joined, answer.joined);
    if (answer.is_better_than(so_far)) so_far = answer;
    so_far.joined = joined;
  }
  return best;
}

/// Ranks that share a node know different faces of side a around it: all of them take the best of their answers.
void agree(const ChunkedMesh& chunked, const std::vector<int>& nodes, ItemExchange& exchange,
           std::vector<ClosestFace>& best) {
  struct Reply {
    ClosestFace answer;
    int asker = 0;
  };
  const Mesh& mesh = chunked.mesh;
  std::vector<Reply> known;
  std::vector<int> owners;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    best[i].found.node = mesh.node_numbers[at(nodes[i])];
    known.push_back({best[i], exchange.ranks().rank()});
    owners.push_back(chunked.numbering.find_node_owner(best[i].found.node));
  }
  std::vector<Reply> received = exchange.send(owners, known);
  std::map<std::int64_t, ClosestFace> of_node;
  for (const Reply& t : received) {
    ClosestFace& so_far = of_node[t.answer.found.node];
    if (t.answer.is_better_than(so_far)) so_far = t.answer;
  }
  std::vector<int> askers;
  std::vector<ClosestFace> answers;
  for (const Reply& t : received) {
    askers.push_back(t.asker);
    answers.push_back(of_node[t.answer.found.node]);
    answers.back().found.node = t.answer.found.node;
    answers.back().joined = t.answer.joined;
  }
  best = keep_best(mesh, nodes, exchange.send(askers, answers));
}

}  // namespace

std::vector<ClosestFace> find_closest_faces(const ChunkedMesh& chunked, const TieSearch& search,
                                            ItemExchange& exchange) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<int>& nodes = search.nodes;
  const std::vector<Face> faces = list_faces(chunked, search);
  Box own;
  for (const Face& face : faces) {
    const Box reach = find_reach(search.places, face);
    own.add({reach.low[0], reach.low[1], reach.low[2]});
    own.add({reach.high[0], reach.high[1], reach.high[2]});
  }
  const std::vector<Box> boxes = gather_boxes(exchange.ranks(), own);
  std::vector<int> destinations;
  std::vector<Query> queries;
  const std::vector<std::vector<Vec3>> outward = list_outward(mesh, search);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int n = nodes[i];
    const double thickness = search.thickness.empty() ? 0 : search.thickness[i];
    for (std::size_t r = 0; r < boxes.size(); ++r) {
      if (!boxes[r].holds(search.places[at(n)])) continue;
      for (const Vec3& normal : outward[i]) {
        destinations.push_back(static_cast<int>(r));
        queries.push_back({mesh.node_numbers[at(n)], search.places[at(n)], thickness, exchange.ranks().rank(), normal});
      }
    }
  }
  const std::vector<Query> asked = exchange.send(destinations, queries);
  std::vector<ClosestFace> given = answer_queries(mesh, search.places, faces, asked);
  std::vector<int> askers;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    given[i].found.node = asked[i].node;
    askers.push_back(asked[i].asker);
  }
  std::vector<ClosestFace> best = keep_best(mesh, nodes, exchange.send(askers, given));
  if (search.facing != nullptr) agree(chunked, nodes, exchange, best);
  return best;
}

}  // namespace percuss
