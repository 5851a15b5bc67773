#include "src/contact/overlap/face_index.hpp"

#include <algorithm>

#include "src/index.hpp"

namespace percuss {

bool are_joined(const FaceSide& edge, const FaceTopology& face) {
  for (const std::int64_t end : edge.ends)
    for (int k = 0; k < 4; ++k)
      if (face.corners[k] == end || face.backs[k] == end) return true;
  return false;
}

FaceIndex::FaceIndex(const SurfaceShare& share, const HostPlaces& x) : share_(share), x_(x) {
  std::map<int, std::vector<HostBox>> boxes;
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    if (is_second_side(f)) continue;
    kept_.push_back(f);
    HostBox box;
    for (const Point3& corner : load(f, {}).corner) box.add(corner);
    box.item = static_cast<int>(f);
    boxes[share.faces[f].body].push_back(box);
  }
  for (auto& [body, list] : boxes) trees_.emplace(body, BoxTree(std::move(list)));
  mark_rims();
  choose_sides();
}

FacePoints FaceIndex::load(std::size_t face, const Point3& origin) const {
  FacePoints points;
  for (std::size_t k = 0; k < 4; ++k) points.corner[k] = load_row(x_, share_.face_corners[face][k]) - origin;
  return points;
}

/// Numbers of the ends of a side, ascending.
std::pair<std::int64_t, std::int64_t> FaceIndex::list_side(std::size_t face, std::size_t side) const {
  const auto& corners = share_.faces[face].corners;
  return std::minmax(corners[side], corners[(side + 1) % 4]);
}

std::vector<BodyFaces> FaceIndex::list_bodies(int rank) const {
  std::map<int, BodyFaces> own;
  for (const std::size_t f : kept_) {
    BodyFaces& body = own[share_.faces[f].body];
    body.body = share_.faces[f].body;
    body.rank = rank;
    for (const Point3& corner : load(f, {}).corner) body.box.add(corner);
    if (share_.faces[f].offset > 0) body.has_shells = 1;
  }
  std::vector<BodyFaces> list;
  list.reserve(own.size());
  for (const auto& [number, body] : own) list.push_back(body);
  return list;
}

FaceSide FaceIndex::name(std::size_t face, std::size_t side, int in) const {
  const auto [first, last] = list_side(face, side);
  const FaceTopology& of = share_.faces[face];
  return {{first, last}, of.body, of.part, of.surface_class, in};
}

TravellingEdge FaceIndex::load_edge(std::size_t face, std::size_t side, int in) const {
  TravellingEdge edge{name(face, side, in), {}};
  const std::size_t next = (side + 1) % 4;
  const bool is_forward = share_.faces[face].corners[side] == edge.ends[0];
  edge.x[0] = load_row(x_, share_.face_corners[face][is_forward ? side : next]);
  edge.x[1] = load_row(x_, share_.face_corners[face][is_forward ? next : side]);
  return edge;
}

HostBox FaceIndex::bound_side(std::size_t face, std::size_t side) const {
  HostBox box;
  for (const std::size_t k : {side, (side + 1) % 4}) box.add(load_row(x_, share_.face_corners[face][k]));
  return box;
}

BoxTree* FaceIndex::find_tree(int body) {
  const auto tree = trees_.find(body);
  return tree == trees_.end() ? nullptr : &tree->second;
}

std::int64_t FaceIndex::tests() const {
  std::int64_t sum = 0;
  for (const auto& [body, tree] : trees_) sum += tree.tests();
  return sum;
}

bool FaceIndex::is_second_side(std::size_t face) const {
  const std::vector<FaceTopology>& faces = share_.faces;
  return face > 0 && faces[face].offset > 0 &&
         find_element_of_face(faces[face].number) == find_element_of_face(faces[face - 1].number);
}

void FaceIndex::mark_rims() {
  for (const EdgeTopology& edge : share_.edges)
    if (edge.elements[0] == edge.elements[1]) rims_.emplace_back(edge.ends[0], edge.ends[1]);
  std::sort(rims_.begin(), rims_.end());
}

/// Chooses, for each pair of nodes, the first side of each part between them. Lists hold the second nodes of a first
/// one.
void FaceIndex::choose_sides() {
  struct Other {
    int node, part, next;
  };
  std::vector<int> first(x_.extent(0), -1);
  std::vector<Other> others;
  others.reserve(2 * kept_.size());
  sides_.assign(share_.faces.size(), 0);
  for (const std::size_t f : kept_)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& corners = share_.face_corners[f];
      const auto [a, b] = std::minmax(corners[k], corners[(k + 1) % 4]);
      int place = first[at(a)];
      const int part = share_.faces[f].part;
      while (place >= 0 && (others[at(place)].node != b || others[at(place)].part != part))
        place = others[at(place)].next;
      if (a == b || place >= 0) continue;
      others.push_back({b, part, first[at(a)]});
      first[at(a)] = static_cast<int>(others.size()) - 1;
      sides_[f] |= 1U << k;
    }
}

}  // namespace percuss
