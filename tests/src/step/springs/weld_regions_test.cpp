// The region of a weld is a disc, whatever the mesh under it: its moments are those of a disc. What an end of such a
// weld passes on has the momenta that it was given.

#include "src/step/springs/weld_regions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/deck/reading/read_deck.hpp"
#include "src/index.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/weld_patch.hpp"

namespace percuss {
namespace {

ChunkedMesh make_mesh(const std::string& shape) {
  const Deck deck =
      parse_deck(fmt::format("time: {{end: 1}}\nparts: {{p: {{{}, material: m}}}}\n"
                             "materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}}}\n",
                             shape),
                 "deck.yaml");
  return load_mesh(deck, Communicator(MPI_COMM_SELF));
}

WeldRegion find_region(const ChunkedMesh& chunked, const Vec3& place, double radius) {
  return find_weld_regions(chunked, {{place, radius, {0, 0}}}, {find_exterior_faces(chunked.mesh)}, 10)[0][0];
}

Vec3 find_node(const ChunkedMesh& chunked, std::int64_t number) {
  return chunked.mesh.nodes[at(find_local_node(chunked, number))];
}

Vec3 find_center(const ChunkedMesh& chunked, const WeldRegion& region) {
  Vec3 center{};
  for (std::size_t i = 0; i < region.nodes.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) center[k] += region.weights[i] * find_node(chunked, region.nodes[i])[k];
  return center;
}

/// Mean of the products of the distances from the centre along two directions.
double find_moment(const ChunkedMesh& chunked, const WeldRegion& region, std::size_t j, std::size_t k) {
  const Vec3 center = find_center(chunked, region);
  double sum = 0;
  for (const ShapeProduct& product : region.products)
    sum += product.mean * (find_node(chunked, region.nodes[at(product.node)])[j] - center[j]) *
           (find_node(chunked, region.nodes[at(product.other)])[k] - center[k]);
  return sum;
}

}  // namespace

// Elements larger than the disc, about as large, and far smaller; shells and the top of a block of solids.
TEST(WeldRegions, HaveTheMomentsOfADiscOnAnyMesh) {
  const double radius = 0.3;
  const std::string shapes[] = {"shell_plate: {size: [3, 2], cells: [1, 1]}, thickness: 0.1",
                                "shell_plate: {size: [3, 2], cells: [9, 7]}, thickness: 0.1",
                                "shell_plate: {size: [3, 2], cells: [90, 70]}, thickness: 0.1",
                                "box: {size: [3, 2, 1], cells: [7, 9, 2]}, at: [0, 0, -1]",
                                "box: {size: [3, 2, 1], cells: [5, 4, 2]}, elements: tetrahedra, at: [0, 0, -1]"};
  for (const std::string& shape : shapes) {
    const ChunkedMesh chunked = make_mesh(shape);
    const WeldRegion region = find_region(chunked, {1.13, 0.87, 0.05}, radius);
    EXPECT_NEAR(region.distance, 0.05, 1e-12) << shape;
    EXPECT_NEAR(std::abs(region.normal[2]), 1, 1e-12);
    EXPECT_EQ(region.covered, 1);
    const Vec3 center = find_center(chunked, region);
    EXPECT_NEAR(center[0], 1.13, 1e-9) << shape;
    EXPECT_NEAR(center[1], 0.87, 1e-9);
    const double square = radius * radius / 4;
    EXPECT_NEAR(find_moment(chunked, region, 0, 0), square, 1e-9) << shape;
    EXPECT_NEAR(find_moment(chunked, region, 1, 1), square, 1e-9);
    EXPECT_NEAR(find_moment(chunked, region, 0, 1), 0, 1e-9);
  }
}

TEST(WeldRegions, EndAtTheRimOfTheirFaces) {
  const ChunkedMesh chunked = make_mesh("shell_plate: {size: [3, 2], cells: [9, 7]}, thickness: 0.1");
  const WeldRegion region = find_region(chunked, {-0.1, 1, 0}, 0.3);
  EXPECT_NEAR(region.distance, 0.1, 1e-12);
  EXPECT_NEAR(region.covered, 0.5, 0.01);  // the disc lies around the nearest point, on the rim
  EXPECT_TRUE(find_region(chunked, {1, 1, 4}, 0.3).nodes.empty());  // beyond ten radii
}

// Nodes at random, some held in some directions: the impulses of the nodes have the sum and the moment of what the end
// gets, and its motion changes as its response says.
TEST(MovingPatch, PassesOnImpulseAndMoment) {
  const ChunkedMesh chunked = make_mesh("shell_plate: {size: [3, 2], cells: [9, 7]}, thickness: 0.1");
  const WeldRegion region = find_region(chunked, {1.13, 0.87, 0}, 0.5);
  WeldPatch patch;
  patch.weights = region.weights;
  patch.products = region.products;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vector3<double>{number(generator), number(generator), number(generator)}; };
  std::vector<WeldNode> nodes(region.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    patch.nodes.push_back(static_cast<int>(i));
    const Vec3 place = find_node(chunked, region.nodes[i]);
    nodes[i].place = Vector3<double>{place[0], place[1], place[2]} + 0.1 * vector();
    nodes[i].velocity = vector();
    const double inverse = 1.5 + number(generator);
    nodes[i].inverse_mass = {inverse, i % 4 == 0 ? 0 : inverse, inverse};
  }
  const MovingPatch moving(patch, nodes, {});
  ASSERT_TRUE(moving.turns());
  const WeldNode before = moving.find_end(nodes);
  const Vector3<double> p = vector(), q = vector();
  std::vector<NodeImpulse> given(nodes.size());
  moving.give(p, q, nodes, given);
  Vector3<double> sum{0, 0, 0}, moment{0, 0, 0};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum = sum + given[i].impulse;
    moment = moment + cross(nodes[i].place - before.place, given[i].impulse);
  }
  EXPECT_LT(norm(sum - p), 1e-14);
  EXPECT_LT(norm(moment - q), 1e-13);
  const WeldNode after = moving.find_end(nodes);
  Vector3<double> velocity = before.velocity, spin = before.spin;
  const double by[] = {p.x, p.y, p.z, q.x, q.y, q.z};
  for (std::size_t k = 0; k < 6; ++k) {
    velocity = velocity + by[k] * before.response.column[k].velocity;
    spin = spin + by[k] * before.response.column[k].spin;
  }
  EXPECT_LT(norm(after.velocity - velocity), 1e-13);
  EXPECT_LT(norm(after.spin - spin), 1e-12);
}

