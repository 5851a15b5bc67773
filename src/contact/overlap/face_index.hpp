#pragma once
// The faces of a rank at the places of a moment, with their sides, and trees in which others look for them.

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "kernels/contact/geometry/face_geometry.hpp"
#include "src/contact/overlap/box_tree.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// A line between two nodes, a side of a face or a beam, where it is looked for in the faces of a body.
struct FaceSide {
  std::int64_t ends[2];  // numbers of its nodes, ascending
  int body, part;
  int surface_class;  // -1: of a beam that touches nothing
  int in;             // the body that it is looked for in
};

/// A side with its coordinates, as it is sent to ranks with faces of the body.
struct TravellingEdge : FaceSide {
  Point3 x[2];
};

/// Faces of a body on a rank.
struct BodyFaces {
  int body = 0, rank = 0;
  HostBox box;
  int has_shells = 0;
};

/// Whether an edge has an end in common with the element behind a face: where that turns inside out it goes through
/// itself.
bool are_joined(const FaceSide& edge, const FaceTopology& face);

/// Faces and their sides on this rank, by body. Of the two faces of a shell it holds one.
class FaceIndex {
 public:
  /// Both outlive it.
  FaceIndex(const SurfaceShare& share, const HostPlaces& x);

  const FaceTopology& topology(std::size_t face) const { return share_.faces[face]; }

  /// Whether a sheet ends at this side of a face, as far as edges touch.
  bool is_rim(std::size_t face, std::size_t side) const {
    return std::binary_search(rims_.begin(), rims_.end(), list_side(face, side));
  }

  FacePoints load(std::size_t face, const Point3& origin) const;
  std::vector<BodyFaces> list_bodies(int rank) const;

  /// Calls visit(side) for those of a face that no face of its part with a lower number has.
  template <class Visit>
  void visit_sides(std::size_t face, const Visit& visit) const {
    for (std::size_t k = 0; k < 4; ++k)
      if ((sides_[face] & (1U << k)) != 0) visit(k);
  }

  FaceSide name(std::size_t face, std::size_t side, int in) const;
  TravellingEdge load_edge(std::size_t face, std::size_t side, int in) const;
  HostBox bound_side(std::size_t face, std::size_t side) const;

  /// Places of faces in the share; of a shell that of its first side.
  const std::vector<std::size_t>& kept() const { return kept_; }

  /// Null: this rank has no faces of the body.
  BoxTree* find_tree(int body);
  std::int64_t tests() const;

 private:
  bool is_second_side(std::size_t face) const;
  std::pair<std::int64_t, std::int64_t> list_side(std::size_t face, std::size_t side) const;
  void mark_rims();
  void choose_sides();

  const SurfaceShare& share_;
  const HostPlaces& x_;
  std::vector<std::size_t> kept_;
  std::vector<unsigned> sides_;  // [faces] bits of those of visit_sides()
  std::map<int, BoxTree> trees_;
  std::vector<std::pair<std::int64_t, std::int64_t>> rims_;  // ends of the edges where shells of this rank end
};

}  // namespace percuss
