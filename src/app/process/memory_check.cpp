#include "src/app/process/memory_check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "comm/all_reduce.hpp"
#include "src/deck/mesh_size.hpp"
#include "src/error.hpp"

namespace percuss {

double find_machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

double sum_machine_memory(const Communicator& ranks) {
  const OwnedCommunicator machine = OwnedCommunicator::of_machine(ranks);
  double bytes = machine->rank() == 0 ? find_machine_memory() : 0;
  all_reduce(ranks, Reduce::sum, bytes);
  return bytes;
}

void check_memory(const Deck& deck, double machine_bytes) {
  // Only the arrays of the mesh: eight corners, an id and a part of each element; a position and an id of each node. A
  // run needs several times that, so a scene refused here could never have run.
  constexpr double element_bytes = 8 * 4 + 8 + 4, node_bytes = 3 * 8 + 8;
  double bytes = 0, elements = 0;
  for (const PartDeck& part : deck.parts) {
    const MeshSize size = count_cells(part);
    elements += size.elements;
    bytes += size.elements * element_bytes + size.nodes * node_bytes;
  }
  if (machine_bytes <= 0 || bytes <= machine_bytes) return;
  throw SystemError(fmt::format(
      "the mesh does not fit (its {:.4g} elements need more than {:.3g} GB, there are {:.3g} GB): make it coarser",
      elements, bytes / 1e9, machine_bytes / 1e9));
}

}  // namespace percuss
