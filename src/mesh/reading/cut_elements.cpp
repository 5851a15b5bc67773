#include "src/mesh/reading/cut_elements.hpp"

#include <algorithm>

#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// The ten nodes, from those of the pieces at its corners.
std::array<int, tet10_nodes> gather_nodes(const Elements& elements, int first_piece) {
  std::array<int, tet10_nodes> nodes{};
  const auto pieces = cut_tet10(0);
  for (std::size_t p = 0; p < 4; ++p) {
    const std::span<const int> corners = elements.corners(at(first_piece) + p);
    for (std::size_t c = 0; c < corners.size(); ++c) nodes[at(pieces[p][c])] = corners[c];
  }
  return nodes;
}

bool has_face(const Elements& elements, const ElementFace& face, std::array<int, 3> nodes) {
  std::sort(nodes.begin(), nodes.end());
  const std::array<int, 4> key = elements.face_key(face);
  return std::equal(nodes.begin(), nodes.end(), key.begin());
}

}  // namespace

std::size_t find_shortest_diagonal(std::span<const int> nodes, const std::vector<Vec3>& x,
                                   const std::vector<std::int64_t>& ids) {
  constexpr double round_off = 1e-6;  // also that of places in single precision
  std::array<double, 3> length{};
  std::array<std::int64_t, 3> id{};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t from = at(nodes[at(tet10_diagonals[d][0])]), to = at(nodes[at(tet10_diagonals[d][1])]);
    length[d] = find_distance(x[from], x[to]);
    id[d] = std::min(ids[from], ids[to]);
  }
  const double most = (1 + round_off) * *std::min_element(length.begin(), length.end());
  std::size_t chosen = tet10_diagonals.size();
  for (std::size_t d = 0; d < 3; ++d)
    if (length[d] <= most && (chosen == tet10_diagonals.size() || id[d] < id[chosen])) chosen = d;
  return chosen == tet10_diagonals.size() ? 0 : chosen;  // places that are no numbers are refused later
}

bool CutElements::has(int element) const { return std::binary_search(first_.begin(), first_.end(), element); }

std::vector<ElementFace> CutElements::find_faces(const Elements& elements, int first_piece, int side) {
  constexpr int faces = tet4_topology.face_count;
  if (side < 0 || side >= tet10_sides) return {};
  const std::array<int, tet10_nodes> nodes = gather_nodes(elements, first_piece);
  const int of_face = side < faces ? side : (side - faces) / 4;
  const auto triangles = cut_tet10_face(of_face);
  std::vector<ElementFace> found;
  for (int t = 0; t < 4; ++t) {
    if (side >= faces && t != (side - faces) % 4) continue;
    const auto& [a, b, c] = triangles[at(t)];
    for (int piece = first_piece; piece < first_piece + static_cast<int>(tet10_pieces); ++piece)
      for (int f = 0; f < faces; ++f)
        if (has_face(elements, {piece, f}, {nodes[at(a)], nodes[at(b)], nodes[at(c)]})) found.push_back({piece, f});
  }
  return found;
}

std::optional<std::int64_t> find_piece_stride(const std::vector<std::int64_t>& ids, std::int64_t highest) {
  const std::int64_t largest = ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
  std::int64_t stride = 10;
  while (stride <= largest && stride <= highest) stride *= 10;
  return stride * static_cast<std::int64_t>(tet10_pieces) <= highest ? std::optional(stride) : std::nullopt;
}

}  // namespace percuss
