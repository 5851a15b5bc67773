#include <fmt/format.h>

#include <algorithm>

#include "src/contact/overlap/start_overlap.hpp"

namespace percuss {
namespace {

/// "; 4 of 'b' in 'a' (up to 0.05)", those with most nodes first, a few of them.
std::string describe_parts(std::vector<PartOverlap> parts, const Mesh& mesh) {
  constexpr std::size_t most = 4;
  std::stable_sort(parts.begin(), parts.end(),
                   [](const PartOverlap& a, const PartOverlap& b) { return a.nodes > b.nodes; });
  std::string line;
  const auto name = [&](int part) { return "'" + mesh.parts[static_cast<std::size_t>(part)].name + "'"; };
  for (std::size_t i = 0; i < parts.size() && i < most; ++i)
    line += fmt::format(
        "{} {} of {} {} (up to {:.4g})", i == 0 ? ";" : ",", parts[i].nodes, name(parts[i].part),
        parts[i].other < 0 ? fmt::format("behind walls.{}", -1 - parts[i].other) : "in " + name(parts[i].other),
        parts[i].deepest);
  if (parts.size() > most) line += fmt::format(" and {} more pairs of parts", parts.size() - most);
  return line;
}

/// Names what the nodes are inside of.
const char* name_others(const std::vector<PartOverlap>& parts) {
  const auto is_wall = [](const PartOverlap& overlap) { return overlap.other < 0; };
  if (std::none_of(parts.begin(), parts.end(), is_wall)) return "another body";
  return std::all_of(parts.begin(), parts.end(), is_wall) ? "a wall" : "another body or a wall";
}

/// what_follows: "at the start, deepest ...: accepted".
std::string describe_nodes(const StartOverlap& found, const std::string& what_follows, const Mesh& mesh) {
  std::string line = fmt::format("{} contact node{} overlap{} {} {}", found.nodes, found.nodes == 1 ? "" : "s",
                                 found.nodes == 1 ? "s" : "", name_others(found.parts), what_follows);
  line += describe_parts(found.parts, mesh);
  if (found.too_deep > 0)
    line += fmt::format("; {} of them lie deeper than a quarter of a face and are not in contact", found.too_deep);
  return line;
}

}  // namespace

// As many contacts as overlap, as deep as the deepest. What is too deep is not pushed, and says nothing of the others'
// depth.
double find_pushed_square(const StartOverlap& found, ContactDeck::Overlap overlap) {
  if (overlap != ContactDeck::Overlap::push_out || found.too_deep > 0) return 0;
  return static_cast<double>(found.nodes) * found.deepest * found.deepest +
         static_cast<double>(found.edge_pairs) * found.deepest_edges * found.deepest_edges;
}

std::string describe_overlap(const StartOverlap& found, ContactDeck::Overlap overlap, const Mesh& mesh,
                             std::int64_t deepest_id, const std::string& when) {
  if (found.nodes == 0 && found.edge_pairs == 0) return "";
  const char* const treatment = overlap == ContactDeck::Overlap::accept     ? "accepted as the reference"
                                : overlap == ContactDeck::Overlap::push_out ? "pushed out slowly"
                                                                            : "refused";
  const std::string edges = fmt::format("{} pair{} of edges overlap{}", found.edge_pairs,
                                        found.edge_pairs == 1 ? "" : "s", found.edge_pairs == 1 ? "s" : "");
  if (found.nodes == 0) return fmt::format("{} {}, deepest {:.4g}: {}", edges, when, found.deepest_edges, treatment);
  const std::string nodes = describe_nodes(
      found, fmt::format("{}, deepest {:.4g} at node {}: {}", when, found.deepest, deepest_id, treatment), mesh);
  if (found.edge_pairs == 0) return nodes;
  return fmt::format("{}; {} too, deepest {:.4g}", nodes, edges, found.deepest_edges);
}

std::string describe_overlap_left(const StartOverlap& left) {
  if (left.nodes == 0 && left.edge_pairs == 0) return "no overlap remains from the start";
  return fmt::format("overlap remaining from the start: {} contact node{} and {} pair{} of edges, deepest {:.4g}",
                     left.nodes, left.nodes == 1 ? "" : "s", left.edge_pairs, left.edge_pairs == 1 ? "" : "s",
                     std::max(left.deepest, left.deepest_edges));
}

}  // namespace percuss
