#pragma once
// What columns of parts and of blocks have in common: the sums, and how those of a chunk become those of its owner.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "src/output/history_columns.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// A part that the deck names in output.history.parts, or an entry of output.history.blocks.
struct BookedPart {
  std::string name;
  int index = 0;                 // into Mesh::parts; into OutputDeck::blocks
  bool can_fail = false;         // if so, it has columns of eroded mass and energy
  bool resists_folding = false;  // if so, it has a column of the work against folding
};

/// Sums of each part or block; some have columns only where it can fail, or resists folding.
struct PartSum {
  enum : int {
    kinetic,
    internal,
    momentum = internal + work_kinds,
    mass = momentum + 3,
    eroded_mass,
    eroded_energy,
    count
  };
};

/// Sums over the nodes of a chunk.
struct ChunkSum {
  enum : int { kinetic, momentum, mass = momentum + 3, rotation, count };
};
using ChunkSums = Kokkos::View<double**, Kokkos::LayoutRight, MemSpace>;

/// The columns, one owner after the other. kind: "part", "block".
std::vector<HistoryColumn> list_sum_columns(const std::vector<BookedPart>& owners, const char* kind);

/// Appends the values of these columns. sums: PartSum::count for each owner, of all ranks.
void append_sums(const std::vector<BookedPart>& owners, const std::vector<ExactSum>& sums, std::vector<double>& row);

/// [bodies] 1: it has rigid parts, which count by the shapes of their elements and not by nodes; empty: none has.
std::vector<int> mark_bodies_of_parts(const Deck& deck);

/// The work of chunks since the start, without what went into dead elements.
class ChunkWork {
 public:
  ChunkWork(const ChunkedMesh& chunked, const Model& model, const State& state);

  /// Adds that of a chunk to the sums of its owner, PartSum::count of them.
  void add(int chunk, ExactSum* owner) const;

 private:
  /// Takes the work that went into dead elements out, as the books of the scene do.
  class DeadElements {
   public:
    DeadElements(const ChunkedMesh& chunked, const Model& model, const State& state);
    void take_out(int chunk, ExactSum* sums) const;

   private:
    const std::vector<std::uint8_t>& dead_;
    decltype(to_host(Array<int>())) first_element_, first_pack_;
    decltype(to_host(Array<double>())) work_, mass_;
  };

  decltype(to_host(WorkRows())) work_;
  std::optional<DeadElements> dead_;
};

/// Adds what chunk i of a list has of its nodes to the sums of its owner.
template <class HostSums>
void add_chunk_nodes(const HostSums& of_nodes, std::size_t i, ExactSum* owner) {
  owner[PartSum::kinetic].add(of_nodes(i, ChunkSum::kinetic));
  owner[PartSum::kinetic].add(of_nodes(i, ChunkSum::rotation));
  for (int k = 0; k < 3; ++k) owner[PartSum::momentum + k].add(of_nodes(i, ChunkSum::momentum + k));
  owner[PartSum::mass].add(of_nodes(i, ChunkSum::mass));
}

}  // namespace percuss
