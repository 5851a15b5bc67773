#pragma once
// One step of the run: Figure 1 of the paper in order (Stepper::advance()); lines that one pass computes share a
// function.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "comm/halo/halo_swap.hpp"
#include "comm/merge_reduction.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/step/audit/books.hpp"
#include "src/step/elements/element_stage.hpp"
#include "src/step/make_actions.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/phases.hpp"
#include "src/step/stable_step/global_step.hpp"

namespace percuss {

/// Findings of a rank after its elements, and of all ranks after the one reduction of a step.
struct StepNotice {
  static constexpr std::int64_t none = INT64_MAX;
  double step = std::numeric_limits<double>::infinity();
  std::int64_t element = none;         // number in the whole mesh
  std::int64_t element_id = 0;         // the user's id of that
  std::int64_t failed_element = none;  // number in the whole mesh
  std::int64_t broken_chunk = none;    // number of the lowest chunk whose work is not finite
  std::int64_t stop = 0;               // 1: the run is to end after this step
  std::int64_t checkpoint = 0;         // 1: a checkpoint is to be written after this step
  std::int64_t frame = 0;              // 1: a frame is to be written after this step
  double contact_rate = 0;             // ContactReport::rate
  double growth = 0;                   // largest of StepWatch::growth
  std::int64_t died = 0;               // 1: an element has died
  std::int64_t wants_mass = 0;         // 1: an element needs mass scaling

  void merge(const StepNotice& other);
};

/// Requests of a rank after the step; if one rank requests it, all do it.
struct StepWishes {
  bool stop = false;
  bool checkpoint = false;
  bool frame = false;
};

/// Advances a state step by step. Holds only what a step needs besides model and state: messages, sums, curve values,
/// timers. Everything is collective.
class Stepper {
 public:
  /// contact: the scene's contact stage; may be inactive.
  Stepper(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact);

  /// Evaluates the elements and loads at time 0 and chooses the first step.
  void start(State& state, StepWishes wishes = {});

  /// Archives the state of the stepper from step to step, its contact stage included. Collective.
  void archive(CheckpointArchive& archive);

  /// Adds, before start(), an action before all others, which outlives this.
  void act_first(Action& action) { order_.insert(order_.begin(), &action); }

  /// Instead of start(), for a state from a checkpoint: the forces that it does not hold, and the next step, which the
  /// deck may have changed. archive() has been called.
  void resume(State& state);

  /// Archives the state of the actions, and what the state has of them. Before nodes vanish from a state of a
  /// checkpoint. Collective.
  void archive_actions(CheckpointArchive& archive, State& state);

  /// Drops what acts on nodes and faces that have vanished, and computes the forces at n without it. Collective.
  void drop_vanished(State& state);

  /// Sets the switches after State::happened has come from a checkpoint. Collective.
  void set_switches(State& state);

  /// Switches loads and conditions from n on, by the events of sensors. Collective.
  void switch_now(State& state, const std::vector<char>& happened);

  Bookkeeper& bookkeeper() { return bookkeeper_; }
  ForceBooks& forces() { return *actions_.forces; }
  Sensors& sensors() { return *actions_.sensors; }
  const Sensors& sensors() const { return *actions_.sensors; }

  /// Advances from n to n+1. Afterwards state.bound tells whether an element failed; then the state must not be
  /// advanced.
  void advance(State& state, StepWishes wishes = {});

  /// Requests of any rank by the last step, the same on all ranks.
  bool is_stop_agreed() const { return agreed_.stop; }
  bool is_checkpoint_agreed() const { return agreed_.checkpoint; }
  bool is_frame_agreed() const { return agreed_.frame; }

  // Lists of all actions (src/step/model/action.hpp).
  std::vector<HistoryColumn> list_columns() const;
  void append_values(const State& state, std::vector<double>& row);
  std::vector<std::string> list_notes() const;
  std::vector<Warning> list_start_warnings() const;
  std::vector<Warning> take_warnings();
  const ContactReport& contact_report() const { return report_; }
  /// Takes, before the first step, the energy in the springs of contact that a relaxation has left.
  void note_stored(double energy) { report_.stored = energy; }
  /// Bodies that request a shorter next step than elements and springs do; null: none.
  const Approach* find_limiting_approach(const State& state) const;

  /// The bound of the elements at their last step without damping in proportion to stiffness; 0 where that does not
  /// make it shorter. Collective.
  double find_undamped_bound(const State& state) const;
  /// Force of walls on the scene in the last step, its contact impulses summed over dt; zero without walls. Collective.
  Vec3 find_wall_force() const { return bookkeeper_.find_wall_force(); }
  /// Messages of this rank with forces of shared nodes.
  Traffic traffic() const;
  /// Whether the step comes from the largest eigenvalue of the mesh; how often that was estimated and what it brought.
  bool estimates_steps() const { return global_ != nullptr; }
  StepEstimateReport step_estimates() const { return global_ ? global_->report() : StepEstimateReport{}; }
  /// Clocks of the phases but those of contact, which has its own.
  PhaseClocks& clocks() { return clocks_; }
  /// Times of all phases so far, also of what contact looks at between steps.
  PhaseClocks read_clocks() const;

 private:
  bool are_nodes_free() const;
  void predict_motion(State& state, const StepTimes& times);
  void accept_motion(State& state, double dt);
  void book_motion(State& state, const StepTimes& times);
  void book_forces(State& state, double dt);
  void integrate_free_motion(State& state, const StepTimes& times);
  void integrate_spins(State& state, const StepTimes& times);
  void turn_inertia(State& state, double dt);
  void resolve_contact(State& state, double dt);
  void follow_contact(State& state, const StepTimes& times);
  void add_forces(State& state, double time);
  void share_forces(State& state);
  void compute_forces(State& state, double dt);
  void judge_elements(State& state, double dt);
  ElementMotion find_motion(const State& state, double dt) const;
  const Action* find_asker() const;
  StepNotice find_notice(const State& state) const;
  void agree_on_step(State& state, StepWishes wishes);
  void scale_masses(State& state);
  double find_mesh_step(const State& state, const StepNotice& notice);
  void choose_step(State& state) const;

  const Deck& deck_;
  const ChunkedMesh& chunked_;
  const Model& model_;
  ContactStage& contact_;
  ExecSpace space_;
  HaloSwap halo_;
  std::optional<HaloSwap> moment_halo_;  // only with shells
  MergeReduction<StepNotice> reduction_;
  StepWishes agreed_;
  std::unique_ptr<GlobalStep> global_;  // only if the deck requests it
  Actions actions_;
  std::vector<Action*> order_;  // theirs, and what acts first
  ElementStage elements_;
  Bookkeeper bookkeeper_;
  ContactReport report_;
  // Largest magnitudes of components of the velocities of this rank's nodes, for contact: as predicted, and as nodes
  // moved in the last step; negative: not measured.
  double predicted_component_ = -1, moved_component_ = -1;
  bool some_died_ = false;       // of this rank's elements, in the last step
  bool is_mass_wanted_ = false;  // by any rank's elements, after the last step
  PhaseClocks clocks_;
};

}  // namespace percuss
