#include "src/contact/overlap/start_crossings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "comm/gather_items.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/overlap/crossed_sides.hpp"
#include "src/contact/overlap/crossing_edges.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Depth of two parts: of the first in the other, and of the other in the first.
struct PairDepth {
  PartCrossing crossing;
  DeepNode ways[2], edges[2];
  bool is_divided[2] = {false, false}, has_edges[2] = {false, false};

  void take(int way, const DeepNode& depth) {
    is_divided[way] = true;
    if (depth.depth > ways[way].depth) ways[way] = depth;
  }
  void take_edge(int way, const PiercingEdge& edge) {
    has_edges[way] = true;
    if (edge.edge.depth > edges[way].depth)
      edges[way] = {edge.edge.depth, {edge.edge.x[0], edge.edge.x[1], edge.edge.x[2]}};
  }
  DeepNode find_depth(const PartKinds& kinds) const;
};

/// The deeper of two; of two that are equal but for round-off the first.
DeepNode find_deeper(const DeepNode& a, const DeepNode& b) { return b.depth > a.depth * (1 + 1e-9) ? b : a; }

// Sheets part as soon as the one is out of the other, a body and a solid not before both are. What is not divided is as
// deep as its edges. These are nothing if no edge of the one goes through the other: then they run along its rim.
// Sheets that are slit into each other come apart along the slit.
DeepNode PairDepth::find_depth(const PartKinds& kinds) const {
  const int a = crossing.part, b = crossing.other;
  const bool is_of_sheets = !kinds.is_solid(a) && !kinds.is_solid(b);
  if (is_divided[0] && is_divided[1] && is_of_sheets) return ways[1].depth < ways[0].depth ? ways[1] : ways[0];
  const int first =
      kinds.is_solid(b) && !kinds.is_solid(a) ? 1 : 0;  // the place is of the solid rather than of a sheet
  if (is_divided[0] || is_divided[1]) return find_deeper(ways[first], ways[1 - first]);
  if (has_edges[0] != has_edges[1] && a != b && kinds.has_faces(a) && kinds.has_faces(b)) return {};
  const DeepNode deep = find_deeper(edges[0], edges[1]);
  return is_of_sheets && a != b ? find_deeper(deep, {crossing.find_extent(), deep.x}) : deep;
}

/// Edges of a part that go through a body, by their ends, and whether something holds them there.
struct PartEdges {
  std::vector<PiercingEdge> edges;
  std::vector<char> is_held;
};

class CrossingPairs {
 public:
  CrossingPairs(const CrossingScene& scene, const HostPlaces& x, const std::vector<TravellingEdge>& beams)
      : scene_(scene), index_(scene.share, x), beams_(beams) {}

  std::vector<PartCrossing> find(const std::vector<CrossingEdge>& edges) {
    for (const CrossingEdge& edge : edges) add(edge);
    measure_all();
    const PartKinds kinds = find_part_kinds(scene_.chunked.mesh);
    std::vector<PartCrossing> list;
    for (auto& [parts, pair] : pairs_) {
      PartCrossing& crossing = pair.crossing;
      const auto [a, b] = parts;
      crossing.is_of_solids = kinds.is_solid(a) && kinds.is_solid(b);
      for (const int part : {a, b})
        if (kinds.thickness[at(part)] > 0) crossing.size = std::min(crossing.size, kinds.thickness[at(part)]);
      const DeepNode deep = pair.find_depth(kinds);
      if (!(deep.depth > contact_limits::overlap * crossing.size)) continue;
      crossing.depth = deep.depth;
      crossing.deepest = {deep.x.x, deep.x.y, deep.x.z};
      list.push_back(std::move(crossing));
    }
    return list;
  }

 private:
  static int find_way(const PiercingEdge& of) { return of.edge.part <= of.edge.other ? 0 : 1; }
  PairDepth& find_pair(const PiercingEdge& of) { return pairs_[std::minmax(of.edge.part, of.edge.other)]; }

  void add(const CrossingEdge& of) {
    const PiercingEdge& edge = of.piercing;
    PartEdges& of_part = by_part_[{edge.edge.part, edge.in}];
    of_part.edges.push_back(edge);
    of_part.is_held.push_back(of.is_held ? 1 : 0);
    if (of.is_held) return;
    PartCrossing& crossing = find_pair(edge).crossing;
    std::tie(crossing.part, crossing.other) = std::minmax(edge.edge.part, edge.edge.other);
    crossing.contact = std::max(crossing.contact, of.contact);
    crossing.size = std::max(crossing.size, std::min(edge.edge.size, edge.length));
    crossing.places.push_back({edge.edge.x[0], edge.edge.x[1], edge.edge.x[2]});
    find_pair(edge).take_edge(find_way(edge), edge);
  }

  /// Where a part goes through a body of several parts, each of these has the depth of what crosses it.
  void measure_all() {
    for (const auto& [part, of] : by_part_) {
      const std::vector<PiercingEdge>& edges = of.edges;
      if (std::find(of.is_held.begin(), of.is_held.end(), 0) == of.is_held.end()) continue;
      for (const CrossedSides& sides : divide_part(find_lines(part.first), edges)) {
        std::vector<int> others;
        for (const std::size_t e : sides.edges)
          if (of.is_held[e] == 0) others.push_back(edges[e].edge.other);
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        // Its own surface is on both sides.
        const PiercingEdge& first = edges[sides.edges.front()];
        if (first.body == first.in) std::erase(others, part.first);
        if (others.empty()) continue;
        const DeepNode depth = sides.find_depth(scene_.ranks, index_, first);
        for (const int other : others) pairs_[std::minmax(part.first, other)].take(part.first <= other ? 0 : 1, depth);
      }
    }
  }

