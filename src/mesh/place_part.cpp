// Array copies, rotations and translation of a part.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

#include "src/mesh/part_mesh.hpp"

namespace percuss {
namespace {

using Matrix3 = std::array<Vec3, 3>;

/// Cosine and sine of an angle in degrees, exact at multiples of 90 so that turned meshes stay on their planes.
std::pair<double, double> cosine_and_sine(double degrees) {
  const double rest = std::remainder(degrees, 90.0);  // exact, in [-45, 45]
  const double c = std::cos(rest * std::numbers::pi / 180), s = std::sin(rest * std::numbers::pi / 180);
  const double quarter_turns = std::remainder((degrees - rest) / 90, 4.0);  // -2, -1, 0, 1 or 2
  if (quarter_turns == 0) return {c, s};
  if (quarter_turns == 1) return {-s, c};
  if (quarter_turns == -1) return {s, -c};
  return {-c, -s};
}

/// Rodrigues' formula, R = c I + s [k]x + (1 - c) k k^T.
Matrix3 make_rotation(const Vec3& k, double degrees) {
  const auto [c, s] = cosine_and_sine(degrees);
  const double v = 1 - c;
  return {{{c + v * k[0] * k[0], v * k[0] * k[1] - s * k[2], v * k[0] * k[2] + s * k[1]},
           {v * k[1] * k[0] + s * k[2], c + v * k[1] * k[1], v * k[1] * k[2] - s * k[0]},
           {v * k[2] * k[0] - s * k[1], v * k[2] * k[1] + s * k[0], c + v * k[2] * k[2]}}};
}

void rotate(std::vector<Vec3>& nodes, const Rotation& rotation) {
  const Matrix3 r = make_rotation(rotation.axis, rotation.degrees);
  const Vec3& center = rotation.center;
  for (Vec3& x : nodes) {
    const Vec3 d{x[0] - center[0], x[1] - center[1], x[2] - center[2]};
    for (std::size_t i = 0; i < 3; ++i) x[i] = center[i] + (r[i][0] * d[0] + r[i][1] * d[1] + r[i][2] * d[2]);
  }
}

std::vector<Vec3> list_copy_offsets(const ArrayCopies& array) {
  const std::size_t stagger_axis = array.count[1] > 1 ? 1 : 0;
  std::vector<Vec3> offsets;
  for (int k = 0; k < array.count[2]; ++k) {
    for (int j = 0; j < array.count[1]; ++j) {
      for (int i = 0; i < array.count[0]; ++i) {
        Vec3 offset{i * array.pitch[0], j * array.pitch[1], k * array.pitch[2]};
        if (k % 2 == 1) offset[stagger_axis] += array.stagger * array.pitch[stagger_axis];
        offsets.push_back(offset);
      }
    }
  }
  return offsets;
}

/// The first copy keeps the ids of the file, the others count on from the highest.
void copy_ids(std::vector<std::int64_t>& ids, std::size_t copies) {
  if (ids.empty()) return;
  const std::size_t count = ids.size();
  const std::int64_t highest = *std::max_element(ids.begin(), ids.end());
  ids.resize(count * copies);
  std::iota(ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end(), highest + 1);
}

void copy_part(PartMesh& mesh, const ArrayCopies& array) {
  const std::vector<Vec3> offsets = list_copy_offsets(array);
  const std::size_t copies = offsets.size(), node_count = mesh.nodes.size(), element_count = mesh.elements.size();
  const std::vector<Vec3> nodes = std::exchange(mesh.nodes, {});
  mesh.nodes.reserve(node_count * copies);
  mesh.elements.reserve(element_count * copies);
  for (std::size_t copy = 0; copy < copies; ++copy) {
    const Vec3& o = offsets[copy];
    for (const Vec3& x : nodes) mesh.nodes.push_back({x[0] + o[0], x[1] + o[1], x[2] + o[2]});
    for (std::size_t e = 0; copy > 0 && e < element_count; ++e) {
      std::array<int, 8> corners = mesh.elements[e];
      for (int& node : corners) node += static_cast<int>(copy * node_count);
      mesh.elements.push_back(corners);
    }
  }
  copy_ids(mesh.node_ids, copies);
  copy_ids(mesh.element_ids, copies);
  for (auto& [name, set] : mesh.node_sets) {
    const std::size_t count = set.size();
    for (std::size_t i = count; i < count * copies; ++i) {
      set.push_back(set[i % count] + static_cast<int>(i / count * node_count));
    }
  }
  for (auto& [name, set] : mesh.side_sets) {
    const std::size_t count = set.size();
    for (std::size_t i = count; i < count * copies; ++i) {
      set.push_back({set[i % count].element + static_cast<int>(i / count * element_count), set[i % count].face});
    }
  }
}

}  // namespace

void place_part(PartMesh& mesh, const PartDeck& part) {
  if (part.array) copy_part(mesh, *part.array);
  for (const Rotation& rotation : part.rotate) rotate(mesh.nodes, rotation);
  for (Vec3& x : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) x[d] += part.at[d];
  }
}

}  // namespace percuss
