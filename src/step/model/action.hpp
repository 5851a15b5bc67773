#pragma once
// What acts in a step besides elements and contact: loads, conditions, dampings, springs, welds, constraints, rigid
// bodies, added mass; and what watches it: moving walls, sensors, forces and accelerometers of the history.
//
// Each is an Action, which overrides the moments of a step at which it does something. The stepper calls them in the
// order of make_actions() (src/step/make_actions.hpp), each moment for all of them before the next.

#include <limits>
#include <string>
#include <vector>

#include "src/output/history_columns.hpp"
#include "src/step/model/element_bounds.hpp"
#include "src/step/model/state.hpp"
#include "src/warning.hpp"

namespace percuss {

class Bookkeeper;
class CheckpointArchive;
struct ContactReport;

/// Times of the step from n to n+1.
struct StepTimes {
  double time = 0;     // n
  double dt = 0;       // from n to n+1
  double dt_mean = 0;  // from n-1/2 to n+1/2
};

/// All calls are collective where a class does not say otherwise.
class Action {
 public:
  Action() = default;
  Action(const Action&) = delete;
  Action& operator=(const Action&) = delete;
  virtual ~Action() = default;

  // The moments of a step, in their order.

  /// Called at time 0, before the first forces.
  virtual void start(State& /*state*/) {}
  /// x and forces at n, v at n-1/2.
  virtual void begin_step(const State& /*state*/, const StepTimes& /*times*/) {}
  /// v is what forces and gravity on nodes give.
  virtual void predict(State& /*state*/, const StepTimes& /*times*/) {}
  /// v is that of n+1/2 without contact. v_before: n-1/2.
  virtual void change_velocities(State& /*state*/, const StepTimes& /*times*/) {}
  /// Bound on the components of v on this rank after that; predicted: before. Negative: not known, which all that come
  /// after leave so, but for those that measure all nodes.
  virtual double bound_component(const State& /*state*/, double predicted) const {
    return comes_between() ? -1 : predicted;
  }
  /// w is that of n+1/2, w_before that of n-1/2. Only of scenes with rotations.
  virtual void change_spins(State& /*state*/, const StepTimes& /*times*/) {}
  /// v is that of n+1/2 with contact. contact: of the step; null: the scene has none.
  virtual void follow_contact(State& /*state*/, const StepTimes& /*times*/, const ContactReport* /*contact*/) {}
  /// All velocities are those of n+1/2, x is at n: impulses, and the first half of the work.
  virtual void book_motion(State& /*state*/, const StepTimes& /*times*/) {}
  /// x of nodes is at n+1.
  virtual void move(State& /*state*/, const StepTimes& /*times*/) {}
  /// Forces at n+1, and their work in the step; dt = 0: those at time 0.
  virtual void advance(State& /*state*/, double /*dt*/) {}
  /// Adds its forces to slots of this rank. time: of the state.
  virtual void add_forces(State& /*state*/, double /*time*/) {}
  /// The second half of the work. time: n+1. takes_gravity: constant gravity on held directions counts too, which
  /// matters where what is held changes.
  virtual void book_forces(State& /*state*/, double /*dt*/, double /*time*/, bool /*takes_gravity*/) {}
  /// Lowers the bound of all elements and contact together to what this leaves of it, the same on all ranks. Not
  /// collective.
  virtual void limit_step(const State& /*state*/, StepBound& /*bound*/) const {}
  /// Largest step that the action allows; a scene without such a bound has none. Not collective.
  virtual double largest_step(const State& /*state*/) const { return std::numeric_limits<double>::infinity(); }
  /// Whether this rank requests change_masses(). bounds: [chunks] least of the elements of each. Not collective.
  virtual bool wants_masses(const State& /*state*/, const HostMirror<Array<double>>& /*bounds*/) const { return false; }
  /// Changes masses after the forces at n, where a rank has requested it.
  virtual void change_masses(State& /*state*/, Bookkeeper& /*books*/) {}

  // Between steps.

  /// Called after events: which conditions hold from n on. Not collective.
  virtual void set_switches(State& /*state*/) {}
  /// Called after elements have died or a checkpoint was read: drops what acts on nodes that have vanished.
  virtual void drop_vanished(State& /*state*/) {}
  /// What it remembers of the state and of itself; of masses, loading sets those of the nodes too.
  virtual void archive(CheckpointArchive& /*archive*/, State& /*state*/) {}
  /// Called after all of a checkpoint has been read.
  virtual void resume(const State& /*state*/) {}

  // What it says. The same on all ranks; not collective but for append_values().

  /// Its columns of history.csv.
  virtual std::vector<HistoryColumn> list_columns() const { return {}; }
  /// Their values at n, at the end of a row.
  virtual void append_values(const State& /*state*/, std::vector<double>& /*row*/) {}
  /// Notes before the first step, and warnings about its input.
  virtual std::vector<std::string> list_notes() const { return {}; }
  virtual std::vector<Warning> list_start_warnings() const { return {}; }
  /// Warnings since the last call.
  virtual std::vector<Warning> take_warnings() { return {}; }

  // What the stepper may leave out.

  /// Whether it comes between the velocities of this rank's nodes and their motion, or requests their forces, or for
  /// their places before they move. Where nothing does, predict() and change_velocities() are not called, and x is at
  /// n+1 right after begin_step(). One that returns true and leaves v as it is says so in bound_component().
  virtual bool comes_between() const { return true; }
  /// Whether add_forces() does something on any rank.
  virtual bool adds_forces() const { return false; }
  /// Whether it gives gravity to the nodes in predict(), which the stepper leaves out then.
  virtual bool gives_gravity() const { return false; }
  /// Where the elements are to write the bound of each; null: nowhere.
  virtual const ElementBounds* asked_bounds() const { return nullptr; }
  /// [chunks] bounds of the elements, with the masses that the nodes have.
  virtual Array<double> find_bounds(const ChunkResults& results) const { return results.stable_step; }
};

}  // namespace percuss