  /// Lines of a part, of all ranks. Collective.
  const std::vector<PartLine>& find_lines(int part) {
    if (part == part_of_lines_) return lines_;
    std::vector<PartLine> own;
    const auto add_line = [&](const TravellingEdge& edge) {
      own.push_back({part, {edge.ends[0], edge.ends[1]}, {edge.x[0], edge.x[1]}});
    };
    for (const std::size_t f : index_.kept()) {
      if (index_.topology(f).part != part) continue;
      index_.visit_sides(f, [&](std::size_t side) { add_line(index_.load_edge(f, side, -1)); });
    }
    for (const TravellingEdge& beam : beams_)
      if (beam.part == part) add_line(beam);
    lines_ = gather_items(scene_.ranks, own);
    part_of_lines_ = part;
    return lines_;
  }

  const CrossingScene& scene_;
  FaceIndex index_;
  const std::vector<TravellingEdge>& beams_;
  std::map<std::pair<int, int>, PairDepth> pairs_;
  std::map<std::pair<int, int>, PartEdges> by_part_;  // by the part of the edges and the body
  std::vector<PartLine> lines_;
  int part_of_lines_ = -1;
};

std::string name_part(const Mesh& mesh, int part) { return "'" + mesh.parts[at(part)].name + "'"; }

/// "'a' and 'b' by 5 at (1, 2, 3), 'a' and 'c' ..., and 2 more pairs of parts"
std::string list_crossings(std::vector<const PartCrossing*> crossings, const Mesh& mesh) {
  constexpr std::size_t most = 4;
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const PartCrossing* a, const PartCrossing* b) { return a->depth > b->depth; });
  std::string line;
  for (std::size_t i = 0; i < crossings.size() && i < most; ++i) {
    const PartCrossing& of = *crossings[i];
    const std::string parts = of.part == of.other ? name_part(mesh, of.part) + " itself"
                                                  : name_part(mesh, of.part) + " and " + name_part(mesh, of.other);
    line += fmt::format("{}{} by {:.4g} at {}", i == 0 ? "" : ", ", parts, of.depth, of.name_place());
  }
  if (crossings.size() > most) line += fmt::format(" and {} more pairs of parts", crossings.size() - most);
  return line;
}

}  // namespace

bool PartCrossing::is_deep() const {
  constexpr double most = 0.2;  // as of the rule deep_overlap
  return depth > most * size;
}

double PartCrossing::find_extent() const {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(places.begin(), places.end(), [k](const auto& a, const auto& b) { return a[k] < b[k]; });
    if (low != places.end()) square += ((*high)[k] - (*low)[k]) * ((*high)[k] - (*low)[k]);
  }
  return std::sqrt(square);
}

std::string PartCrossing::name_place() const {
  constexpr double round_off = 1e-9;
  const double largest = std::max({std::abs(deepest[0]), std::abs(deepest[1]), std::abs(deepest[2]), depth});
  const auto round = [&](double x) { return std::abs(x) > round_off * largest ? x : 0; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", round(deepest[0]), round(deepest[1]), round(deepest[2]));
}

std::vector<PartCrossing> find_crossings(const CrossingScene& scene, const Rows3<const double>& x) {
  const auto places = to_host(x);
  const std::vector<TravellingEdge> beams = list_beams(scene, places);
  const std::vector<CrossingEdge> edges = find_crossing_edges(scene, x, beams);
  if (edges.empty()) return {};
  return CrossingPairs(scene, places, beams).find(edges);
}

std::string describe_crossings(const std::string& before, PartCrossing::Contact contact,
                               const std::vector<PartCrossing>& crossings, const Mesh& mesh) {
  std::vector<const PartCrossing*> deep;
  for (const PartCrossing& crossing : crossings)
    if (crossing.contact == contact && crossing.is_deep()) deep.push_back(&crossing);
  return deep.empty() ? "" : before + list_crossings(deep, mesh);
}

std::string describe_refused_crossings(const std::vector<PartCrossing>& crossings, ContactDeck::Overlap overlap,
                                       const Mesh& mesh) {
  if (overlap == ContactDeck::Overlap::accept) return "";
  std::vector<const PartCrossing*> refused;
  for (const PartCrossing& crossing : crossings) {
    if (crossing.contact != PartCrossing::Contact::now || !crossing.is_deep()) continue;
    const bool is_pushed = overlap == ContactDeck::Overlap::push_out && crossing.is_of_solids &&
                           crossing.depth <= contact_limits::history_depth * crossing.size;
    if (!is_pushed) refused.push_back(&crossing);
  }
  if (refused.empty()) return "";
  return fmt::format("parts cross: {}{}", list_crossings(refused, mesh),
                     overlap == ContactDeck::Overlap::push_out
                         ? " (push_out separates solids that overlap by up to a quarter of an element)"
                         : "");
}

}  // namespace percuss
