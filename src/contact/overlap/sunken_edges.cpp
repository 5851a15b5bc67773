#include "src/contact/overlap/sunken_edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "src/contact/overlap/box_list.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr int points_of_piece = 3;
/// Closest points that are as far but for round-off: the most opposed face has the side (it is the one that is not seen
/// past an edge).
constexpr double tie = 1 + 1e-9;

/// Faces of a body of solids on a rank.
struct BodyShare {
  int body = 0, rank = 0;
  HostBox box;
  double shortest = 1e300, sum = 0;  // of edges; of the diagonals of its faces [length]
  std::int64_t faces = 0;
};

/// A point on an edge, on its way to ranks with faces of other bodies.
struct EdgePoint {
  int place = 0, home = 0;  // among the points of its home
  int body = 0;             // body of its edge
  int surface_class = 0;
  double reach = 0;  // reach of the body that it may be in [length]
  int in = 0;        // that body
  Point3 x{};
};

/// A point of this rank's edges.
struct HomePoint {
  int edge = 0;  // place in SurfaceShare::edges
  Point3 x{};
};

/// Where a body has its face that is closest to a point.
struct NearestFace {
  int place = 0, home = 0, in = 0;  // of EdgePoint
  int part = 0;
  bool may_touch = false, is_inside = false;
  double distance = 1e300, facing = 0, size = 0;

  /// Takes the other if it is closer, or as close and seen less aslant.
  void take(const NearestFace& other) {
    const bool is_closer = other.distance * tie < distance;
    if (is_closer || (other.distance < distance * tie && other.facing > facing)) *this = other;
  }
};

Point3 find_place(const HostPlaces& x, int node) { return {x(node, 0), x(node, 1), x(node, 2)}; }

FacePoints load_face(const SurfaceShare& share, const HostPlaces& x, std::size_t face, const Point3& origin) {
  FacePoints points;
  for (std::size_t k = 0; k < 4; ++k) points.corner[k] = find_place(x, share.face_corners[face][k]) - origin;
  return points;
}

std::vector<BodyShare> list_bodies(const Communicator& ranks, const SurfaceShare& share, const HostPlaces& x) {
  std::map<int, BodyShare> own;
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    if (share.faces[f].offset > 0) continue;
    const FacePoints face = load_face(share, x, f, {});
    BodyShare& body = own[share.faces[f].body];
    body.body = share.faces[f].body;
    body.rank = ranks.rank();
    for (const Point3& corner : face.corner) body.box.add(corner);
    body.shortest = std::min(body.shortest, find_shortest_edge(face));
    body.sum += norm(face.corner[2] - face.corner[0]);
    ++body.faces;
  }
  std::vector<BodyShare> list;
  list.reserve(own.size());
  for (const auto& [number, body] : own) list.push_back(body);
  return gather_items(ranks, list);
}

/// How far from a body's surface points are looked at, and the least depth that counts, by body.
struct BodyReach {
  double reach = 0, least = 1e300;
};

std::map<int, BodyReach> find_reaches(const std::vector<BodyShare>& bodies, double least) {
  std::map<int, BodyReach> reaches;
  std::map<int, std::int64_t> faces;
  for (const BodyShare& body : bodies) {
    BodyReach& of = reaches[body.body];
    of.reach += body.sum;
    of.least = std::min(of.least, least * body.shortest);
    faces[body.body] += body.faces;
  }
  for (auto& [body, of] : reaches) of.reach /= static_cast<double>(faces[body]);
  return reaches;
}

bool is_beam(const EdgeTopology& edge) { return edge.wings[0] == edge.ends[0] && edge.wings[1] == edge.ends[1]; }

/// A face of this rank at an edge whose home it is.
const FaceTopology& find_home_face(const SurfaceShare& share, const EdgeTopology& edge) {
  return *std::lower_bound(
      share.faces.begin(), share.faces.end(), edge.elements[0],
      [](const FaceTopology& face, std::int64_t element) { return find_element_of_face(face.number) < element; });
}

/// Calls visit(point) for each of an edge.
template <class Visit>
void visit_points(const SurfaceShare& share, const HostPlaces& x, std::size_t edge, const Visit& visit) {
  const Point3 from = find_place(x, share.edge_ends[edge][0]);
  const Point3 along = find_place(x, share.edge_ends[edge][1]) - from;
  const int count = points_of_piece * share.edges[edge].pieces;
  for (int i = 0; i < count; ++i) visit(from + ((i + 0.5) / count) * along);
}

/// Points to send, with their ranks: those that are in the box of another body by more than counts.
struct SentPoints {
  std::vector<HomePoint> home;
  std::vector<EdgePoint> points;
  std::vector<int> to;
};

SentPoints find_points(const SurfaceShare& share, const HostPlaces& x, const std::vector<BodyShare>& bodies,
                       const std::map<int, BodyReach>& reaches, BoxList& boxes) {
  SentPoints sent;
  for (std::size_t e = 0; e < share.edges.size(); ++e) {
    const EdgeTopology& edge = share.edges[e];
    if (edge.is_blunt != 0 || is_beam(edge)) continue;
    const int body = find_home_face(share, edge).body;
    visit_points(share, x, e, [&](const Point3& point) {
      const std::size_t before = sent.points.size();
      boxes.visit_around(point, [&](int item) {
        const BodyShare& in = bodies[at(item)];
        const double reach = reaches.at(in.body).reach + edge.offset;
        if (in.body == body) return;
        sent.points.push_back(
            {static_cast<int>(sent.home.size()), edge.home, body, edge.surface_class, reach, in.body, point});
        sent.to.push_back(in.rank);
      });
      if (sent.points.size() > before) sent.home.push_back({static_cast<int>(e), point});
    });
  }
  return sent;
}

