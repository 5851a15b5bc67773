#pragma once
// One step of the run: the paper's Figure 1, each line a function.

#include <memory>

#include "src/contact/contact_stage.hpp"
#include "src/output/summary.hpp"
#include "src/step/books.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"

namespace percuss {

/// Advances a state step by step. Holds only what a step needs besides model and state: sums, curve values, timers.
class Stepper {
 public:
  /// contact: the scene's contact stage; may be inactive.
  Stepper(const Deck& deck, const Model& model, ContactStage& contact);

  /// Evaluates the elements and loads at time 0 and chooses the first step.
  void start(State& state);

  /// From n to n+1. Afterwards state.bound tells whether an element failed; then the state must not be advanced.
  void advance(State& state);

  const ContactReport& contact_report() const { return report_; }
  /// Force of walls on the scene in the last step, its contact impulses summed over dt; zero without walls.
  const Vec3& wall_force() const { return bookkeeper_.wall_force(); }
  PhaseSeconds& seconds() { return seconds_; }

 private:
  void integrate_motion(State& state, double dt_mean);
  void hold_conditions(State& state, double dt);
  void resolve_contact(State& state, double dt);
  void compute_elements(State& state, double dt);
  void apply_loads(State& state, double time);
  void choose_step(State& state) const;

  const Deck& deck_;
  const Model& model_;
  ContactStage& contact_;
  ExecSpace space_;
  Bookkeeper bookkeeper_;
  PrescribedMotions motions_;
  Array<double> pressures_;
  ContactReport report_;
  PhaseSeconds seconds_;
};

}  // namespace percuss
