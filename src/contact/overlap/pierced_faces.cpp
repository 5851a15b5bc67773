#include "src/contact/overlap/pierced_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/overlap/box_tree.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Places on an edge that differ by no more than this are one.
constexpr double same_place = 1e-9;

using HostPlaces = decltype(to_host(Rows3<const double>()));

/// A side of a face, where it is looked for in the faces of a body.
struct FaceSide {
  std::int64_t ends[2];  // numbers of its nodes, ascending
  int body, part, surface_class;
  int in;  // the body that it is looked for in
};

/// The same with its place, as it goes to ranks with faces of that body.
struct TravellingEdge : FaceSide {
  Point3 x[2];
};

/// Where an edge meets a triangle of a face's fan.
struct Piercing {
  TravellingEdge edge;
  std::int64_t face = -1;  // number
  int triangle = 0, part = 0;
  double share = 0;  // of the way from end 0 to end 1
  double size = 0;   // shortest edge of the face
  double rim = 0;    // distance of the place from where the sheet ends, if that is a side of the face

  auto key() const { return std::tuple(edge.ends[0], edge.ends[1], edge.in, share, face, triangle); }
  bool is_of_same(const Piercing& other) const {
    return edge.ends[0] == other.edge.ends[0] && edge.ends[1] == other.edge.ends[1] && edge.in == other.edge.in;
  }
};

/// What a rank has of a body's faces.
struct BodyFaces {
  int body = 0, rank = 0;
  HostBox box;
  int has_shells = 0;
};

/// The faces of a rank at the places of a moment; of the two sides of a shell one.
class FaceIndex {
 public:
  FaceIndex(const SurfaceShare& share, const HostPlaces& x) : share_(share), x_(x) {
    std::map<int, std::vector<HostBox>> boxes;
    for (std::size_t f = 0; f < share.faces.size(); ++f) {
      if (is_second_side(f)) continue;
      kept_.push_back(f);
      HostBox box;
      for (const Point3& corner : load(f, {}).corner) box.add(corner);
      box.item = static_cast<int>(f);
      boxes[share.faces[f].body].push_back(box);
    }
    for (auto& [body, list] : boxes) trees_.emplace(body, BoxTree(std::move(list)));
    mark_rims();
    choose_sides();
  }

  bool is_rim(std::size_t face, std::size_t side) const {
    return std::binary_search(rims_.begin(), rims_.end(), list_side(face, side));
  }

  FacePoints load(std::size_t face, const Point3& origin) const {
    FacePoints points;
    for (std::size_t k = 0; k < 4; ++k) points.corner[k] = load_row(x_, share_.face_corners[face][k]) - origin;
    return points;
  }

  /// Numbers of the ends of a side, ascending.
  std::pair<std::int64_t, std::int64_t> list_side(std::size_t face, std::size_t side) const {
    const auto& corners = share_.faces[face].corners;
    return std::minmax(corners[side], corners[(side + 1) % 4]);
  }

  std::vector<BodyFaces> list_bodies(int rank) const {
    std::map<int, BodyFaces> own;
    for (const std::size_t f : kept_) {
      BodyFaces& body = own[share_.faces[f].body];
      body.body = share_.faces[f].body;
      body.rank = rank;
      for (const Point3& corner : load(f, {}).corner) body.box.add(corner);
      if (share_.faces[f].offset > 0) body.has_shells = 1;
    }
    std::vector<BodyFaces> list;
    list.reserve(own.size());
    for (const auto& [number, body] : own) list.push_back(body);
    return list;
  }

  /// Calls visit(side) for those of a face that no face of a lower number has.
  template <class Visit>
  void visit_sides(std::size_t face, const Visit& visit) const {
    for (std::size_t k = 0; k < 4; ++k)
      if ((sides_[face] & (1U << k)) != 0) visit(k);
  }

