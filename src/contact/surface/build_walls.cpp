// Rigid walls and the nodes that each stops: all nodes that an element holds, inside their bodies too, and particles.
// Where only the surface were held, an impact could drive the nodes behind it through the wall.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/face_springs.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

constexpr double elements_around = 8;  // an inner node
constexpr double endless = std::numeric_limits<double>::infinity();

/// Properties of a node by the elements that hold it. Extremes only: they do not depend on which rank has which
/// element.
struct HeldNode {
  std::int64_t number = 0;
  double size = endless;  // shortest edge there at the start
  double spring = 0;      // stiffness of the stiffest element, as if all around the node were like it
  int part = -1;          // the lowest
  bool is_inner = true;
  double offset = 0;  // of a contact node: half the thickness of the thickest shell around it [length]

  void merge(const HeldNode& other) {
    size = std::min(size, other.size);
    spring = std::max(spring, other.spring);
    part = part < 0 ? other.part : std::min(part, other.part);
  }
};

/// Measures the nodes of living solids of this rank, [nodes]; part -1: a node of none.
std::vector<HeldNode> measure_held_nodes(const Mesh& mesh, const Deck& deck) {
  std::vector<ElementFace> faces;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Topology& topology = mesh.topology_of(e);
    if (topology.is_surface()) continue;
    const std::array<int, 3> three = topology.face_count == 6 ? std::array{0, 1, 4} : std::array{0, 1, 2};
    for (const int face : three) faces.push_back({static_cast<int>(e), face});  // of a hexahedron in each direction
  }
  const std::vector<double> springs = find_face_springs(mesh, deck, faces);
  std::vector<HeldNode> held(mesh.nodes.size());
  for (std::size_t f = 0; f < faces.size(); f += 3) {
    const auto e = at(faces[f].element);
    if (mesh.eroded.any && mesh.eroded.dead[e] != 0) continue;
    const double spring = std::max({springs[f], springs[f + 1], springs[f + 2]});
    const std::span<const int> corners = mesh.corners(e);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto node = at(corners[i]);
      HeldNode of_element{mesh.node_numbers[node], endless, elements_around * spring / 4, mesh.part_of(e)};
      for (const int other : mesh.topology_of(e).corner_edges[i])
        of_element.size =
            std::min(of_element.size, find_distance(mesh.nodes[node], mesh.nodes[at(corners[at(other)])]));
      held[node].number = of_element.number;
      held[node].merge(of_element);
    }
  }
  return held;
}

/// Their owners hear of nodes that elements of other ranks hold.
void gather_held_nodes(const ChunkedMesh& chunked, std::vector<HeldNode>& held) {
  const Mesh& mesh = chunked.mesh;
  if (!mesh.ranks || mesh.ranks->size() == 1) return;
  std::vector<HeldNode> sent;
  std::vector<int> owners;
  for (const HeldNode& node : held) {
    const int owner = node.part < 0 ? mesh.ranks->rank() : chunked.numbering.find_node_owner(node.number);
    if (owner == mesh.ranks->rank()) continue;
    sent.push_back(node);
    owners.push_back(owner);
  }
  for (const HeldNode& received : ItemExchange(*mesh.ranks).send(owners, sent)) {
    const auto place = std::lower_bound(mesh.node_numbers.begin(), mesh.node_numbers.end(), received.number);
    HeldNode& node = held[static_cast<std::size_t>(place - mesh.node_numbers.begin())];
    node.number = received.number;
    node.merge(received);
  }
}

/// Half the thickness of the thickest shell around a contact node, or the radius of a beam; 0: none is one.
double find_node_offset(const SurfaceShare& share, int node) {
  const auto n = static_cast<std::size_t>(node);
  double offset = share.find_radius(n);
  for (int f = share.nodes.first_face[n]; f < share.nodes.first_face[n + 1]; ++f)
    offset = std::max(offset, share.face(share.nodes.faces[static_cast<std::size_t>(f)]).offset);
  return offset;
}

/// The nodes of this rank that walls may stop, by mesh node; of others part is -1. Contact nodes have the size of their
/// faces.
std::vector<HeldNode> find_stopped_nodes(const ChunkedMesh& chunked, const Deck& deck, const SurfaceShare& share) {
  const Mesh& mesh = chunked.mesh;
  std::vector<HeldNode> nodes = measure_held_nodes(mesh, deck);
  gather_held_nodes(chunked, nodes);
  const int own = mesh.ranks ? mesh.ranks->rank() : 0;
  for (HeldNode& node : nodes)
    if (node.part >= 0 && chunked.numbering.find_node_owner(node.number) != own) node.part = -1;
  const OwnedContactNodes& of_surface = share.nodes;
  for (std::size_t n = 0; n < of_surface.mesh_nodes.size(); ++n)
    nodes[at(of_surface.mesh_nodes[n])] = {of_surface.numbers[n],
                                           of_surface.sizes[n],
                                           of_surface.springs[n],
                                           of_surface.parts[n],
                                           false,
                                           find_node_offset(share, static_cast<int>(n))};
  return nodes;
}

