#pragma once
// What element blocks and element sets have of the scene's energies, momentum and mass: columns of the history, where
// the deck names them in output.history.blocks.
//
// Their elements share no chunk with others (src/mesh/parts), so that the work of elements is that of whole chunks. A
// node has no block: its mass, momentum and kinetic energy are divided among its elements in proportion to their shares
// of its lumped mass, those of its rotation in proportion to their shares of its rotary inertia. Each chunk adds up
// the shares of its slots; chunks are added exactly. So the sums have the same bits on any number of ranks and threads.
// Elements of rigid parts count by their shapes.

#include <optional>
#include <utility>
#include <vector>

#include "src/step/audit/part_sums.hpp"
#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {

/// The columns, block after block.
std::vector<HistoryColumn> list_block_columns(const Deck& deck);

class BlockEnergies {
 public:
  /// chunked outlives this. Collective. Throws InputError, on all ranks, for a name that is no block and no element
  /// set.
  BlockEnergies(const Deck& deck, const ChunkedMesh& chunked);

  /// Appends the values of the columns to a row, the same on every rank. One message a rank. Collective; does nothing
  /// where the deck names no block.
  void append(const Model& model, const State& state, std::vector<double>& row);

  // Kernels of its own: nvcc takes none in a private function.
  void find_shares(const Model& model, const State& state);
  void sum_nodes(const Model& model, const State& state);

 private:
  using Shares = Kokkos::View<double* [2], Kokkos::LayoutRight, MemSpace>;

  void lay_out(const Model& model);
  void add_rigid_chunks(const Model& model, const State& state, std::vector<ExactSum>& sums);

  const ChunkedMesh& chunked_;
  std::vector<BookedPart> blocks_;
  std::vector<int> chunks_;                     // of this rank that belong to some block, ascending
  std::vector<std::pair<int, int>> ownership_;  // place among those, and block
  Array<int> listed_;                           // the same chunks, for the kernel
  Array<int> first_share_;                      // [those] row of its first slot in shares_
  Shares shares_;                               // of the chunk in the lumped mass and rotary inertia of a slot's node
  ChunkSums node_sums_;                         // [those]
  std::optional<BodyForceFinder> find_forces_;
  bool has_shares_ = false;
};

}  // namespace percuss
