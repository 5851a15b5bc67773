#pragma once
// Records of edge pairs on the host, where they are written, read and renumbered.

#include <cstdint>
#include <vector>

#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

/// The records that count, by (a, b).
struct HeldRecords {
  std::vector<std::int64_t> a, b;  // numbers of edges
  std::vector<double> values;      // normal, impulse, slip, reference, held, to_push of each
  static constexpr int value_count = 12;
};

HeldRecords take_held(const EdgeHistory& history);
EdgeHistory make_edge_history(const HeldRecords& held);

}  // namespace percuss
