#pragma once
// Mass scaling during the run: elements whose step bound has fallen below the wanted step are given mass until it is
// that again, as long as their part may have more.
//
// Bounds are those of the forces at n, with the masses until then. The next step still obeys them: mass only raises
// them. Added mass has the velocity of its node, so that nothing is slowed down; the books take it as an external
// impulse (Bookkeeper::book_added()).

#include <string>
#include <vector>

#include "src/step/audit/books.hpp"
#include "src/step/lumped_masses.hpp"
#include "src/step/model/element_bounds.hpp"
#include "src/step/model/state.hpp"
#include "src/step/shared_mass.hpp"
#include "src/warning.hpp"

namespace percuss {

class MassScaler {
 public:
  /// All arguments outlive this.
  MassScaler(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

  /// Where the launchers write the bounds of all elements.
  const ElementBounds& bounds() const { return bounds_; }

  /// Whether an element of this rank is to get mass after the forces of a step. bounds: [chunks] least of each.
  bool is_wanted(long step, const HostMirror<Array<double>>& bounds) const;

  /// Adds the mass that is due, and books it. Collective.
  void add(State& state, Bookkeeper& books);

  /// Masses of the nodes from those of the elements, which a checkpoint holds. Collective.
  void restore(State& state);

  /// Parts that have reached their limit since the last call.
  std::vector<Warning> take_warnings();

  /// What each part was given.
  void archive(CheckpointArchive& archive);

 private:
  struct ScaledPart {
    std::string name;
    MassScalingDeck request;
    double most = 0;   // mass that it may get during the run
    double added = 0;  // of all ranks
    bool is_full() const { return added >= most * (1 - 1e-12); }
  };

  bool is_due(const ScaledPart& part, long step) const { return step % *part.request.every == 0 && !part.is_full(); }
  void find_missing(const State& state);
  std::vector<double> find_shares();
  void give(const State& state, const std::vector<double>& shares);
  void sum_lumped(const State& state);
  void scale_tensors(const State& state) const;
  void set_nodes(State& state) const;

  const Model& model_;
  std::vector<ScaledPart> parts_;
  std::vector<int> part_of_chunk_;  // [chunks] of parts_; -1: none
  Array<double> target_;            // [chunks] wanted step; 0: not now
  Array<double> missing_;           // [elements] mass that each is to get
  Array<double> wanted_;            // [chunks] its sum
  Array<double> share_;             // [chunks] of it that is given
  ElementBounds bounds_;
  LumpedMasses summer_;
  SharedMass shared_;
  Rows3<double> lumped_;  // [nodes] mass and rotary inertia
  std::vector<Warning> warnings_;
};

}  // namespace percuss
