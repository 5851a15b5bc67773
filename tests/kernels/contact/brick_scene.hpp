#pragma once
// Hexahedral bricks of one element each as a contact surface, for tests: every node is a contact node.

#include <array>
#include <random>
#include <vector>

#include "kernels/contact/rows/row_system.hpp"
#include "kernels/contact/search/pair_search.hpp"

namespace percuss::test {

inline constexpr int brick_faces[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                          {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
inline constexpr int brick_backs[6][4] = {{3, 2, 6, 7}, {0, 3, 7, 4}, {1, 0, 4, 5},
                                          {1, 5, 6, 2}, {4, 7, 6, 5}, {0, 1, 2, 3}};

/// Face numbers within a brick, by the direction that they look in.
enum BrickSide { y_min = 0, x_max = 1, y_max = 2, x_min = 3, z_min = 4, z_max = 5 };

template <class T>
Array<T> to_array(const std::vector<T>& values) {
  Array<T> array("test::array", values.size());
  const auto host = Kokkos::create_mirror_view(array);
  for (std::size_t i = 0; i < values.size(); ++i) host(i) = values[i];
  Kokkos::deep_copy(array, host);
  return array;
}

inline Rows3<double> to_rows(const std::vector<Point3>& values) {
  Rows3<double> rows("test::rows", values.size());
  const auto host = Kokkos::create_mirror_view(rows);
  for (std::size_t i = 0; i < values.size(); ++i) store_row(host, static_cast<int>(i), values[i]);
  Kokkos::deep_copy(rows, host);
  return rows;
}

inline Rows4<int> to_rows4(const std::vector<std::array<int, 4>>& values) {
  Rows4<int> rows("test::rows4", values.size());
  const auto host = Kokkos::create_mirror_view(rows);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < 4; ++j) host(i, j) = values[i][j];
  Kokkos::deep_copy(rows, host);
  return rows;
}

/// Bricks of n x n x n elements or single ones, one body each; positions, velocities and masses by node.
class BrickScene {
 public:
  /// Adds a brick of one element; its nodes are 8 b to 8 b + 7, its faces 6 b to 6 b + 5.
  int add_brick(const Point3& corner, const Point3& size, const Point3& velocity = {}, double node_mass = 1) {
    const int brick = static_cast<int>(x.size()) / 8, first = 8 * brick;
    for (int i = 0; i < 8; ++i) {
      const bool on_x = i == 1 || i == 2 || i == 5 || i == 6, on_y = i % 4 >= 2, on_z = i >= 4;
      x.push_back(corner + Point3{on_x ? size.x : 0, on_y ? size.y : 0, on_z ? size.z : 0});
      v.push_back(velocity);
      inverse_mass.push_back({1 / node_mass, 1 / node_mass, 1 / node_mass});
    }
    for (int f = 0; f < 6; ++f) {
      std::array<int, 4> corners{}, backs{};
      for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = first + brick_faces[f][i];
        backs[i] = first + brick_backs[f][i];
      }
      faces_.push_back(corners);
      backs_.push_back(backs);
    }
    return brick;
  }

  int num_nodes() const { return static_cast<int>(x.size()); }
  int num_faces() const { return static_cast<int>(faces_.size()); }

  ContactSurface surface(double friction = 0) const {
    std::vector<int> nodes, offset{0}, node_faces, node_body, face_body, zeros_n(x.size(), 0),
        zeros_f(faces_.size(), 0);
    std::vector<int> all_faces;
    for (int n = 0; n < num_nodes(); ++n) {
      nodes.push_back(n);
      node_body.push_back(n / 8);
      for (int f = 0; f < num_faces(); ++f)
        for (const int corner : faces_[static_cast<std::size_t>(f)])
          if (corner == n) node_faces.push_back(f);
      offset.push_back(static_cast<int>(node_faces.size()));
    }
    for (int f = 0; f < num_faces(); ++f) {
      face_body.push_back(f / 6);
      all_faces.push_back(f);
    }
    ContactSurface s;
    s.num_nodes = num_nodes();
    s.num_faces = num_faces();
    s.nodes = to_array(nodes);
    s.nodes_to_faces_offset = to_array(offset);
    s.nodes_to_faces = to_array(node_faces);
    s.face_corners = to_rows4(faces_);
    s.face_backs = to_rows4(backs_);
    s.node_body = to_array(node_body);
    s.face_body = to_array(face_body);
    s.node_class = to_array(zeros_n);
    s.face_class = to_array(zeros_f);
    s.searched_nodes = to_array(nodes);
    s.searched_faces = to_array(all_faces);
    s.pair_friction = to_array(std::vector<double>{friction});
    s.pair_number = to_array(std::vector<int>{0});
    return s;
  }

  std::vector<Point3> x, v, inverse_mass;
  bool has_thickness = false;  // EnforcedScene: its rows are as those of shells

 private:
  std::vector<std::array<int, 4>> faces_, backs_;
};

/// A crooked pile of bricks that fall with different velocities.
inline BrickScene make_pile() {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {3, 3, 1}, {0.1, 0, 0.2}, 5);
  bricks.add_brick({0.3, 0.2, 1}, {1.2, 1.1, 1}, {0, 0.1, -0.5}, 1);
  bricks.add_brick({1.6, 0.4, 1}, {1, 1.3, 1}, {-0.2, 0, -0.7}, 2);
  bricks.add_brick({0.9, 0.5, 2}, {1.4, 0.9, 1}, {0, -0.1, -1}, 3);
  return bricks;
}

