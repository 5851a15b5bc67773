#pragma once
// Refuses meshes that cannot be run, naming elements by the user's ids.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/part_mesh.hpp"

namespace percuss {

/// The first few problems in full and the number of all.
class Problems {
 public:
  static constexpr std::size_t max_shown = 10;

  /// Whether the next problem's text will be kept; lets callers skip composing the others.
  bool shows_next() const { return texts_.size() < max_shown; }
  void add(std::string text) {
    ++count_;
    if (shows_next()) texts_.push_back(std::move(text));
  }
  void add_unshown() { ++count_; }
  bool empty() const { return count_ == 0; }
  std::size_t count() const { return count_; }

  /// Adds what another rank found after this.
  void append(const Problems& later);

  const std::vector<std::string>& texts() const { return texts_; }

  /// `count` problems of which `texts` are the first.
  static Problems restore(std::vector<std::string> texts, std::size_t count);

  /// The texts, each after `prefix` on a line of its own, and a last line with the number of those left out.
  std::string join(const std::string& prefix) const;

 private:
  std::vector<std::string> texts_;
  std::size_t count_ = 0;
};

/// The user's id of an element or node of a part.
inline std::int64_t id_of(const std::vector<std::int64_t>& ids, std::size_t index) {
  return ids.empty() ? static_cast<std::int64_t>(index) + 1 : ids[index];
}

/// Adds a problem for every element that names a node twice and for every one with the corners of an earlier one.
/// Corners must be valid node indexes.
void check_connectivity(const PartMesh& mesh, Problems& problems);

/// Faults of the places of a part's nodes and with the shapes of its elements, gathered one by one.
struct GeometryFindings {
  Problems nodes, elements;
  std::size_t flat_corners = 0;  // elements with a corner whose Jacobian is zero
  std::string first_flat;        // the first of them

  /// Adds a problem if a coordinate is not finite.
  void check_node(std::int64_t id, const Vec3& place);

  /// Adds a problem if an element has no positive mean volume (Flanagan and Belytschko 1981) or a corner turned inside
  /// out. A corner with a Jacobian of zero is allowed and counted: the mean quadrature stays regular, but the element
  /// is at the brink of inversion. Of a shell: if it has no area or is not convex; of a beam: if it has no length.
  /// corners: as kernels see them; node_ids: those of its own corners.
  void check_element(const Topology& topology, std::int64_t id, const ElementCorners& corners,
                     std::span<const std::int64_t> node_ids);

  /// Adds what was found in later nodes and elements of the part.
  void append(const GeometryFindings& later);

  /// The problems to tell: those of the nodes, if there are any; shapes mean nothing then.
  const Problems& problems() const { return nodes.empty() ? elements : nodes; }

  /// Appends to the warnings of the part.
  void warn(std::vector<Warning>& warnings) const;
};

/// Checks all nodes and elements of a part.
GeometryFindings check_geometry(const PartMesh& mesh);

}  // namespace percuss