  FaceSide name(std::size_t face, std::size_t side, int in) const {
    const auto [first, last] = list_side(face, side);
    const FaceTopology& of = share_.faces[face];
    return {{first, last}, of.body, of.part, of.surface_class, in};
  }
  TravellingEdge load_edge(std::size_t face, std::size_t side, int in) const {
    TravellingEdge edge{name(face, side, in), {}};
    const std::size_t next = (side + 1) % 4;
    const bool is_forward = share_.faces[face].corners[side] == edge.ends[0];
    edge.x[0] = load_row(x_, share_.face_corners[face][is_forward ? side : next]);
    edge.x[1] = load_row(x_, share_.face_corners[face][is_forward ? next : side]);
    return edge;
  }
  HostBox bound_side(std::size_t face, std::size_t side) const {
    HostBox box;
    for (const std::size_t k : {side, (side + 1) % 4}) box.add(load_row(x_, share_.face_corners[face][k]));
    return box;
  }

  BoxTree* find_tree(int body) {
    const auto tree = trees_.find(body);
    return tree == trees_.end() ? nullptr : &tree->second;
  }
  std::int64_t tests() const {
    std::int64_t sum = 0;
    for (const auto& [body, tree] : trees_) sum += tree.tests();
    return sum;
  }

 private:
  bool is_second_side(std::size_t face) const {
    const std::vector<FaceTopology>& faces = share_.faces;
    return face > 0 && faces[face].offset > 0 &&
           find_element_of_face(faces[face].number) == find_element_of_face(faces[face - 1].number);
  }

  void mark_rims() {
    for (const EdgeTopology& edge : share_.edges)
      if (edge.elements[0] == edge.elements[1]) rims_.emplace_back(edge.ends[0], edge.ends[1]);
    std::sort(rims_.begin(), rims_.end());
  }

  /// Of each two nodes the first side between them, by lists of such second nodes.
  void choose_sides() {
    struct Other {
      int node, next;
    };
    std::vector<int> first(x_.extent(0), -1);
    std::vector<Other> others;
    others.reserve(2 * kept_.size());
    sides_.assign(share_.faces.size(), 0);
    for (const std::size_t f : kept_)
      for (std::size_t k = 0; k < 4; ++k) {
        const auto& corners = share_.face_corners[f];
        const auto [a, b] = std::minmax(corners[k], corners[(k + 1) % 4]);
        int place = first[at(a)];
        while (place >= 0 && others[at(place)].node != b) place = others[at(place)].next;
        if (a == b || place >= 0) continue;
        others.push_back({b, first[at(a)]});
        first[at(a)] = static_cast<int>(others.size()) - 1;
        sides_[f] |= 1U << k;
      }
  }

  const SurfaceShare& share_;
  const HostPlaces& x_;
  std::vector<std::size_t> kept_;
  std::vector<unsigned> sides_;  // [faces] bits of those of visit_sides()
  std::map<int, BoxTree> trees_;
  std::vector<std::pair<std::int64_t, std::int64_t>> rims_;  // ends of the edges where shells of this rank end
};

/// Whether an edge has an end in common with the element behind a face: where that turns inside out it goes through
/// itself.
bool are_joined(const FaceSide& edge, const FaceTopology& face) {
  for (const std::int64_t end : edge.ends)
    for (int k = 0; k < 4; ++k)
      if (face.corners[k] == end || face.backs[k] == end) return true;
  return false;
}

/// The share of the way from `from` at which a line meets a triangle, negative if it does not.
/// Source: Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection, J. Graphics Tools 2 (1997).
double find_meeting(const Point3& from, const Point3& way, const Point3 (&triangle)[3]) {
  const Point3 e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0], s = from - triangle[0];
  const Point3 h = cross(way, e2), q = cross(s, e1);
  const double determinant = dot(e1, h);
  if (determinant == 0) return -1;
  const double u = dot(s, h) / determinant, v = dot(way, q) / determinant, t = dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t <= 1 ? t : -1;
}

double find_rim_distance(const FaceIndex& index, std::size_t f, const FacePoints& face, const Point3& p) {
  double least = 1e300;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!index.is_rim(f, k)) continue;
    const Point3 a = face.corner[k], along = face.corner[(k + 1) % 4] - a;
    const double square = dot(along, along);
    const double place = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
    least = std::min(least, norm(p - (a + place * along)));
  }
  return least;
}

HostBox bound(const TravellingEdge& edge) {
  HostBox box;
  box.add(edge.x[0]);
  box.add(edge.x[1]);
  return box;
}

