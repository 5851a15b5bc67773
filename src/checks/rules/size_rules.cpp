// Parts whose sizes and positions do not fit each other.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "src/checks/rules.hpp"
#include "src/deck/embedded_parts.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Longest edge of the box of one copy of a part [length].
double find_copy_extent(const PartDeck& part, const PartMeasures& measures) {
  if (!part.array) return measures.extent();
  double extent = measures.extent();
  for (std::size_t k = 0; k < 3; ++k) {
    const double copies = std::abs(part.array->pitch[k]) * (part.array->count[k] - 1);
    extent = std::min(extent, std::max(measures.extent() - copies, std::abs(part.array->pitch[k])));
  }
  return extent;
}

/// The edges of the box of a part, ascending [length].
Vec3 sort_edges(const PartMeasures& part) {
  Vec3 edges{};
  for (std::size_t k = 0; k < 3; ++k) edges[k] = part.high[k] - part.low[k];
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Whether the nodes of two parts of one box also have one centre and one spread: turned and mirrored parts do not.
bool have_alike_nodes(const PartMeasures& a, const PartMeasures& b) {
  constexpr double margin = 1e-6 * (1 << 30);  // of the box of the scene
  if (a.nodes != b.nodes) return false;
  for (std::size_t k = 0; k < a.moments.size(); ++k) {
    const auto difference = static_cast<double>(a.moments[k] - b.moments[k]);
    if (std::abs(difference) > margin * static_cast<double>(a.nodes)) return false;
  }
  return true;
}

bool are_alike(const PartMeasures& a, const PartMeasures& b) {
  constexpr double share = 1e-6;  // of the size: beyond round-off of how they were placed
  if (a.solids != b.solids || a.shells != b.shells || a.beams != b.beams || !have_alike_nodes(a, b)) return false;
  const double margin = share * a.extent();
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(a.low[k] - b.low[k]) > margin || std::abs(a.high[k] - b.high[k]) > margin) return false;
  }
  return true;
}

bool is_turned(const PartDeck& part) {
  return std::any_of(part.rotate.begin(), part.rotate.end(), [](const Rotation& turn) { return turn.degrees != 0; });
}

/// Parts that are smaller than any element of the largest one, which then is in another unit. A rigid one may be a
/// floor of one element.
std::vector<Warning> check_element_size(const CheckedScene& scene, std::size_t largest, double size) {
  constexpr double most = 100, most_edges = 10;  // sizes of the part, and edges over it
  const PartDeck& large = scene.deck.parts[largest];
  if (large.rigid || is_driven(scene.deck, large)) return {};
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const double extent = find_copy_extent(scene.deck.parts[p], scene.measures->parts[p]);
    const double edge = scene.measures->parts[largest].shortest_edge;
    if (size <= most * extent || edge <= most_edges * extent) continue;
    return {
        warn_at(scene.deck, "part_size", find_shape_path(large),
                fmt::format("part '{}' is {:.3g} long, part '{}' {:.3g} (less than a tenth of any element edge of the "
                            "other): check that all lengths are in one unit",
                            large.name, size, scene.deck.parts[p].name, extent))};
  }
  return {};
}

/// Whether the box of a part lies in another one, which is a solid box or ball. Shells may lie on its surface.
bool is_enclosed(const PartMeasures& inner, const PartDeck& part, const PartMeasures& outer) {
  if (part.array) return false;
  const bool is_box = std::holds_alternative<BoxShape>(part.shape) && !is_turned(part);
  const auto* sphere = std::get_if<SphereShape>(&part.shape);
  double square = 0;  // of the distance of the farthest corner from the middle
  for (std::size_t k = 0; k < 3; ++k) {
    const double margin = inner.solids > 0 ? 1e-6 * outer.extent() : 0;  // a solid has volume wherever it lies
    if (inner.low[k] + margin <= outer.low[k] || inner.high[k] - margin >= outer.high[k]) return false;
    const double middle = 0.5 * (outer.low[k] + outer.high[k]);
    const double farthest = std::max(middle - inner.low[k], inner.high[k] - middle);
    square += farthest * farthest;
  }
  return is_box || (sphere != nullptr && square < sphere->radius * sphere->radius);
}

/// Counts the turns of `rotate`, without the one that `axis` becomes.
std::size_t count_listed_turns(const Deck& deck, const PartDeck& part) {
  std::size_t listed = 0;
  while (deck.places.has(join_path("parts." + part.name + ".rotate", listed))) ++listed;
  return std::min(listed, part.rotate.size());
}

