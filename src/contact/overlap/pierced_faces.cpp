#include "src/contact/overlap/pierced_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "src/contact/overlap/face_index.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Places on an edge that differ by no more than this are one.
constexpr double same_place = 1e-9;

/// Where an edge meets a triangle of a face's fan.
struct Piercing {
  TravellingEdge edge;
  std::int64_t face = -1;  // number
  int triangle = 0, part = 0;
  double share = 0;  // of the way from end 0 to end 1
  double size = 0;   // shortest edge of the face
  double rim = 0;    // distance of the place from where the sheet ends, if that is a side of the face
  std::int64_t corners[4]{};
  int surface_class = 0;
  bool is_of_solid = false, enters = false;  // of the face; against its normal

  auto key() const { return std::tuple(edge.ends[0], edge.ends[1], edge.in, share, face, triangle, edge.part); }
  bool is_of_same(const Piercing& other) const {
    return edge.ends[0] == other.edge.ends[0] && edge.ends[1] == other.edge.ends[1] && edge.in == other.edge.in;
  }
};

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

/// Where an edge goes through a triangle.
struct Passage {
  double share = -1;  // as of find_meeting()
  bool enters = false;
};

/// Where a line from the origin along `way` goes through a triangle. Its ends are on different sides: an end behind the
/// triangle by no more than `band` counts as before it. A line that touches from behind, or lies in the triangle, does
/// not go through.
Passage find_passage(const Point3& way, const Point3 (&triangle)[3], double band) {
  constexpr double rim = 1e-10;  // share of the triangle: on a line between two it goes through both
  const Point3 e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0], across = cross(e1, e2);
  const double area = norm(across);
  if (!(area > 0)) return {};
  const Point3 normal = (1 / area) * across;
  const double from = -dot(normal, triangle[0]), to = from + dot(normal, way);
  if ((from >= -band) == (to >= -band)) return {};
  const double share = std::clamp(from / (from - to), 0.0, 1.0);
  const Point3 place = share * way - triangle[0];
  const double u = dot(cross(place, e2), normal) / area, v = dot(cross(e1, place), normal) / area;
  if (u < -rim || v < -rim || u + v > 1 + rim) return {};
  return {share, to < from};
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
void find_piercings(const FaceIndex& index, std::size_t f, const TravellingEdge& edge, PiercedPairs pairs,
                    std::vector<Piercing>& found) {
  const FaceTopology& of = index.topology(f);
  const FacePoints face = index.load(f, edge.x[0]);
  const Point3 way = edge.x[1] - edge.x[0], middle = find_middle(face);
  const double size = find_shortest_edge(face);
  for (int k = 0; k < 4; ++k) {
    const Point3 triangle[3] = {middle, face.corner[k], face.corner[(k + 1) % 4]};
    const Passage passage = pairs == PiercedPairs::all_surfaces
                                ? find_passage(way, triangle, contact_limits::overlap * size)
                                : Passage{find_meeting({}, way, triangle)};
    if (passage.share < 0) continue;
    Piercing& piercing = found.emplace_back();
    piercing = {
        edge, of.number, k, of.part, passage.share, size, find_rim_distance(index, f, face, passage.share * way)};
    std::copy_n(of.corners, 4, piercing.corners);
    piercing.surface_class = of.surface_class;
    piercing.is_of_solid = !(of.offset > 0);
    piercing.enters = passage.enters;
  }
}

/// Looks where edges go through the faces of this rank.
class PiercingLook {
 public:
  PiercingLook(const SurfaceShare& share, FaceIndex& index, PiercedPairs pairs)
      : share_(share), index_(index), pairs_(pairs), friction_(to_host(share.pair_friction)) {}

  /// Looks at the edges of a body of this rank, in the faces of a body of this rank.
  void look_at(const BoxTree& faces, int in) {
    index_.find_tree(in)->visit_pairs(faces, [&](const HostBox& other, const HostBox& own) {
      const std::size_t f = at(own.item), of = at(other.item);
      index_.visit_sides(f, [&](std::size_t side) {
        if (index_.bound_side(f, side).meets(other) && may_pierce(index_.name(f, side, in), share_.faces[of]))
          find_piercings(index_, of, index_.load_edge(f, side, in), pairs_, found_);
      });
    });
  }

  /// Looks at the edges that this rank was sent.
  void look_at(const std::vector<TravellingEdge>& edges) {
    for (const TravellingEdge& edge : edges)
      index_.find_tree(edge.in)->visit_meeting(bound(edge), [&](int f) {
        if (may_pierce(edge, share_.faces[at(f)])) find_piercings(index_, at(f), edge, pairs_, found_);
      });
  }

  const std::vector<Piercing>& found() const { return found_; }

