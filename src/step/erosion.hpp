#pragma once
// What the death of elements does to everything else: faces that come to light, nodes that no element holds, loads,
// ties, the contact surface and the books.
//
// A step ends with one reduction that tells all ranks whether an element of any has died (StepBound::died). Then,
// before the next step, the scene is redefined. Everything follows from which elements are dead: it is the same on any
// number of ranks, and after a restart.

#include <cstdint>
#include <optional>
#include <vector>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/counting_sort.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/step/audit/books.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class Erosion {
 public:
  /// The mesh's `eroded` and `exterior` are kept up to date. All arguments outlive this. Collective, as are all calls;
  /// a scene in which nothing can fail costs nothing.
  Erosion(const Deck& deck, ChunkedMesh& chunked, const Model& model, ContactStage& contact);

  /// Redefines the scene after elements have died, and books what leaves. Loads must be renewed then.
  void redefine(State& state, Bookkeeper& books);

  /// Restores the surface for a state from a checkpoint, in which elements may be dead; nothing is booked.
  void restore(State& state);

  /// Elements of this rank that are dead.
  const std::vector<std::uint8_t>& dead() const { return chunked_.mesh.eroded.dead; }

  // Kernels of its own: nvcc takes none in a private function.
  void count_holders(const State& state);

 private:
  std::vector<int> list_newly_dead(const State& state);
  void open_faces(const std::vector<int>& newly_dead);
  void sort_nodes(State& state, Bookkeeper* books);
  void unload_nodes(const std::vector<int>& vanished, State& state, bool is_booked) const;
  void unload_faces(State& state, bool is_booked) const;
  void book_elements(State& state, const std::vector<int>& newly_dead) const;
  void find_neighbours();
  ElementFace find_across(const std::array<std::int64_t, 4>& face, int but) const;

  const Deck& deck_;
  ChunkedMesh& chunked_;
  const Model& model_;
  ContactStage& contact_;
  std::optional<HaloSwap> halo_;          // where anything can erode
  Buckets around_;                        // elements at each node; made when the first one dies
  std::vector<int> loaded_elements_;      // [pressure faces] the element of each
  Rows3<double> slot_holders_, holders_;  // living elements at each slot and node, in the first column
};

}  // namespace percuss
