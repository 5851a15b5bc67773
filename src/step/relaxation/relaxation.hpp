#pragma once
// Dynamic relaxation: damped steps before time 0, until the scene is at rest under the loads of that time.
//
// Loads are those that curves give at time 0; prescribed motions and moving walls stand still, nothing fails or erodes.
// Every node has the damping force -c m v with c = 2 w, the critical one of frequency w (Papadrakakis, A method for the
// automatic evaluation of the dynamic relaxation parameters, Comput. Methods Appl. Mech. Eng. 25, 1981). w comes from
// the Rayleigh quotient of the motion itself, which tends to the lowest frequency as the others die out
// (motion_sums.hpp). Masses are those of fictitious_masses.hpp: times and frequencies have no physical meaning.
//
// Penalty contact is a spring whose impulse comes after the damping of a step. Damping then acts on the old velocities
// alone, so that at rest the springs carry all of the load (kernels/node/damping.hpp).

#include <memory>

#include "src/output/summary.hpp"
#include "src/step/mass/fictitious_masses.hpp"
#include "src/step/relaxation/motion_sums.hpp"
#include "src/step/relaxation/preload_stage.hpp"
#include "src/step/step.hpp"
#include "src/warning.hpp"

namespace percuss {

class Relaxation {
 public:
  /// Takes over the state at time 0, at rest, with its contact prepared. All of it outlives this. Collective, as are
  /// all calls that are not const. Throws InputError, the same on all ranks, for preloads and held nodes that the mesh
  /// does not have.
  Relaxation(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact, State& state);
  Relaxation(const Relaxation&) = delete;
  Relaxation& operator=(const Relaxation&) = delete;

  /// Whether the scene is at rest, a preload comes no nearer, or max_steps are made.
  bool is_over() const { return is_settled() || is_stuck_ || state_.step >= rules_.max_steps; }
  bool is_settled() const { return report_.state == "settled"; }

  /// A damped step. Afterwards state.bound tells whether an element failed, as of Stepper::advance().
  void advance();

  /// The state at time 0: strains, stresses and places stay; velocities are the initial ones, books and clocks empty.
  void finish();

  const RelaxationSummary& report() const { return report_; }

  /// Whether a preload came no nearer for many steps, in which its layer did not get shorter either.
  bool is_stuck() const { return is_stuck_; }
  /// Why the scene is not at rest, and what to do.
  Warning warn_unsettled() const;

  /// "kinetic energy 2.1e-07 of the scale, section 'bolt' 19999.8".
  std::string describe() const;

  /// Energy that springs of penalty contact hold; the same on all ranks.
  double find_contact_stored() const { return stepper_->contact_report().stored; }

  /// Deck and model of the steps.
  const Deck& deck() const { return relaxed_deck_; }
  const Model& model() const { return relaxed_; }
  const Stepper& stepper() const { return *stepper_; }

 private:
  void hold_nodes(const Deck& deck);
  void give_masses();
  void make_model(const Deck& deck);
  void set_loads(long step);
  double find_share(long step) const;
  void look(double dt, double dt_mean);
  void judge(const MotionTotals& totals);
  void refuse_falling_joints() const;
  double find_spin_frequency() const;
  bool has_idle_spins() const;
  void watch_preloads();
  bool has_moving_layers();
  Warning warn_unreached(std::size_t preload) const;

  const RelaxationDeck& rules_;
  Deck relaxed_deck_;
  const ChunkedMesh& chunked_;
  const Model& model_;
  Model relaxed_;
  ContactStage& contact_;
  State& state_;
  const Rows3<double> inverse_mass_, inverse_inertia_;  // of the run
  FictitiousMasses masses_;
  std::unique_ptr<Stepper> stepper_;
  MotionSums sums_;
  PreloadStage preloads_;
  RelaxationSummary report_;
  double elapsed_ = 0;                               // of all steps [time]
  double largest_kinetic_ = 0, largest_moving_ = 0;  // largest_moving_: of translations alone
  double power_ = 0, inertia_ = 0;                   // sums over the last checks, with decaying weights
  double moving_power_ = 0, moving_inertia_ = 0;     // power and inertia of translations alone
  double frequency_ = 0;                             // [rad / time]
  long quiet_steps_ = 0;
  double least_lack_ = 0;                        // of preloads, until the last check of their progress
  double lack_since_ = 0;                        // the least since then
  std::vector<double> start_lengths_, lengths_;  // of the layers of preloads: at the start, at the last check
  bool is_stuck_ = false;
};

}  // namespace percuss
