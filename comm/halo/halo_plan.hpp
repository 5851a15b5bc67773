#pragma once
// The halo: which slots of shared nodes go where, and the order in which a node sums them.
//
// A slot is one contribution to one node: a chunk's corner forces, a pressure face's share. The paper (section 3) sums
// the local contributions of a shared node and then swaps and adds those sums, which makes the bits depend on the
// decomposition. Here a rank sends each of its slots of a shared node. Received slots are stored after the local ones
// in the same array, and a node's list names all of them in one global order (ascending chunk id), local and remote
// mixed: every copy of the node adds the same numbers in the same order, for any number of ranks.

#include <cstdint>
#include <vector>

#include "comm/exchange/exchange_plan.hpp"
#include "comm/halo/shared_nodes.hpp"

namespace percuss {

/// The slots that a rank fills itself.
struct LocalSlots {
  std::vector<int> nodes;            // [slots] local node of each
  std::vector<std::int64_t> orders;  // [slots] place in its node's sum: the global chunk id; differs from slot to slot
                                     //         of a node, over all ranks
};

/// Slots to send, and places of received ones; const after set-up.
struct HaloPlan {
  ExchangePlan exchange;        // items are slots
  std::vector<int> send_slots;  // [sent] local slot of each item sent; a slot goes to every rank that shares its node
  int first_remote_slot = 0;    // number of local slots: received item i is slot first_remote_slot + i
  int slot_count() const { return first_remote_slot + static_cast<int>(exchange.receive_count()); }
};

/// The slots of each node in the order of its sum: what NodeSlots of kernels/node/motion.hpp holds.
struct SlotLists {
  std::vector<int> first;  // [nodes + 1]
  std::vector<int> slots;  // ascending order
};

struct Halo {
  HaloPlan plan;
  SlotLists nodes_to_slots;  // local and remote slots
};

/// Makes the halo of this rank's slots. Collective. Throws MpiError.
Halo build_halo(UnstructuredExchange& exchange, const SharedNodes& shared, const LocalSlots& slots);

/// [chunks] 1: a slot of the chunk is sent, so the chunk is computed before the halo is begun; 0: it can wait.
/// first_slot: [chunks + 1] into the local slots.
std::vector<char> mark_sending_chunks(const HaloPlan& plan, const std::vector<int>& first_slot);

}  // namespace percuss