/// Whether a part is a sheet of solid elements of which so many are in one layer.
bool is_single_layer(const PartMeasures& part, std::int64_t layered, double thickness) {
  constexpr double least_share = 0.9;   // of the elements: those of ribs and rims have other sides
  constexpr double least_slender = 10;  // width over thickness: a thicker block hardly bends
  constexpr std::int64_t least_elements = 9;
  const double share = static_cast<double>(layered) / static_cast<double>(part.elements());
  return layered >= least_elements && share >= least_share && sort_edges(part)[1] > least_slender * thickness;
}

bool is_single_layer(const PartMeasures& part) {
  return is_single_layer(part, part.single_layer, part.layer_thickness);
}

/// Whether the tetrahedra and pyramids of a part fill one cell between two surfaces: of the twelve or six in a cell
/// four or two then have a face there, of a mesh without middle nodes more. Two cells have half as many.
bool fill_one_cell(const PartDeck& part, const PartMeasures& measures) {
  const double least_faces = part.has_bare_tetrahedra() ? 0.5 : 0.3;  // of each element
  return static_cast<double>(measures.cut_faces) >= least_faces * static_cast<double>(measures.cut_solids);
}

/// Whether a generated bar has one cell of tetrahedra or pyramids across. Those of five have a rule of their own.
bool is_bar_of_one_cell(const PartDeck& part) {
  using Elements = PartDeck::Elements;
  constexpr double least_slender = 5;  // length over thickness: a shorter part hardly bends
  const auto* box = std::get_if<BoxShape>(&part.shape);
  const bool is_cut = part.elements == Elements::tetrahedra || part.elements == Elements::six_tetrahedra ||
                      part.elements == Elements::pyramids;
  if (box == nullptr || !is_cut || std::count(box->cells.begin(), box->cells.end(), 1) != 2) return false;
  double across = 0, along = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double& size = box->cells[k] == 1 ? across : along;
    size = std::max(size, box->size[k]);
  }
  return along >= least_slender * across;
}

/// Whether a condition keeps a whole part from moving across its thinnest direction: it is flat, and does not bend.
bool is_held_flat(const Deck& deck, const PartDeck& part, const PartMeasures& measures) {
  const Vec3 size = subtract(measures.high, measures.low);
  const auto thin = static_cast<std::size_t>(std::min_element(size.begin(), size.end()) - size.begin());
  return std::any_of(deck.conditions.begin(), deck.conditions.end(), [&](const ConditionDeck& condition) {
    const bool is_whole = condition.where.name == part.name && !condition.where.inside && !condition.when.any();
    return is_whole && condition.active[thin];
  });
}

/// How thick a generated solid is, and of how many cells.
struct ThinSide {
  double size = 0;
  int cells = 0;  // 0: of no such shape
};
ThinSide find_thin_side(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    const auto k = std::min_element(box->size.begin(), box->size.end()) - box->size.begin();
    return {box->size[static_cast<std::size_t>(k)], box->cells[static_cast<std::size_t>(k)]};
  }
  if (const auto* tube = std::get_if<TubeShape>(&shape))
    return {tube->outer_radius - tube->inner_radius, tube->cells[0]};
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (cylinder == nullptr) return {};
  if (cylinder->length < 2 * cylinder->radius) return {cylinder->length, cylinder->along};
  return {2 * cylinder->radius, cylinder->across};
}

/// Says what one layer of elements cannot represent.
std::string describe_layer(const PartMeasures& part, bool is_cut) {
  if (is_cut) return "constant strain does not bend: tetrahedra are nearly twice too stiff, and yield too late";
  if (part.layered_wedges > 0)
    return "one point has neither bending stress nor yield in bending, and the hourglass control of wedges is not as "
           "stiff as the material";
  return "one point has neither bending stress nor yield in bending";
}

}  // namespace

std::vector<Warning> check_part_size(const CheckedScene& scene) {
  constexpr double most = 1000;  // units; a container has bolts that are 240 times shorter
  const std::vector<PartDeck>& parts = scene.deck.parts;
  std::vector<std::pair<double, std::size_t>> sizes;
  for (std::size_t p = 0; p < parts.size(); ++p)
    sizes.emplace_back(find_copy_extent(parts[p], scene.measures->parts[p]), p);
  std::sort(sizes.begin(), sizes.end());
  const auto& [small, smallest] = sizes.front();
  const auto& [large, largest] = sizes.back();
  if (!(large > most * small)) return check_element_size(scene, largest, large);
  // The odd one is what is farther from most: the largest where the middle is closer to the smallest.
  const double middle = sizes[(sizes.size() - 1) / 2].first;
  const std::size_t odd = large * small > middle * middle ? largest : smallest;
  return {warn_at(scene.deck, "part_size", find_shape_path(parts[odd]),
                  fmt::format("part '{}' is {:.3g} long, part '{}' {:.3g} ({:.0f} times more): check that all lengths "
                              "are in one unit",
                              parts[smallest].name, small, parts[largest].name, large, large / small))};
}

