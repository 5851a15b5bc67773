#include "src/step/springs/connected_nodes.hpp"

#include <algorithm>
#include <utility>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {

void find_connected_nodes(const ChunkedMesh& chunked, ConnectedNodes& connected) {
  std::vector<int> owned, owned_places, local, local_places;
  for (std::size_t i = 0; i < connected.nodes.size(); ++i) {
    const int node = find_local_node(chunked, connected.nodes[i]);
    if (node < 0) continue;
    local.push_back(node);
    local_places.push_back(static_cast<int>(i));
    if (!owns_node(chunked, node)) continue;
    owned.push_back(node);
    owned_places.push_back(static_cast<int>(i));
  }
  connected.owned_node = to_view("percuss::connected_nodes", owned);
  connected.owned_place = to_view("percuss::connected_places", owned_places);
  connected.local_node = to_view("percuss::local_connected_nodes", local);
  connected.local_place = to_view("percuss::local_connected_places", local_places);
}

void add_force_slots(const ChunkedMesh& chunked, const Communicator& ranks, ForcedNodes& forced, LocalSlots& slots) {
  find_connected_nodes(chunked, forced);
  std::int64_t order = 0;
  for (const std::int64_t other : slots.orders) order = std::max(order, other + 1);
  all_reduce(ranks, Reduce::largest, order);
  forced.first_slot = static_cast<int>(slots.nodes.size());
  const auto owned = to_host(forced.owned_node);
  for (std::size_t i = 0; i < owned.extent(0); ++i) {
    slots.nodes.push_back(owned(i));
    slots.orders.push_back(order);
  }
}

void fill_force_slots(const ForcedNodes& forced, const std::vector<Vector3<double>>& by_node, const Rows3<double>& own,
                      const Rows3<double>& all) {
  const auto rows = Kokkos::create_mirror_view(own);
  const auto places = to_host(forced.owned_place);
  for (std::size_t i = 0; i < places.extent(0); ++i)
    for (int k = 0; k < 3; ++k) rows(i, at(k)) = get(by_node[at(places(i))], k);
  const std::size_t first = at(forced.first_slot);
  copy_values(Kokkos::subview(all, std::pair(first, first + rows.extent(0)), Kokkos::ALL), rows);
}

std::vector<int> share_bodies(const Model& model, const ConnectedNodes& connected) {
  std::vector<int> bodies(connected.nodes.size(), -1);
  if (!model.rigid.any()) return bodies;
  const auto nodes = to_host(connected.owned_node), places = to_host(connected.owned_place);
  const auto body_of_node = to_host(model.rigid.body_of_node);
  for (std::size_t i = 0; i < nodes.extent(0); ++i) bodies[at(places(i))] = body_of_node(nodes(i));
  all_reduce(model.ranks, Reduce::largest, bodies);
  return bodies;
}

std::vector<int> mark_rigid_nodes(const Model& model, const ConnectedNodes& connected) {
  std::vector<int> marks = share_bodies(model, connected);
  for (int& mark : marks) mark = mark >= 0 ? 1 : 0;
  return marks;
}

}  // namespace percuss