 private:
  bool may_pierce(const FaceSide& edge, const FaceTopology& of) const {
    if (pairs_ != PiercedPairs::all_surfaces && edge.body != edge.in && !(of.offset > 0)) return false;
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

/// Context of a search through the faces of all ranks.
struct LookedThrough {
  const Communicator& ranks;
  const std::vector<BodyFaces>& bodies;
  const std::vector<TravellingEdge>& beams;
  const PiercedPairs pairs;
  FaceIndex& index;
  BoxTree& boxes;  // of the bodies
};

/// Looks at the edges of this rank in their own body, and in others in whose box they are: here, or where these are.
std::vector<Piercing> look_through(const LookedThrough& with, PiercingLook& look) {
  FaceIndex& index = with.index;
  const int rank = with.ranks.rank();
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
  for (const BodyFaces& own : with.bodies) {
    if (own.rank != rank) continue;
    with.boxes.visit_meeting(own.box, [&](int item) {
      const BodyFaces& in = with.bodies[at(item)];
      if (in.body != own.body && in.has_shells == 0 && with.pairs != PiercedPairs::all_surfaces) return;
      if (in.rank == rank)
        look.look_at(*index.find_tree(own.body), in.body);
      else
        send(own, in);
    });
  }
  for (const TravellingEdge& beam : with.beams)
    with.boxes.visit_meeting(bound(beam), [&](int item) {
      edges.push_back(beam);
      edges.back().in = with.bodies[at(item)].body;
      to.push_back(with.bodies[at(item)].rank);
    });
  ItemExchange exchange(with.ranks);
  look.look_at(exchange.send(to, edges));
  return gather_items(with.ranks, look.found());
}

/// The places of an edge by which its depth is known: its ends, where one of them is on the other side, else three
/// between the first place at which it goes through and the next.
std::array<Point3, 3> choose_samples(const std::vector<Piercing>& piercings, std::size_t first, std::size_t last) {
  const TravellingEdge& edge = piercings[first].edge;
  const auto place = [&](double share) { return edge.x[0] + share * (edge.x[1] - edge.x[0]); };
  if ((last - first) % 2 == 1) return {edge.x[0], edge.x[1], edge.x[1]};
  const double from = piercings[first].share, to = piercings[first + 1].share;
  return {place(0.75 * from + 0.25 * to), place(0.5 * (from + to)), place(0.25 * from + 0.75 * to)};
}

/// The least distance of a place from the faces of this rank that an edge may go through, if it is less than `reach`.
double find_distance(FaceIndex& index, const TravellingEdge& edge, const Point3& x, double reach, bool of_solids) {
  double least = reach;
  BoxTree* const tree = index.find_tree(edge.in);
  if (tree == nullptr) return least;
  HostBox around;
  around.add(x);
  around.widen(reach);
  tree->visit_meeting(around, [&](int f) {
    const FaceTopology& of = index.topology(at(f));
    if (are_joined(edge, of) || (!of_solids && edge.body != edge.in && !(of.offset > 0))) return;
    least = std::min(least, find_closest_point(index.load(at(f), x)).distance);
  });
  return least;
}

/// The edge that goes through a body at some places, first to last; its depth is that of the rim of the sheet.
PiercingEdge join(const std::vector<Piercing>& piercings, std::size_t first, std::size_t last) {
  const Piercing& at_first = piercings[first];
  const TravellingEdge& edge = at_first.edge;
  const Point3 way = edge.x[1] - edge.x[0], x = edge.x[0] + at_first.share * way;
  PiercingEdge joined{
      {-1, {edge.ends[0], edge.ends[1]}, edge.part, at_first.part, at_first.rim, at_first.size, {x.x, x.y, x.z}},
      edge.body,
      edge.in};
  for (std::size_t i = first; i < last; ++i) joined.edge.depth = std::min(joined.edge.depth, piercings[i].rim);
  std::copy_n(at_first.corners, 4, joined.corners);
  joined.classes[0] = edge.surface_class;
  joined.classes[1] = at_first.surface_class;
  joined.is_of_solid = at_first.is_of_solid;
  joined.is_odd = (last - first) % 2 == 1;
  joined.inner = at_first.enters ? 1 : 0;
  joined.length = norm(way);
  return joined;
}

/// Joins the places at which each edge goes through a body, and measures how deep. piercings: of all ranks, in order.
std::vector<PiercingEdge> measure(const Communicator& ranks, FaceIndex& index, const std::vector<Piercing>& piercings,
                                  PiercedPairs pairs) {
  const bool of_solids = pairs == PiercedPairs::all_surfaces;
  std::vector<PiercingEdge> list;
  std::vector<double> distances;
  for (std::size_t first = 0, last = 0; first < piercings.size(); first = last) {
    for (last = first + 1; last < piercings.size() && piercings[last].is_of_same(piercings[first]);) ++last;
    list.push_back(join(piercings, first, last));
    const double* const x = list.back().edge.x;
    for (const Point3& sample : choose_samples(piercings, first, last))
      distances.push_back(
          find_distance(index, piercings[first].edge, sample, norm(sample - Point3{x[0], x[1], x[2]}), of_solids));
  }
  all_reduce(ranks, Reduce::least, distances);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double* const d = &distances[3 * i];
    PiercingEdge& of = list[i];
    const bool has_inside = of_solids && of.is_of_solid;
    const double depth = !of.is_odd ? std::max({d[0], d[1], d[2]}) : has_inside ? d[of.inner] : std::min(d[0], d[1]);
    of.edge.depth = std::min(of.edge.depth, depth);
    if (of.is_odd) std::copy_n(d, 2, of.away);
  }
  return list;
}

}  // namespace

PiercingEdges find_piercing_edges(const Communicator& ranks, const SurfaceShare& share,
                                  const Rows3<const double>& places, PiercedPairs pairs,
                                  const std::vector<TravellingEdge>& beams) {
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
  std::vector<Piercing> piercings = look_through({ranks, bodies, beams, pairs, index, boxes}, look);
  std::sort(piercings.begin(), piercings.end(), [](const Piercing& a, const Piercing& b) { return a.key() < b.key(); });
  // On the line between two triangles an edge goes through both; over the ridge of a solid it goes in and out.
  const auto is_same = [](const Piercing& a, const Piercing& b) {
    return a.is_of_same(b) && b.share - a.share < same_place && (!a.is_of_solid || a.enters == b.enters);
  };
  piercings.erase(std::unique(piercings.begin(), piercings.end(), is_same), piercings.end());
  PiercingEdges result{measure(ranks, index, piercings, pairs),
                       boxes.tests() + index.tests() + static_cast<std::int64_t>(share.faces.size())};
  all_reduce(ranks, Reduce::largest, result.tests);
  return result;
}

}  // namespace percuss
