#pragma once
// Refuses meshes that cannot be run, naming elements by the user's ids.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

/// Adds a problem for every node without finite coordinates and for every element without a positive mean volume
/// (Flanagan and Belytschko 1981) or with a corner turned inside out. A corner with a Jacobian of zero is allowed and
/// warned of: the mean quadrature stays regular, but the element is at the brink of inversion.
void check_geometry(PartMesh& mesh, Problems& problems);

}  // namespace percuss