NearestFace look_at(const SurfaceShare& share, const FacePoints& face, std::size_t f, const EdgePoint& point) {
  NearestFace found{point.place, point.home, point.in, share.faces[f].part};
  const FacePoint closest = find_closest_point(face);
  const double height = -dot(closest.normal, interpolate(face, closest.weight));
  found.is_inside = height < 0;
  found.facing = closest.distance > 0 ? std::abs(height) / closest.distance : 1;
  found.distance = closest.distance;
  found.size = find_shortest_edge(face);
  return found;
}

/// The faces of this rank that are closest to points it was sent.
std::vector<NearestFace> find_closest_faces(const SurfaceShare& share, const HostPlaces& x,
                                            const std::vector<EdgePoint>& points, std::int64_t& tests) {
  std::vector<NearestFace> closest;
  if (points.empty()) return closest;
  std::map<int, double> reach;  // by body
  for (const EdgePoint& point : points) reach[point.in] = std::max(reach[point.in], point.reach);
  std::vector<HostBox> list;
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    const auto wanted = reach.find(share.faces[f].body);
    if (wanted == reach.end() || share.faces[f].offset > 0) continue;
    HostBox& box = list.emplace_back();
    for (const Point3& corner : load_face(share, x, f, {}).corner) box.add(corner);
    box.widen(wanted->second);
    box.item = static_cast<int>(f);
  }
  BoxList boxes(std::move(list));
  const auto friction = to_host(share.pair_friction);
  for (const EdgePoint& point : points) {
    NearestFace least;
    boxes.visit_around(point.x, [&](int f) {
      const FaceTopology& of = share.faces[at(f)];
      if (of.body != point.in) return;
      NearestFace found = look_at(share, load_face(share, x, at(f), point.x), at(f), point);
      found.may_touch = friction(point.surface_class * share.num_classes + of.surface_class) >= 0;
      least.take(found);
    });
    if (least.distance <= point.reach) closest.push_back(least);
  }
  tests += boxes.tests();
  return closest;
}

/// The deepest point of each of this rank's edges. closest: by ranks.
std::vector<SunkenEdge> find_deepest(const SurfaceShare& share, const SentPoints& sent,
                                     const std::vector<NearestFace>& closest, double least) {
  std::map<std::pair<int, int>, NearestFace> by_body;  // by place and body
  for (const NearestFace& face : closest) by_body[{face.place, face.in}].take(face);
  std::map<int, SunkenEdge> deepest;  // by place of the edge
  for (const auto& [key, face] : by_body) {
    const HomePoint& point = sent.home[at(key.first)];
    const EdgeTopology& edge = share.edges[at(point.edge)];
    const double depth = edge.offset + (face.is_inside ? face.distance : -face.distance);
    if (!face.may_touch || !(depth > least * face.size)) continue;
    const SunkenEdge found{
        edge.number, {edge.ends[0], edge.ends[1]},     find_home_face(share, edge).part, face.part, depth,
        face.size,   {point.x.x, point.x.y, point.x.z}};
    SunkenEdge& best = deepest[point.edge];
    if (best.edge < 0 || found.ratio() > best.ratio()) best = found;
  }
  std::vector<SunkenEdge> list;
  list.reserve(deepest.size());
  for (const auto& [place, edge] : deepest) list.push_back(edge);
  return list;
}

}  // namespace

SunkenEdges find_sunken_edges(const Communicator& ranks, const SurfaceShare& share, const Rows3<const double>& places,
                              double least) {
  SunkenEdges result;
  if (share.total_edges == 0) return result;
  const auto x = to_host(places);
  const std::vector<BodyShare> bodies = list_bodies(ranks, share, x);
  const std::map<int, BodyReach> reaches = find_reaches(bodies, least);
  std::vector<HostBox> list;
  for (const BodyShare& body : bodies) {
    HostBox& box = list.emplace_back(body.box);
    // A point that deep inside is as far from the sides of the box of the body; the share of a rank may end anywhere.
    const BodyReach& of = reaches.at(body.body);
    box.widen(ranks.size() > 1 ? of.reach + share.largest_offset : share.largest_offset - of.least);
    box.item = static_cast<int>(list.size()) - 1;
  }
  BoxList boxes(std::move(list));
  const SentPoints sent = find_points(share, x, bodies, reaches, boxes);
  result.tests = boxes.tests() + static_cast<std::int64_t>(share.faces.size());
  ItemExchange exchange(ranks);
  const std::vector<NearestFace> found =
      find_closest_faces(share, x, exchange.send(sent.to, sent.points), result.tests);
  std::vector<int> homes;
  homes.reserve(found.size());
  for (const NearestFace& face : found) homes.push_back(face.home);
  result.found = find_deepest(share, sent, exchange.send(homes, found), least);
  all_reduce(ranks, Reduce::largest, result.tests);
  return result;
}

}  // namespace percuss
