// Array copies, rotations and translation of a part.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

#include "src/deck/part_images.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/part_mesh.hpp"
#include "src/mesh/parts/mirrored_order.hpp"
#include "src/mesh/parts/part_placement.hpp"

namespace percuss {
namespace {

/// The first copy keeps the ids of the file, the others count on from the highest.
void copy_ids(std::vector<std::int64_t>& ids, std::size_t copies) {
  if (ids.empty()) return;
  const std::size_t count = ids.size();
  const std::int64_t highest = *std::max_element(ids.begin(), ids.end());
  ids.resize(count * copies);
  std::iota(ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end(), highest + 1);
}

/// Corners of mirrored elements in an order that is right-handed again; side sets keep their faces.
void mirror_elements(PartMesh& mesh) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const std::span<int> nodes = mesh.elements.corners(e);
    const std::vector<int> before(nodes.begin(), nodes.end());
    const MirroredOrder order = find_mirrored_order(mesh.elements.topology_of(e));
    for (std::size_t c = 0; c < nodes.size(); ++c) nodes[c] = before[at(order.corner[c])];
  }
  for (auto& [name, faces] : mesh.side_sets) {
    for (ElementFace& f : faces) {
      const Topology& topology = mesh.elements.topology_of(at(f.element));
      f.face = find_mirrored_order(topology).face[at(f.face)];
    }
    std::sort(faces.begin(), faces.end());
  }
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
  for (const PartImage& image : part.images) {
    const bool is_shift = image.kind == PartImage::Kind::shift;
    motions_.push_back({find_matrix(image), image.center, is_shift ? image.way : Vec3{}});
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
  x = add(x, at_);
  for (const Motion& motion : motions_) x = motion(x);
  return x;
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
  if (is_mirrored(part)) mirror_elements(mesh);
}

}  // namespace percuss
