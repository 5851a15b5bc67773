#include <algorithm>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// Owned contact nodes that a wall may touch, as their places in the share, ascending.
std::vector<int> list_wall_nodes(const Mesh& mesh, const Deck& deck, const WallDeck& wall,
                                 const OwnedContactNodes& contact_nodes) {
  std::vector<int> nodes;
  if (wall.nodes.empty()) {
    for (int n = 0; n < contact_nodes.count(); ++n) nodes.push_back(n);
    return nodes;
  }
  const std::vector<int>& mesh_nodes = contact_nodes.mesh_nodes;
  for (const Selector& selector : wall.nodes)
    for (const int mesh_node : select_nodes(mesh, deck, selector)) {
      const auto place = std::lower_bound(mesh_nodes.begin(), mesh_nodes.end(), mesh_node);
      if (place != mesh_nodes.end() && *place == mesh_node)
        nodes.push_back(static_cast<int>(place - mesh_nodes.begin()));
    }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  int some = nodes.empty() ? 0 : 1;
  if (mesh.ranks) all_reduce(*mesh.ranks, Reduce::largest, some);
  if (some == 0 && !mesh.eroded.any)
    throw InputError(
        deck.where(wall.place) +
        ": error: wall touches no node (the nodes named are all inside their bodies) name a part or a side");
  return nodes;
}

/// Half the thickness of the thickest shell around a contact node; 0: none is one.
double find_node_offset(const SurfaceShare& share, int node) {
  const auto n = static_cast<std::size_t>(node);
  double offset = 0;
  for (int f = share.nodes.first_face[n]; f < share.nodes.first_face[n + 1]; ++f)
    offset = std::max(offset, share.face(share.nodes.faces[static_cast<std::size_t>(f)]).offset);
  return offset;
}

}  // namespace

WallPairs build_walls(const Mesh& mesh, const Deck& deck, const SurfaceShare& share) {
  std::vector<ContactWall> walls;
  std::vector<int> pair_wall, pair_node;
  std::vector<double> pair_size, pair_offset;
  const bool sees_thickness =
      std::any_of(deck.walls.begin(), deck.walls.end(), [](const WallDeck& wall) { return wall.sees_thickness; });
  for (const WallDeck& wall : deck.walls) {
    for (const int node : list_wall_nodes(mesh, deck, wall, share.nodes)) {
      pair_wall.push_back(static_cast<int>(walls.size()));
      pair_node.push_back(share.nodes.mesh_nodes[static_cast<std::size_t>(node)]);
      pair_size.push_back(share.nodes.sizes[static_cast<std::size_t>(node)]);
      if (sees_thickness) pair_offset.push_back(wall.sees_thickness ? find_node_offset(share, node) : 0);
    }
    walls.push_back({{wall.point[0], wall.point[1], wall.point[2]},
                     {wall.normal[0], wall.normal[1], wall.normal[2]},
                     wall.friction});
  }
  WallPairs pairs;
  pairs.walls = to_view("contact::walls", walls);
  pairs.wall = to_view("contact::wall_of_pair", pair_wall);
  pairs.node = to_view("contact::node_of_pair", pair_node);
  pairs.size = to_view("contact::size_of_pair", pair_size);
  if (sees_thickness) pairs.offset = to_view("contact::offset_of_pair", pair_offset);
  return pairs;
}

}  // namespace percuss