std::vector<Warning> check_shell_thickness(const CheckedScene& scene) {
  constexpr double most = 0.5;    // share of the shorter edge of the surface: no shell theory holds beyond
  constexpr double least = 1e-5;  // share of the longest: a metre of household foil is thicker
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const double thickness = scene.measures->parts[p].shell_thickness;
    if (!part.has_thickness() || !(thickness > 0)) continue;
    const Vec3 edges = sort_edges(scene.measures->parts[p]);
    const bool is_thick = thickness > most * edges[1];
    if (!is_thick && thickness >= least * edges[2]) continue;
    const std::string fault = is_thick ? fmt::format("is more than half of its width {:.3g}", edges[1])
                                       : fmt::format("is {:.1g} of its length {:.3g}", thickness / edges[2], edges[2]);
    warnings.push_back(
        warn_at(scene.deck, "shell_thickness", "parts." + part.name + ".thickness",
                fmt::format("the thickness {:g} of part '{}' {} (shells are thin, and sheets thicker than "
                            "foil): check its unit",
                            thickness, part.name, fault)));
  }
  return warnings;
}

std::vector<Warning> check_single_layer(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    const bool has_points = scene.deck.find_elements(p).integration != ElementDeck::Integration::one_point;
    const bool is_cut = measures.cut_solids > 0 && fill_one_cell(part, measures);
    const std::int64_t layered =
        (has_points ? 0 : measures.single_layer) + measures.layered_wedges + (is_cut ? measures.cut_solids : 0);
    const bool is_bar = is_bar_of_one_cell(part);
    const double thickness =
        is_bar ? find_thin_side(part.shape).size
               : std::max(measures.layer_thickness, is_cut ? 2 * measures.cut_volume / measures.cut_area : 0);
    if (part.rigid || is_driven(scene.deck, part) || is_held_flat(scene.deck, part, measures)) continue;
    if (!is_bar && !is_single_layer(measures, layered, thickness)) continue;
    warnings.push_back(warn_at(
        scene.deck, "single_layer", find_shape_path(part),
        fmt::format("part '{}' has one {} through its thickness {:.3g} ({}): take 3 or more{}, or shells", part.name,
                    is_cut || is_bar ? "cell of tetrahedra or pyramids" : "solid element", thickness,
                    describe_layer(measures, is_cut || is_bar), measures.small_solids > 0 ? " hexahedra" : "")));
  }
  return warnings;
}

std::vector<Warning> check_soft_tetrahedra(const CheckedScene& scene) {
  constexpr int enough = 4;          // cells: within some 3 %
  constexpr double least_ratio = 5;  // length over thickness: a shorter part hardly bends
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    if (part.elements != PartDeck::Elements::five_tetrahedra || part.rigid || is_driven(scene.deck, part)) continue;
    const ThinSide thin = find_thin_side(part.shape);
    if (thin.cells == 0 || thin.cells >= enough || is_held_flat(scene.deck, part, measures)) continue;
    if (find_copy_extent(part, measures) < least_ratio * thin.size) continue;
    const char* how = thin.cells == 1 ? "bends some 20 % too stiffly" : "bends up to 8 % too softly";
    warnings.push_back(
        warn_at(scene.deck, "soft_tetrahedra", "parts." + part.name + ".elements",
                fmt::format("part '{}' has {} cell{} of five tetrahedra through its thickness {:.3g} (it {}): take "
                            "{} or more, six_tetrahedra with 2 or more, or hexahedra",
                            part.name, thin.cells, thin.cells == 1 ? "" : "s", thin.size, how, enough)));
  }
  return warnings;
}