// A patch that moves as a rigid body has this motion, on any warped mesh.
TEST(MovingPatch, HasTheMotionOfARigidBody) {
  const ChunkedMesh chunked = make_mesh("box: {size: [3, 2, 1], cells: [7, 9, 2]}, at: [0, 0, -1]");
  const WeldRegion region = find_region(chunked, {1.13, 0.87, 0}, 0.4);
  WeldPatch patch;
  patch.weights = region.weights;
  patch.products = region.products;
  const Vector3<double> velocity{1, -2, 3}, spin{0.3, 0.5, -0.7};
  std::vector<WeldNode> nodes(region.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    patch.nodes.push_back(static_cast<int>(i));
    const Vec3 place = find_node(chunked, region.nodes[i]);
    nodes[i].place = {place[0], place[1], 0.1 * std::sin(7 * place[0] + 5 * place[1])};
    nodes[i].velocity = velocity + cross(spin, nodes[i].place);
    nodes[i].inverse_mass = {1, 1, 1};
  }
  const WeldNode end = MovingPatch(patch, nodes, {}).find_end(nodes);
  EXPECT_LT(norm(end.spin - spin), 1e-12);
  EXPECT_LT(norm(end.velocity - velocity - cross(spin, end.place)), 1e-12);
}

}  // namespace percuss
