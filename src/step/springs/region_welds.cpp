#include "src/step/springs/region_welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/weld_points.hpp"

namespace percuss {
namespace {

/// Radii from a weld to the faces of an end: what is more is suspicious, or refused.
constexpr double usual_reach = 2, most_reach = 10;

/// Share of the disc on faces: what is less is suspicious, or refused.
constexpr double usual_cover = 0.75, least_cover = 0.05;

/// Faces of a selection; of shells one side of each element.
std::vector<ElementFace> list_faces(const Mesh& mesh, const Deck& deck, const Selector& where) {
  std::vector<ElementFace> faces;
  for (const ElementFace& face : select_faces(mesh, deck, where)) {
    const bool is_other_side =
        mesh.topology_of(at(face.element)).is_surface() && !faces.empty() && faces.back().element == face.element;
    if (!is_other_side) faces.push_back(face);
  }
  return faces;
}

std::string describe_place(const Vec3& x) { return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", x[0], x[1], x[2]); }

/// "[1, 2, 3]", of a table with its line.
std::string describe_point(const WeldDeck& weld, const WeldPoint& point) {
  return describe_place(point.at) + (point.line > 0 ? fmt::format(", line {} of {}", point.line, weld.file) : "");
}

void check_reach(const Deck& deck, const WeldDeck& weld, const WeldPoint& point, std::size_t end,
                 const WeldRegion& region) {
  if (region.covered >= least_cover) return;
  const bool is_near = region.distance <= most_reach * point.radius;
  throw InputError(fmt::format(
      "{}: error: weld '{}' finds no faces of its {} end at {} ({}): correct at, radius or between",
      deck.where(weld.place), weld.name, end == 0 ? "first" : "second", describe_point(weld, point),
      is_near ? fmt::format("only {:.2g} % of the disc of its radius lies on them", 100 * region.covered)
              : fmt::format("the nearest is {:.4g} away, more than {:g} radii", region.distance, most_reach)));
}

void check_shared(const Deck& deck, const ChunkedMesh& chunked, const WeldDeck& weld,
                  const std::array<WeldRegion, 2>& ends) {
  for (const std::int64_t node : ends[0].nodes) {
    if (!std::binary_search(ends[1].nodes.begin(), ends[1].nodes.end(), node)) continue;
    throw InputError(
        fmt::format("{}: error: both ends of weld '{}' have node {} (a weld connects two different faces): name faces "
                    "that share no node",
                    deck.where(weld.place), weld.name, find_node_id(chunked, node)));
  }
}

void add_warnings(const Deck& deck, const WeldDeck& weld, const WeldPoint& point, const WeldRegion& region,
                  std::vector<Warning>& warnings) {
  const auto warn = [&](const char* rule, const std::string& text) {
    warnings.push_back({rule, text, deck.where(weld.place), 0, 1});
  };
  if (region.distance > usual_reach * point.radius)
    warn("weld_distance", fmt::format("weld '{}' at {} lies {:.4g} from the faces of an end (more than {:g} radii: is "
                                      "it meant to be there?): correct at, radius or between",
                                      weld.name, describe_point(weld, point), region.distance, usual_reach));
  if (region.covered < usual_cover)
    warn("weld_rim",
         fmt::format("weld '{}' at {} has {:.0f} % of its disc on the faces of an end (the rest lies beyond "
                     "their rim): move it, or lower its radius",
                     weld.name, describe_point(weld, point), 100 * region.covered));
}

}  // namespace

RegionWelds find_region_welds(const Deck& deck, const ChunkedMesh& chunked) {
  std::vector<WeldSpot> spots;
  std::vector<std::vector<ElementFace>> faces;
  RegionWelds found;
  std::vector<std::vector<WeldPoint>> points(deck.welds.size());
  for (std::size_t w = 0; w < deck.welds.size(); ++w) {
    const WeldDeck& weld = deck.welds[w];
    if (!weld.is_between_faces()) continue;
    WeldPoints listed = list_weld_points(deck, find_ranks(chunked.mesh), weld);
    points[w] = std::move(listed.points);
    if (!listed.left_out.empty())
      found.warnings.push_back({"unread_content",
                                fmt::format("weld '{}' takes the spot welds of {} alone (the same parts have "
                                            "connections {}): give these in another way",
                                            weld.name, weld.file, listed.left_out),
                                deck.where(weld.place), 0, 1});
    for (const WeldPoint& point : points[w])
      spots.push_back({point.at, point.radius, {faces.size(), faces.size() + 1}});
    for (const SpringEndDeck& end : weld.between) faces.push_back(list_faces(chunked.mesh, deck, end.where));
  }
  found.of_entry.resize(deck.welds.size());
  if (spots.empty()) return found;
  const auto regions = find_weld_regions(chunked, spots, faces, most_reach);
  std::size_t next = 0;
  for (std::size_t w = 0; w < deck.welds.size(); ++w) {
    const WeldDeck& weld = deck.welds[w];
    for (const WeldPoint& point : points[w]) {
      const std::array<WeldRegion, 2>& ends = found.of_entry[w].emplace_back(regions[next++]);
      for (std::size_t e = 0; e < 2; ++e) check_reach(deck, weld, point, e, ends[e]);
      check_shared(deck, chunked, weld, ends);
      for (const WeldRegion& region : ends) add_warnings(deck, weld, point, region, found.warnings);
    }
  }
  return found;
}

}  // namespace percuss
