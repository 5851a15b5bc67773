#pragma once
// The loads of the deck in a step: gravity, forces and moments on nodes, pressures on faces.

#include <vector>

#include "kernels/node/pulse.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

class LoadStage : public Action {
 public:
  /// The model outlives this. Its pulses stay; other curves may change.
  LoadStage(const Deck& deck, const Model& model);

  bool adds_forces() const override { return adds_forces_; }
  /// The gravity of the state too. Not collective.
  void add_forces(State& state, double time) override;
  bool comes_between() const override { return model_.pressure_faces.count > 0 || model_.nodal_loads.count > 0; }
  double bound_component(const State& /*state*/, double predicted) const override { return predicted; }

 private:
  /// The pressures of a blast on its faces, which kernels evaluate.
  struct Blast {
    std::size_t entry;  // of the deck
    int first_load;
    Array<Pulse> pulses;  // of a load each
  };

  void list_pulses();
  void load_nodes(const State& state, double time);
  void press_faces(const State& state, double time);
  void evaluate_curves(const State& state, double time);
  void evaluate_pulses(const State& state, double time);

  const Model& model_;
  bool adds_forces_;
  Array<double> pressures_;
  std::vector<std::size_t> curves_;  // loads whose pressures are no pulses
  std::vector<Blast> blasts_;
  NodalLoadValues nodal_values_;
};

}  // namespace percuss