/// A wall of n x n bricks in a running bond that drops on its held foot, every brick a little differently.
inline BrickScene make_brick_wall(int n) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> speed(-0.01, 0.01);
  BrickScene bricks;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      bricks.add_brick({i + 0.5 * (k % 2), 0, 1.0 * k}, {1, 1, 1},
                       {speed(random), speed(random), -0.1 + speed(random)});
  for (std::size_t a = 0; a < bricks.x.size(); ++a) {
    if (bricks.x[a].z > 0.5) continue;
    bricks.inverse_mass[a] = {0, 0, 0};
    bricks.v[a] = {0, 0, 0};
  }
  return bricks;
}

/// No history for a surface with `pairs` pairs of a wall and a node.
inline ContactHistory make_empty_history(int num_nodes, int pairs = 0) {
  const auto faces = 3 * static_cast<std::size_t>(num_nodes), records = faces + static_cast<std::size_t>(pairs);
  ContactHistory h{Array<std::int64_t>("test::face", faces), Rows3<double>("test::impulse", records),
                   Rows3<double>("test::slip", records), Array<double>("test::reference", records)};
  Kokkos::deep_copy(h.face, std::int64_t{-1});
  return h;
}

/// Everything between the places of a scene and its touches: search, face geometry, detailed check.
struct CheckedScene {
  CheckedScene(const BrickScene& scene, double dt, double friction = 0, double margin = 1)
      : surface(scene.surface(friction)), x(to_rows(scene.x)), v(to_rows(scene.v)), motion{x, v, dt} {
    const auto f = static_cast<std::size_t>(surface.num_faces);
    boxes = Boxes("test::boxes", f);
    faces = {Rows3<double>("test::normal", f), Array<double>("test::size", f), Boxes("test::box", f)};
    history_face = Array<int>("test::history_face", static_cast<std::size_t>(3 * surface.num_nodes));
    Kokkos::deep_copy(history_face, -1);
    const SmallSpace space;
    bound_faces(space, {surface.face_corners}, motion, margin, boxes);  // every node is a contact node
    find_candidate_pairs(space, surface, {motion.x, boxes}, 1'000'000, scratch, candidates);
    list_concerned(space, surface, scratch.concerned, candidates);
    check();
  }

  void check() {
    const SmallSpace space;
    update_faces(space, surface, motion, candidates, still, faces);
    find_touches(space, inputs(), candidates, still, touches);
  }

  CheckInputs inputs() const { return {{surface, motion, faces}, history_face}; }

  /// Touches of a node.
  NodeTouches at(int node) const {
    for (int i = 0; i < candidates.num_nodes; ++i)
      if (candidates.nodes(i) == node) return touches.by_node(node);
    return {};
  }

  ContactSurface surface;
  Rows3<double> x, v;
  SurfaceMotion motion;
  Boxes boxes;
  FaceState faces;
  Array<int> history_face;
  SearchScratch scratch;
  CandidateList candidates;
  StillFaces still;
  TouchTable touches;
};

}  // namespace percuss::test