// A brick of 2x2x2 points that bends also shears: an end moment meets 1 + (1 - nu) / 2 (length / thickness)^2 times the
// stiffness of a beam: Cook, Concepts and Applications of Finite Element Analysis, the bilinear rectangle in bending.
std::vector<Warning> check_shear_locking(const CheckedScene& scene) {
  constexpr double most = 2;  // length over thickness of an element
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    if (scene.deck.find_elements(p).integration != ElementDeck::Integration::full || part.rigid) continue;
    if (!is_single_layer(measures) || is_driven(scene.deck, part)) continue;
    const double ratio = measures.longest_edge / measures.layer_thickness;
    if (ratio <= most) continue;
    const std::string path = "parts." + part.name + ".integration";
    warnings.push_back(warn_at(
        scene.deck, "shear_locking", scene.deck.places.has(path) ? path : "elements.integration",
        fmt::format("elements of part '{}' are {:.2g} times as long as its one layer is thick (with 2x2x2 points "
                    "they bend some {:.2g} times too stiffly): use one_point, which bends as the material does, "
                    "shells, or shorter elements",
                    part.name, ratio, 1 + 0.35 * ratio * ratio)));
  }
  return warnings;
}

namespace {

/// Length over thickness of the elements of a part that has one across where it bends; 0: it has more.
double find_lone_ratio(const PartDeck& part, const PartMeasures& measures) {
  constexpr double least_slender = 5;  // length over thickness: a shorter part hardly bends
  if (is_single_layer(measures)) return measures.longest_edge / measures.layer_thickness;
  const auto* box = std::get_if<BoxShape>(&part.shape);
  if (box == nullptr) return 0;
  const auto longest = std::max_element(box->size.begin(), box->size.end());
  const double length = *longest / box->cells[static_cast<std::size_t>(longest - box->size.begin())];
  double ratio = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (box->cells[k] != 1 || *longest < least_slender * box->size[k]) continue;
    const double here = length / box->size[k];
    ratio = ratio > 0 ? std::min(ratio, here) : here;
  }
  return ratio;
}

}  // namespace

// Points of one pressure: only the deviator of the stress bends an element, which alone across has no strain across
// that is linear. What that leaves of the stiffness of a beam, 0.4, is less than shear adds where elements are short.
std::vector<Warning> check_soft_bending(const CheckedScene& scene) {
  constexpr double most = 1.1;  // length over thickness of an element: some 0.9 of the stiffness
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    if (scene.deck.find_elements(p).integration != ElementDeck::Integration::full || part.rigid) continue;
    const double ratio = find_lone_ratio(part, measures);
    if (!(ratio > 0) || ratio > most || is_driven(scene.deck, part)) continue;
    const std::string path = "parts." + part.name + ".integration";
    warnings.push_back(warn_at(
        scene.deck, "soft_bending", scene.deck.places.has(path) ? path : "elements.integration",
        fmt::format("part '{}' has one element across, {:.2g} times as long as it is thick (with 2x2x2 points it bends "
                    "with some {:.2g} of its stiffness): take two or more across, one_point, or thick_shell",
                    part.name, ratio, 0.4 + 0.39 * ratio * ratio)));
  }
  return warnings;
}

std::vector<Warning> check_thick_shell_across(const CheckedScene& scene) {
  constexpr const char* names[3] = {"first", "second", "third"};
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    const ElementDeck settings = scene.deck.find_elements(p);
    if (settings.integration != ElementDeck::Integration::thick_shell || part.rigid) continue;
    if (settings.across == ElementDeck::Across::shortest) continue;
    const auto way = static_cast<std::size_t>(settings.across);
    const std::int64_t wrong = measures.long_ways[way];
    if (2 * wrong <= measures.solids) continue;
    const std::string own = "parts." + part.name + ".integration";
    warnings.push_back(warn_at(
        scene.deck, "thick_shell_across", scene.deck.places.has(own) ? own : "elements.integration",
        fmt::format(
            "{} of {} thick shells of part '{}' are thicker than wide (across is '{}'; where they are thin they "
            "lock in bending): take another direction, or across: shortest",
            wrong, measures.solids, part.name, names[way])));
  }
  return warnings;
}

std::vector<Warning> check_incompressible_solids(const CheckedScene& scene) {
  constexpr double least = 49;  // lambda over mu: Poisson's ratio 0.49
  const bool mixes = scene.deck.elements.tetrahedra == ElementDeck::Tetrahedra::mixed;
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    if (part.rigid || measures.small_solids == 0) continue;
    const MaterialDeck& material = find_material(scene.deck, part);
    const LameConstants c = find_moduli(material);
    if (!(c.mu > 0) || c.lambda < least * c.mu) continue;
    const std::string why = mixes ? "with 8 elements across they bend 10 to 20 % too stiffly, with 16 some 8 %"
                                  : "without averages they lock: bodies bend several times too stiffly";
    const std::string remedy = mixes ? "take hexahedra where it bends, or 16 or more elements across"
                                     : "take hexahedra, or elements: {tetrahedra: mixed}";
    warnings.push_back(warn_at(
        scene.deck, "incompressible_solids", "parts." + part.name,
        fmt::format(
            "part '{}' has {} tetrahedra, wedges or pyramids of material '{}', whose volume hardly changes ({}): {}",
            part.name, measures.small_solids, material.name, why, remedy)));
  }
  return warnings;
}

