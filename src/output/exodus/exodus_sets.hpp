#pragma once
// Node sets and side sets of Exodus II, of the mesh at time 0.

#include <cstdint>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/output/exodus/exodus_blocks.hpp"
#include "src/output/frame/frame_fields.hpp"

namespace percuss {

/// A set as a file has it, the same on every rank.
struct ExodusSet {
  std::string name;
  std::vector<std::int64_t> members;  // nodes or elements of the file, from 1, ascending
  std::vector<std::int64_t> sides;    // of side sets: the side of each element, from 1
};

struct ExodusSets {
  std::vector<ExodusSet> of_nodes, of_sides;
};

/// Sets of the options that have members. Collective. Throws MpiError.
ExodusSets list_exodus_sets(const Mesh& mesh, const std::vector<ExodusBlock>& blocks, const FieldsOptions& options,
                            const Communicator& ranks);

}  // namespace percuss