/// Adds where an edge meets the fan of a face.
void find_piercings(const FaceIndex& index, const FaceTopology& of, std::size_t f, const TravellingEdge& edge,
                    std::vector<Piercing>& found) {
  const FacePoints face = index.load(f, edge.x[0]);
  const Point3 way = edge.x[1] - edge.x[0], middle = find_middle(face);
  for (int k = 0; k < 4; ++k) {
    const double share = find_meeting({}, way, {middle, face.corner[k], face.corner[(k + 1) % 4]});
    if (share < 0) continue;
    found.push_back(
        {edge, of.number, k, of.part, share, find_shortest_edge(face), find_rim_distance(index, f, face, share * way)});
  }
}

/// Looks where edges go through the faces of this rank.
class PiercingLook {
 public:
  PiercingLook(const SurfaceShare& share, FaceIndex& index, PiercedPairs pairs)
      : share_(share), index_(index), pairs_(pairs), friction_(to_host(share.pair_friction)) {}

  /// Those of a body of this rank, in a body of this rank.
  void look_at(const BoxTree& faces, int in) {
    index_.find_tree(in)->visit_pairs(faces, [&](const HostBox& other, const HostBox& own) {
      const std::size_t f = at(own.item), of = at(other.item);
      index_.visit_sides(f, [&](std::size_t side) {
        if (index_.bound_side(f, side).meets(other) && may_pierce(index_.name(f, side, in), share_.faces[of]))
          find_piercings(index_, share_.faces[of], of, index_.load_edge(f, side, in), found_);
      });
    });
  }

  /// Those that this rank was sent.
  void look_at(const std::vector<TravellingEdge>& edges) {
    for (const TravellingEdge& edge : edges)
      index_.find_tree(edge.in)->visit_meeting(bound(edge), [&](int f) {
        const FaceTopology& of = share_.faces[at(f)];
        if (may_pierce(edge, of)) find_piercings(index_, of, at(f), edge, found_);
      });
  }

  const std::vector<Piercing>& found() const { return found_; }

 private:
  bool may_pierce(const FaceSide& edge, const FaceTopology& of) const {
    if (edge.body != edge.in && !(of.offset > 0)) return false;
    if (pairs_ == PiercedPairs::that_may_touch &&
        !(friction_(edge.surface_class * share_.num_classes + of.surface_class) >= 0))
      return false;
    return !are_joined(edge, of);
  }

  const SurfaceShare& share_;
  FaceIndex& index_;
  PiercedPairs pairs_;
  decltype(to_host(SurfaceShare::pair_friction)) friction_;
  std::vector<Piercing> found_;
};

/// Looks at the edges of this rank in their own body, and in shells in whose box they are: here, or where these are.
std::vector<Piercing> look_through(const Communicator& ranks, const std::vector<BodyFaces>& bodies, FaceIndex& index,
                                   BoxTree& boxes, PiercingLook& look) {
  std::vector<TravellingEdge> edges;
  std::vector<int> to;
  const auto send = [&](const BodyFaces& faces, const BodyFaces& in) {
    for (const HostBox& face : index.find_tree(faces.body)->boxes())
      index.visit_sides(at(face.item), [&](std::size_t side) {
        if (!index.bound_side(at(face.item), side).meets(in.box)) return;
        edges.push_back(index.load_edge(at(face.item), side, in.body));
        to.push_back(in.rank);
      });
  };
  for (const BodyFaces& own : bodies) {
    if (own.rank != ranks.rank()) continue;
    boxes.visit_meeting(own.box, [&](int item) {
      const BodyFaces& in = bodies[at(item)];
      if (in.body != own.body && in.has_shells == 0) return;
      if (in.rank == ranks.rank())
        look.look_at(*index.find_tree(own.body), in.body);
      else
        send(own, in);
    });
  }
  ItemExchange exchange(ranks);
  look.look_at(exchange.send(to, edges));
  return gather_items(ranks, look.found());
}

/// The places of an edge by which its depth is known: its ends, where one of them is on the other side, else three
/// between the first place at which it goes through and the next.
struct EdgeSamples {
  bool is_end_behind = false;
  Point3 x[3];
};