std::vector<Warning> check_triangles(const CheckedScene& scene) {
  constexpr double most = 0.3;  // share of the shells: meshes of quadrilaterals have a few per cent
  constexpr std::int64_t least_elements = 20;
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    const double share =
        static_cast<double>(measures.triangles) / static_cast<double>(std::max(measures.shells, std::int64_t{1}));
    if (part.rigid || is_driven(scene.deck, part) || measures.triangles < least_elements || share <= most) continue;
    warnings.push_back(
        warn_at(scene.deck, "shell_triangles", find_shape_path(part),
                fmt::format("{} of the {} shells of part '{}' are triangles (their strain is constant in the plane, so "
                            "that walls bend and fold too stiffly): mesh with quadrilaterals, with few triangles",
                            measures.triangles, measures.shells, part.name)));
  }
  return warnings;
}

std::vector<Warning> check_duplicate_parts(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  if (scene.deck.parts.size() > most_compared_parts) return warnings;
  for (std::size_t p = 1; p < scene.deck.parts.size(); ++p) {
    const auto& parts = scene.measures->parts;
    const auto same = std::find_if(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(p),
                                   [&](const PartMeasures& other) { return are_alike(other, parts[p]); });
    if (same == parts.begin() + static_cast<std::ptrdiff_t>(p)) continue;
    const PartDeck& first = scene.deck.parts[static_cast<std::size_t>(same - parts.begin())];
    warnings.push_back(warn_at(scene.deck, "duplicate_part", "parts." + scene.deck.parts[p].name,
                               fmt::format("part '{}' lies where part '{}' does and has as many elements (its mass is "
                                           "there twice): move or remove one of them",
                                           scene.deck.parts[p].name, first.name)));
  }
  return warnings;
}

std::vector<Warning> check_enclosed_parts(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  if (scene.deck.parts.size() > most_compared_parts) return warnings;
  for (std::size_t inner = 0; inner < scene.deck.parts.size(); ++inner) {
    const PartDeck& part = scene.deck.parts[inner];
    if (part.array || is_embedded(scene.deck, part.name)) continue;
    for (std::size_t outer = 0; outer < scene.deck.parts.size(); ++outer) {
      const PartMeasures& a = scene.measures->parts[inner];
      const PartMeasures& b = scene.measures->parts[outer];
      if (scene.measures->are_joined(inner, outer) || are_alike(a, b) || !is_enclosed(a, scene.deck.parts[outer], b))
        continue;
      if (inner < outer && is_enclosed(b, part, a)) continue;  // one box twice, which the other part tells
      warnings.push_back(
          warn_at(scene.deck, "enclosed_part", "parts." + part.name,
                  fmt::format("part '{}' lies inside the solid part '{}' (contact finds no faces there, and "
                              "the mass is there twice): move one of them",
                              part.name, scene.deck.parts[outer].name)));
    }
  }
  return warnings;
}

std::vector<Warning> check_angles(const CheckedScene& scene) {
  constexpr double eighth = std::numbers::pi / 4, margin = 2e-4;  // 1.5708 has four digits
  const auto is_radians = [](double angle) {
    const double turns = std::abs(angle) / eighth;
    return angle != 0 && turns < 8.5 && std::abs(turns - std::round(turns)) < margin && std::round(turns) > 0;
  };
  std::vector<Warning> warnings;
  const auto check = [&](double angle, const std::string& path) {
    if (!is_radians(angle)) return;
    warnings.push_back(warn_at(scene.deck, "angle_in_radians", path,
                               fmt::format("the angle {:g} looks like radians (it is taken in degrees): write {:g}",
                                           angle, std::round(angle / eighth) * 45)));
  };
  for (const PartDeck& part : scene.deck.parts) {
    const std::string path = "parts." + part.name;
    const std::size_t listed = count_listed_turns(scene.deck, part), first = part.rotate.size() - listed;
    for (std::size_t i = 0; i < listed; ++i)
      check(part.rotate[first + i].degrees, join_path(path + ".rotate", i) + ".angle");
    if (const auto* tube = std::get_if<TubeShape>(&part.shape)) check(tube->arc, path + ".tube.arc");
    if (const auto* tube = std::get_if<ShellTubeShape>(&part.shape)) check(tube->arc, path + ".shell_tube.arc");
  }
  return warnings;
}

}  // namespace percuss
