#include "src/step/springs/connected_nodes.hpp"

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
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

std::vector<int> mark_rigid_nodes(const Model& model, const ConnectedNodes& connected) {
  std::vector<int> is_rigid(connected.nodes.size(), 0);
  if (!model.rigid.any()) return is_rigid;
  const auto nodes = to_host(connected.owned_node), places = to_host(connected.owned_place),
             bodies = to_host(model.rigid.body_of_node);
  for (std::size_t i = 0; i < nodes.extent(0); ++i) is_rigid[at(places(i))] = bodies(at(nodes(i))) >= 0 ? 1 : 0;
  all_reduce(model.ranks, Reduce::largest, is_rigid);
  return is_rigid;
}

}  // namespace percuss
