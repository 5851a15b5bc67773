// Array copies, rotations and translation of a part.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/part_mesh.hpp"
#include "src/mesh/parts/part_placement.hpp"

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

/// The first copy keeps the ids of the file, the others count on from the highest.
void copy_ids(std::vector<std::int64_t>& ids, std::size_t copies) {
  if (ids.empty()) return;
  const std::size_t count = ids.size();
  const std::int64_t highest = *std::max_element(ids.begin(), ids.end());
  ids.resize(count * copies);
  std::iota(ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end(), highest + 1);
}

/// Elements, ids and sets of all copies; copies of nodes and elements follow each other.
void copy_part(PartMesh& mesh, std::size_t copies, std::size_t node_count) {
  const std::size_t element_count = mesh.elements.size();
  std::vector<int> corners;
  for (std::size_t i = element_count; i < element_count * copies; ++i) {
    const std::span<const int> first = mesh.elements.corners(i % element_count);
    corners.assign(first.begin(), first.end());
    for (int& node : corners) node += static_cast<int>(i / element_count * node_count);
    mesh.elements.add(mesh.elements.block_index(i % element_count), corners);
    std::vector<double>& thickness = mesh.elements.own_thickness;
    if (!thickness.empty()) thickness.push_back(thickness[i % element_count]);
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

PartPlacement::PartPlacement(const PartDeck& part) : array_(part.array), at_(part.at) {
  if (array_) copies_ = array_->count[0] * array_->count[1] * array_->count[2];
  for (const Rotation& rotation : part.rotate) {
    turns_.push_back({make_rotation(rotation.axis, rotation.degrees), rotation.center});
  }
}

Vec3 PartPlacement::find_offset(int copy) const {
  const int i = copy % array_->count[0], j = copy / array_->count[0] % array_->count[1];
  const int k = copy / array_->count[0] / array_->count[1];
  const std::size_t stagger_axis = array_->count[1] > 1 ? 1 : 0;
  Vec3 offset{i * array_->pitch[0], j * array_->pitch[1], k * array_->pitch[2]};
  if (k % 2 == 1) offset[stagger_axis] += array_->stagger * array_->pitch[stagger_axis];
  return offset;
}

Vec3 PartPlacement::operator()(const Vec3& local, int copy) const {
  Vec3 x = local;
  if (array_) x = add(x, find_offset(copy));
  for (const auto& [r, center] : turns_) {
    const Vec3 d = subtract(x, center);
    for (std::size_t i = 0; i < 3; ++i) x[i] = center[i] + (r[i][0] * d[0] + r[i][1] * d[1] + r[i][2] * d[2]);
  }
  return add(x, at_);
}

void add_side_nodes(PartMesh& mesh) {
  for (const auto& [name, faces] : mesh.side_sets) {
    if (mesh.node_sets.contains(name)) continue;
    std::vector<int>& nodes = mesh.node_sets[name];
    for (const ElementFace& f : faces) {
      const std::array<int, 4> corners = mesh.elements.face_nodes(f);
      nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
}

void place_part(PartMesh& mesh, const PartDeck& part) {
  const PartPlacement place(part);
  const std::vector<Vec3> local = std::exchange(mesh.nodes, {});
  mesh.nodes.reserve(local.size() * static_cast<std::size_t>(place.copies()));
  for (int copy = 0; copy < place.copies(); ++copy) {
    for (const Vec3& x : local) mesh.nodes.push_back(place(x, copy));
  }
  const auto copies = static_cast<std::size_t>(place.copies());
  if (copies > 1) copy_part(mesh, copies, local.size());
}

}  // namespace percuss
