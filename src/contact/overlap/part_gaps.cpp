#include "src/contact/overlap/part_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/gather_items.hpp"

namespace percuss {
std::vector<PartGap> gather_gaps(const Communicator& ranks, const std::vector<PartGap>& own) {
  std::vector<PartGap> all;
  for (const PartGap& gap : gather_items(ranks, own)) add_gap(gap, all);
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
    line += g.gap == 0 ? "0 (they touch)" : fmt::format("{:.4g}{}", g.gap, g.gap < 0 ? " (they overlap)" : "");
    line += g.part == g.other ? fmt::format(" within '{}'", name(g.part))
                              : fmt::format(" between '{}' and '{}'", name(g.part), name(g.other));
  }
  if (gaps.size() > most) line += fmt::format(" and {} more pairs of parts", gaps.size() - most);
  return line;
}

}  // namespace percuss
