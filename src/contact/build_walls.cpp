#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "src/contact/build_surface.hpp"
#include "src/contact/host_copy.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

template <class View>
auto copy_to_host(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

/// Contact nodes that a wall may touch, ascending.
std::vector<int> list_wall_nodes(const Mesh& mesh, const Deck& deck, const WallDeck& wall,
                                 const std::vector<int>& contact_nodes) {
  std::vector<int> nodes;
  if (wall.nodes.empty()) {
    for (std::size_t n = 0; n < contact_nodes.size(); ++n) nodes.push_back(static_cast<int>(n));
    return nodes;
  }
  for (const Selector& selector : wall.nodes)
    for (const int mesh_node : select_nodes(mesh, deck, selector)) {
      const auto place = std::lower_bound(contact_nodes.begin(), contact_nodes.end(), mesh_node);
      if (place != contact_nodes.end() && *place == mesh_node)
        nodes.push_back(static_cast<int>(place - contact_nodes.begin()));
    }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty())
    throw InputError(
        deck.where(wall.place) +
        ": error: wall touches no node (the nodes named are all inside their bodies) name a part or a side");
  return nodes;
}

/// Shortest edge of the faces around each contact node at time 0.
std::vector<double> find_node_sizes(const Mesh& mesh, const ContactSurface& surface,
                                    const std::vector<int>& contact_nodes) {
  std::vector<double> sizes(contact_nodes.size(), std::numeric_limits<double>::infinity());
  const auto corners = copy_to_host(surface.face_corners);
  for (int f = 0; f < surface.num_faces; ++f)
    for (int i = 0; i < 4; ++i) {
      const auto a = static_cast<std::size_t>(corners(f, i)), b = static_cast<std::size_t>(corners(f, (i + 1) % 4));
      const Vec3& p = mesh.nodes[static_cast<std::size_t>(contact_nodes[a])];
      const Vec3& q = mesh.nodes[static_cast<std::size_t>(contact_nodes[b])];
      const double edge = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      sizes[a] = std::min(sizes[a], edge);
      sizes[b] = std::min(sizes[b], edge);
    }
  return sizes;
}

}  // namespace

WallPairs build_walls(const Mesh& mesh, const Deck& deck, const ContactSurface& surface) {
  const auto nodes = copy_to_host(surface.nodes);
  const std::vector<int> contact_nodes(nodes.data(), nodes.data() + nodes.extent(0));
  const std::vector<double> sizes = find_node_sizes(mesh, surface, contact_nodes);
  std::vector<ContactWall> walls;
  std::vector<int> pair_wall, pair_node;
  std::vector<double> pair_size;
  for (const WallDeck& wall : deck.walls) {
    for (const int node : list_wall_nodes(mesh, deck, wall, contact_nodes)) {
      pair_wall.push_back(static_cast<int>(walls.size()));
      pair_node.push_back(node);
      pair_size.push_back(sizes[static_cast<std::size_t>(node)]);
    }
    walls.push_back({{wall.point[0], wall.point[1], wall.point[2]},
                     {wall.normal[0], wall.normal[1], wall.normal[2]},
                     wall.friction});
  }
  WallPairs pairs;
  pairs.walls = copy_to_array("contact::walls", walls);
  pairs.wall = copy_to_array("contact::wall_of_pair", pair_wall);
  pairs.node = copy_to_array("contact::node_of_pair", pair_node);
  pairs.size = copy_to_array("contact::size_of_pair", pair_size);
  return pairs;
}

}  // namespace percuss