/// Mesh nodes that a wall may stop, ascending.
std::vector<int> list_wall_nodes(const Mesh& mesh, const Deck& deck, const WallDeck& wall,
                                 const std::vector<HeldNode>& stopped) {
  std::vector<int> nodes;
  const auto add = [&](int node) {
    if (stopped[at(node)].part >= 0) nodes.push_back(node);
  };
  if (wall.nodes.empty()) {
    for (int n = 0; n < static_cast<int>(stopped.size()); ++n) add(n);
    return nodes;
  }
  for (const Selector& selector : wall.nodes)
    for (const int node : select_nodes(mesh, deck, selector)) add(node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// A unit vector across another.
Point3 find_across(const Point3& along) {
  const Point3 size = {std::abs(along.x), std::abs(along.y), std::abs(along.z)};
  const bool is_x = size.x <= size.y && size.x <= size.z, is_y = !is_x && size.y <= size.z;
  return normalize(cross(along, is_x ? Point3{1, 0, 0} : is_y ? Point3{0, 1, 0} : Point3{0, 0, 1}));
}

/// A cylinder or a sphere. across: the way out of it from its middle.
void make_round(const WallDeck& deck, ContactWall& wall) {
  wall.shape = deck.cylinder ? WallShape::cylinder : WallShape::sphere;
  wall.radius = deck.cylinder ? deck.cylinder->radius : deck.sphere->radius;
  wall.along = deck.cylinder ? to_point(deck.cylinder->axis) : Point3{1, 0, 0};
  wall.across = find_across(wall.along);
  wall.direction = to_point(deck.direction);
  if (deck.cylinder) wall.size[0] = deck.cylinder->length.value_or(0);
}

/// The wall at time 0.
ContactWall make_wall(const WallDeck& deck) {
  ContactWall wall{to_point(deck.point), to_point(deck.normal), deck.friction};
  if (deck.is_round()) make_round(deck, wall);
  if (!deck.rectangle) return wall;
  wall.along = to_point(deck.rectangle->along);
  wall.across = cross(wall.normal, wall.along);
  for (std::size_t k = 0; k < 2; ++k) wall.size[k] = deck.rectangle->size[k];
  return wall;
}

}  // namespace

WallPairs build_walls(const ChunkedMesh& chunked, const Deck& deck, const SurfaceShare& share) {
  WallPairs pairs;
  if (deck.walls.empty()) return pairs;
  const std::vector<HeldNode> stopped = find_stopped_nodes(chunked, deck, share);
  std::vector<ContactWall> walls;
  std::vector<int> pair_wall, pair_node, pair_part, pair_inner;
  std::vector<std::int64_t> pair_number;
  std::vector<double> pair_size, pair_spring, pair_offset;
  const bool includes_thickness =
      std::any_of(deck.walls.begin(), deck.walls.end(), [](const WallDeck& wall) { return wall.includes_thickness; });
  for (const WallDeck& wall : deck.walls) {
    const std::vector<int> nodes = list_wall_nodes(chunked.mesh, deck, wall, stopped);
    const bool acts = share.active.has_wall(walls.size());
    for (const int node : acts ? nodes : std::vector<int>{}) {
      pair_wall.push_back(static_cast<int>(walls.size()));
      pair_node.push_back(node);
      pair_size.push_back(stopped[at(node)].size);
      pair_inner.push_back(stopped[at(node)].is_inner ? 1 : 0);
      pair_spring.push_back(stopped[at(node)].spring);
      pair_part.push_back(stopped[at(node)].part);
      pair_number.push_back(stopped[at(node)].number);
      if (includes_thickness) pair_offset.push_back(wall.includes_thickness ? stopped[at(node)].offset : 0);
    }
    walls.push_back(make_wall(wall));
  }
  pairs.walls = to_view("contact::walls", walls);
  pairs.wall = to_view("contact::wall_of_pair", pair_wall);
  pairs.node = to_view("contact::node_of_pair", pair_node);
  pairs.size = to_view("contact::size_of_pair", pair_size);
  if (includes_thickness) pairs.offset = to_view("contact::offset_of_pair", pair_offset);
  pairs.is_inner = to_view("contact::inner_node_of_pair", pair_inner);
  pairs.spring = to_view("contact::spring_of_pair", pair_spring);
  pairs.part = to_view("contact::part_of_pair", pair_part);
  pairs.number = to_view("contact::number_of_pair", pair_number);
  return pairs;
}

}  // namespace percuss
