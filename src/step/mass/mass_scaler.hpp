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
#include "src/step/mass/lumped_masses.hpp"
#include "src/step/mass/shared_mass.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

class MassScaler : public Action {
 public:
  /// All arguments outlive this.
  MassScaler(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

  bool comes_between() const override { return false; }
  const ElementBounds* asked_bounds() const override { return &bounds_; }

  /// Whether an element of this rank is to get mass.
  bool wants_masses(const State& state, const HostMirror<Array<double>>& bounds) const override;

  /// Adds the mass that is due, and books it.
  void change_masses(State& state, Bookkeeper& books) override;

  /// Warns of parts that have reached their limit.
  std::vector<Warning> take_warnings() override;

  /// Reads or writes the mass given to each part, and the masses of the elements.
  void archive(CheckpointArchive& archive, State& state) override;

  // Kernels of its own: nvcc takes none in a private function.
  void find_missing(const State& state);
  std::vector<double> find_shares();
  void give(const State& state, const std::vector<double>& shares);
  void sum_lumped(const State& state);
  void scale_tensors(const State& state) const;
  void set_nodes(State& state) const;

 private:
  struct ScaledPart {
    std::string name;
    MassScalingDeck request;
    double most = 0;   // mass that it may get during the run
    double added = 0;  // of all ranks
    bool is_full() const { return added >= most * (1 - 1e-12); }
  };

  bool is_due(const ScaledPart& part, long step) const { return step % *part.request.every == 0 && !part.is_full(); }
  void restore(State& state);

  const ChunkedMesh& chunked_;
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