EdgeSamples choose_samples(const std::vector<Piercing>& piercings, std::size_t first, std::size_t last) {
  const TravellingEdge& edge = piercings[first].edge;
  const auto place = [&](double share) { return edge.x[0] + share * (edge.x[1] - edge.x[0]); };
  if ((last - first) % 2 == 1) return {true, {edge.x[0], edge.x[1], edge.x[1]}};
  const double from = piercings[first].share, to = piercings[first + 1].share;
  return {false, {place(0.75 * from + 0.25 * to), place(0.5 * (from + to)), place(0.25 * from + 0.75 * to)}};
}

/// The least distance of a place from the faces of this rank that an edge may go through, if it is less than `reach`.
double find_distance(const SurfaceShare& share, FaceIndex& index, const TravellingEdge& edge, const Point3& x,
                     double reach) {
  double least = reach;
  BoxTree* const tree = index.find_tree(edge.in);
  if (tree == nullptr) return least;
  HostBox around;
  around.add(x);
  around.widen(reach);
  tree->visit_meeting(around, [&](int f) {
    const FaceTopology& of = share.faces[at(f)];
    if (are_joined(edge, of) || (edge.body != edge.in && !(of.offset > 0))) return;
    least = std::min(least, find_closest_point(index.load(at(f), x)).distance);
  });
  return least;
}

/// Joins the places at which each edge goes through a body, and measures how deep. piercings: of all ranks, in order.
std::vector<PiercingEdge> measure(const Communicator& ranks, const SurfaceShare& share, FaceIndex& index,
                                  const std::vector<Piercing>& piercings) {
  std::vector<PiercingEdge> list;
  std::vector<double> distances;
  std::vector<char> has_end_behind;
  for (std::size_t first = 0, last = 0; first < piercings.size(); first = last) {
    last = first + 1;
    double rim = piercings[first].rim;
    for (; last < piercings.size() && piercings[last].is_of_same(piercings[first]); ++last)
      rim = std::min(rim, piercings[last].rim);
    const Piercing& at_first = piercings[first];
    const TravellingEdge& edge = at_first.edge;
    const EdgeSamples samples = choose_samples(piercings, first, last);
    const Point3 x = edge.x[0] + at_first.share * (edge.x[1] - edge.x[0]);
    for (const Point3& sample : samples.x)
      distances.push_back(find_distance(share, index, edge, sample, norm(sample - x)));
    has_end_behind.push_back(samples.is_end_behind ? 1 : 0);
    list.push_back({{-1, {edge.ends[0], edge.ends[1]}, edge.part, at_first.part, rim, at_first.size, {x.x, x.y, x.z}},
                    edge.body,
                    edge.in});
  }
  all_reduce(ranks, Reduce::least, distances);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double* const d = &distances[3 * i];
    const double depth = has_end_behind[i] != 0 ? std::min(d[0], d[1]) : std::max({d[0], d[1], d[2]});
    list[i].edge.depth = std::min(list[i].edge.depth, depth);
  }
  return list;
}

}  // namespace

PiercingEdges find_piercing_edges(const Communicator& ranks, const SurfaceShare& share,
                                  const Rows3<const double>& places, PiercedPairs pairs) {
  const auto x = to_host(places);
  FaceIndex index(share, x);
  const std::vector<BodyFaces> bodies = gather_items(ranks, index.list_bodies(ranks.rank()));
  std::vector<HostBox> list;
  for (const BodyFaces& body : bodies) {
    list.push_back(body.box);
    list.back().item = static_cast<int>(list.size()) - 1;
  }
  BoxTree boxes(std::move(list));
  PiercingLook look(share, index, pairs);
  std::vector<Piercing> piercings = look_through(ranks, bodies, index, boxes, look);
  std::sort(piercings.begin(), piercings.end(), [](const Piercing& a, const Piercing& b) { return a.key() < b.key(); });
  // On the line between two triangles an edge goes through both.
  const auto is_same = [](const Piercing& a, const Piercing& b) {
    return a.is_of_same(b) && b.share - a.share < same_place;
  };
  piercings.erase(std::unique(piercings.begin(), piercings.end(), is_same), piercings.end());
  PiercingEdges result{measure(ranks, share, index, piercings),
                       boxes.tests() + index.tests() + static_cast<std::int64_t>(share.faces.size())};
  all_reduce(ranks, Reduce::largest, result.tests);
  return result;
}

}  // namespace percuss
