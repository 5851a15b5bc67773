#pragma once
// The ranks and what each knows of the others' nodes.

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// How the contact stage sees the ranks.
struct ContactRanks {
  const Communicator& ranks;
  const Numbering& numbering;
  const Mesh& mesh;
};

}  // namespace percuss
