#include "src/contact/surface/surface_sides.hpp"

#include <algorithm>
#include <cstddef>

#include "src/contact/surface/face_corners.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

using Corners = std::array<int, 4>;

bool has_corner(const Corners& face, int node) { return std::find(face.begin(), face.end(), node) != face.end(); }

enum class Way { onward, back };  // along the corners of a face

Way reverse(Way way) { return way == Way::onward ? Way::back : Way::onward; }

/// The corner that follows `node` in a face.
int find_neighbor(const Corners& face, int node, Way way) {
  const auto place = static_cast<std::size_t>(std::find(face.begin(), face.end(), node) - face.begin());
  return face[way == Way::onward ? find_next_corner(face, place) : find_previous_corner(face, place)];
}

/// The walk around one node.
class Walk {
 public:
  Walk(const std::vector<Corners>& corners, const std::vector<double>& offset, const Buckets& node_faces, int node)
      : corners_(corners), offset_(offset), node_faces_(node_faces), node_(node) {}

  /// Appends the faces on the side of `face`, onward from its edge to the next corner, then back from the other.
  /// Returns whether the shell ends on the way.
  bool list_ring(int face, std::vector<int>& ring) const {
    const End onward = go(face, Way::onward, ring);
    if (onward == End::closed) return false;
    return (go(face, Way::back, ring) == End::open) | (onward == End::open);
  }

 private:
  enum class End { closed, junction, open };

  /// Walks over the edges to the corners that follow the node; how the walk ends.
  End go(int start, Way way, std::vector<int>& ring) const {
    for (int face = start;;) {
      const int other = find_neighbor(corners_[at(face)], node_, way);
      const std::vector<int> across = list_across(face, other);
      if (across.empty()) return End::open;
      const int next = find_same_side(across, other, reverse(way));
      if (next < 0 || std::find(ring.begin(), ring.end(), next) != ring.end()) return End::junction;
      if (next == start) return End::closed;
      ring.push_back(next);
      face = next;
    }
  }

  /// The faces of other elements that have the edge from the node to `other`.
  std::vector<int> list_across(int face, int other) const {
    std::vector<int> across;
    for (int i = node_faces_.first[at(node_)]; i < node_faces_.first[at(node_) + 1]; ++i) {
      const int candidate = node_faces_.items[at(i)];
      const Corners& corners = corners_[at(candidate)];
      const bool has_edge =
          find_neighbor(corners, node_, Way::onward) == other || find_neighbor(corners, node_, Way::back) == other;
      if (has_edge && !is_twin(face, candidate)) across.push_back(candidate);
    }
    return across;
  }

  /// The one shell among them in which `other` follows the node; -1: none, or several, or solids too.
  int find_same_side(const std::vector<int>& across, int other, Way way) const {
    int found = -1;
    for (const int face : across) {
      if (offset_[at(face)] == 0) return -1;
      if (find_neighbor(corners_[at(face)], node_, way) != other) continue;
      if (found >= 0) return -1;
      found = face;
    }
    return found;
  }

  /// Whether two faces have the same corners, as the two sides of a shell.
  bool is_twin(int a, int b) const {
    const Corners& other = corners_[at(b)];
    return std::all_of(corners_[at(a)].begin(), corners_[at(a)].end(), [&](int n) { return has_corner(other, n); });
  }

  const std::vector<Corners>& corners_;
  const std::vector<double>& offset_;
  const Buckets& node_faces_;
  int node_;
};

}  // namespace

SideRings find_side_rings(const std::vector<std::array<int, 4>>& corners, const std::vector<double>& offset,
                          const Buckets& node_faces) {
  SideRings rings;
  rings.first.push_back(0);
  std::vector<int> ring;
  for (int f = 0; f < static_cast<int>(corners.size()); ++f) {
    for (const int node : corners[at(f)]) {
      ring.clear();
      bool is_open = false;
      if (node >= 0 && offset[at(f)] > 0) {
        is_open = Walk(corners, offset, node_faces, node).list_ring(f, ring);
      } else if (node >= 0) {
        for (int i = node_faces.first[at(node)]; i < node_faces.first[at(node) + 1]; ++i) {
          const int other = node_faces.items[at(i)];
          if (other != f && offset[at(other)] == 0) ring.push_back(other);
        }
      }
      rings.faces.insert(rings.faces.end(), ring.begin(), ring.end());
      rings.first.push_back(static_cast<int>(rings.faces.size()));
      rings.is_open.push_back(is_open ? 1 : 0);
    }
  }
  return rings;
}

}  // namespace percuss
