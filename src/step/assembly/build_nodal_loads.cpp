#include "kernels/core/host_copy.hpp"
#include "src/step/assembly/build_conditions.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {

void build_nodal_loads(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model) {
  const Numbering& numbering = chunked.numbering;
  const auto pressures = static_cast<std::int64_t>(deck.pressures.size());
  // After the orders of chunks and of pressure faces.
  const std::int64_t first_order = numbering.chunk_count() + find_face_number(pressures * numbering.element_count(), 0);
  NodalLoads& loads = model.nodal_loads;
  loads.first_slot = static_cast<int>(slots.nodes.size());
  std::vector<int> nodes, load;
  for (const NodalLoadDeck& entry : deck.nodal_loads) {
    const auto row = static_cast<int>(model.nodal_values.size());
    model.nodal_values.push_back(entry.value);
    if (!find_body(entry.where).empty()) continue;  // add_body_loads()
    for (const int n : select_nodes(chunked.mesh, deck, entry.where)) {
      if (!owns_node(chunked, n)) continue;
      nodes.push_back(n);
      load.push_back(row);
      slots.nodes.push_back(n);
      slots.orders.push_back(first_order + row);
    }
  }
  loads.count = static_cast<int>(nodes.size());
  loads.node = to_view("percuss::loaded_nodes", nodes);
  loads.load = to_view("percuss::nodal_load", load);
}

}  // namespace percuss
