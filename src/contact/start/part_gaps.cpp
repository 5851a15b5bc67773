#include "src/contact/start/part_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/gather_items.hpp"
#include "kernels/contact/check/gaps.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

void add(const PartGap& more, std::vector<PartGap>& gaps) {
  const auto is_before = [](const PartGap& a, const PartGap& b) {
    return a.part != b.part ? a.part < b.part : a.other < b.other;
  };
  const auto place = std::lower_bound(gaps.begin(), gaps.end(), more, is_before);
  if (place == gaps.end() || is_before(more, *place))
    gaps.insert(place, more);
  else
    place->gap = std::min(place->gap, more.gap);
}

}  // namespace

std::vector<PartGap> measure_gaps(const SurfaceMotion& motion, CheckSpace& check, const std::vector<int>& face_part) {
  const CandidateList& candidates = check.candidates;
  std::vector<PartGap> found;
  if (candidates.num_pairs == 0) return found;
  Array<double> gaps("contact::gaps", 0);
  measure_all_faces(motion, check);
  run_where_it_pays(candidates.num_pairs,
                    [&](const auto& space) { find_gaps(space, check.surface, motion, candidates, check.faces, gaps); });
  const auto gap = to_host(gaps);
  const auto nodes = to_host(candidates.nodes), offset = to_host(candidates.offset), face = to_host(candidates.face);
  const auto first_face = to_host(check.surface.nodes_to_faces_offset), faces = to_host(check.surface.nodes_to_faces);
  const auto part_of = [&](int f) { return face_part[static_cast<std::size_t>(f)]; };
  for (int i = 0; i < candidates.num_nodes; ++i) {
    const int node = nodes(i), part = part_of(faces(first_face(node)));
    for (int c = offset(node); c < offset(node + 1); ++c) {
      if (gap(c) < 0) continue;
      const int other = part_of(face(c));
      add({std::min(part, other), std::max(part, other), gap(c)}, found);
    }
  }
  return found;
}

std::vector<PartGap> gather_gaps(const Communicator& ranks, const std::vector<PartGap>& own) {
  std::vector<PartGap> all;
  for (const PartGap& gap : gather_items(ranks, own)) add(gap, all);
  return all;
}

std::string describe_gaps(std::vector<PartGap> gaps, const Mesh& mesh) {
  constexpr std::size_t most = 4;
  std::stable_sort(gaps.begin(), gaps.end(), [](const PartGap& a, const PartGap& b) { return a.gap < b.gap; });
  std::string line;
  const auto name = [&](int part) { return mesh.parts[static_cast<std::size_t>(part)].name; };
  for (std::size_t i = 0; i < gaps.size() && i < most; ++i) {
    const PartGap& g = gaps[i];
    line += i == 0 ? "smallest gaps: " : ", ";
    line += g.gap == 0 ? "0 (they touch)" : fmt::format("{:.4g}", g.gap);
    line += g.part == g.other ? fmt::format(" within '{}'", name(g.part))
                              : fmt::format(" between '{}' and '{}'", name(g.part), name(g.other));
  }
  if (gaps.size() > most) line += fmt::format(" and {} more pairs of parts", gaps.size() - most);
  return line;
}

}  // namespace percuss
