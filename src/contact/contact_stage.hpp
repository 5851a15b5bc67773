#pragma once
// The contact stage of a step (the paper's (1.7) to (1.9)): search if due, detailed check, enforcement.
//
// The stage is called once a step, after the motion was predicted without contact. It corrects the velocities so that
// no contact node ends behind a face or a wall. All work follows the order of global numbers: the same bits for any
// number of ranks and threads.

#include <memory>
#include <string>
#include <vector>

#include "comm/phase.hpp"
#include "kernels/contact/rows/wall_sleep.hpp"
#include "src/contact/approach/approach.hpp"
#include "src/contact/enforcement/contact_forces.hpp"
#include "src/contact/enforcement/contact_report.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/ties/tie_measures.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

struct StartOverlap;

/// Time since the start, by phase.
struct ContactClocks {
  PhaseClock decomposition, search, check, enforce;

  PhaseClock sum() const {
    PhaseClock all = decomposition;
    for (const PhaseClock& clock : {search, check, enforce}) all += clock;
    return all;
  }
};

class ContactStage {
 public:
  /// Finds the contact surface of the mesh, of which each rank holds its share, and reads who may touch whom. Throws
  /// InputError for unknown surfaces. Collective over `ranks`, as are prepare(), apply() and measure_penetration().
  /// `chunked` outlives the stage.
  ContactStage(const ChunkedMesh& chunked, const Deck& deck, const Communicator& ranks);
  ~ContactStage();

  /// Whether the scene has contact, ties or walls at all; if not, apply() must not be called.
  bool is_active() const;

  /// Whether apply() does less if it knows the largest speeds, ContactMotion::fastest and fastest_before.
  bool wants_speeds() const;

  /// Sets which pairs, walls and ties act at the start, by the events of sensors; call before prepare(). Collective.
  void set_switches(const std::vector<char>& happened);

  /// As set_switches(), between steps, with x and v of the state. Overlap where a pair or a wall begins to act is
  /// treated as overlap at the start; a tie holds nodes where they are then. Returns the messages for the user, the
  /// same on all ranks; throws RunError with them where the deck refuses overlap. Collective.
  std::vector<std::string> switch_now(const std::vector<char>& happened, Rows3<const double> x, Rows3<const double> v);

  /// Overlap at time 0 between surfaces, found and accepted or marked for pushing out as the deck says. Returns one
  /// line for the user ("12 nodes overlap, deepest 0.3 mm ..."), the same on all ranks; empty if there is none. Parts
  /// that cross are found in any scene, whether they may touch or not. Throws InputError where the deck refuses what
  /// overlaps or crosses. Call once before the loop.
  std::string prepare(Rows3<const double> x, Rows3<const double> v);

  /// Further notes on the start: a line for each tie; after prepare() one of the smallest gaps, and one of parts that
  /// cross without contact.
  const std::vector<std::string>& start_notes() const;

  /// Overlap that prepare() found, of all ranks; empty before it.
  const StartOverlap& start_overlap() const;

  /// Measures the ties of the start. Collective.
  TieMeasures measure_ties() const;

  /// How much of the overlap of the start is left at positions x, in a line; empty if there was none. Collective.
  std::string describe_overlap_left(Rows3<const double> x) const;

  /// State of the stage from step to step. After loading, the last search is done again, so that its counts are the
  /// same; then prepare() must not be called. Collective.
  void archive(CheckpointArchive& archive);

  /// Rebuilds the surface after erosion: Mesh::eroded and Mesh::exterior are new. Contacts keep their history; overlap
  /// of faces and nodes that have been exposed is taken like that of the start. Call between steps, with x and v of the
  /// state.
  void redefine(Rows3<const double> x, Rows3<const double> v);

  /// Takes, in a step after apply(), the numbers of nodes whose glue has failed, the same on all ranks. break_ties()
  /// releases them.
  void let_go(const std::vector<std::int64_t>& nodes);

  /// Numbers of the tied nodes that this rank owns, ascending.
  std::vector<std::int64_t> list_tied_nodes() const;

  /// After a step, with x and v of the state: ties that failed in it are released, and their surfaces may touch from
  /// now on; ties that grow take the nodes that came into contact in it. Returns whether any did. Collective.
  bool break_ties(Rows3<const double> x, Rows3<const double> v);

  /// After a step, with x and v of the state: periodically, edges that have become sharp join the edges that may touch
  /// others, and those that have become smooth again leave them. Collective.
  void watch_folds(Rows3<const double> x, Rows3<const double> v, long step);

  /// With x and v of the state, periodically and at the end of a run: warns once of what lies inside another body
  /// without contact. Collective.
  void watch_depth(Rows3<const double> x, Rows3<const double> v, double time);

  /// As watch_depth(), for sharp edges alone and more often: at intervals that grow with the cost of the last check.
  void watch_edges(Rows3<const double> x, long step, double time);

  /// Warnings of failed ties, and those of watch_depth() and watch_edges(), since the last call.
  std::vector<Warning> take_warnings();

  /// Rebuilds the surface for a state from a checkpoint, before archive().
  void restore_surface();

  /// Begins the steps before time 0, in which moving walls stand still.
  void begin_relaxation();
  /// The next step is the first one: contacts keep their history, and all counts and sums begin anew. x: positions at
  /// time 0. Collective.
  void end_relaxation(Rows3<const double> x);

  /// Finds approach() before the first step, which would be dt. Collective.
  void watch_start(Rows3<const double> x, Rows3<const double> v, double dt);

  /// The bound of the next step from bodies that approach each other, as apply() or watch_start() found it last.
  const Approach& approach() const;

  /// Corrects motion.v and fills motion.impulse. Throws RunError, on all ranks, if conditions tear a tie apart, or if a
  /// wall with a mass is caught between bodies that cannot give way.
  ContactReport apply(const ContactMotion& motion);

  /// Work of normal and tangential impulses since the start by name_contact_pairs(), of all ranks: 2 a pair; booked
  /// only for decks that write a history. Collective.
  std::vector<double> sum_pair_work() const;

  /// Displacement and speed of each wall that moves, by name_moving_walls().
  std::vector<double> list_wall_motions() const;

  /// Kinetic energy of walls with a mass, the same on all ranks.
  double find_wall_energy() const;

  /// Impulses of the forces of contact and of walls in output.history.forces since the last call, in their order; areas
  /// are those at positions x. Collective.
  std::vector<ContactImpulse> take_forces(Rows3<const double> x);

  /// Normal force of contact on each node in the last step, of length dt, over its area of the contact surface at
  /// positions x [stress]: [mesh nodes], of copies of others' nodes 0. Collective.
  std::vector<double> find_pressures(Rows3<const double> x, double dt) const;

  std::int64_t contact_nodes() const;  // of the whole scene
  std::int64_t contact_faces() const;
  long searches() const;      // how many steps searched, for their contact or because erosion had redefined the surface
  long enforcements() const;  // how many steps looked for impulses, though they may have found none
  DecompositionReport decomposition() const;
  SearchLoad load() const;         // of this rank
  PairCounts pair_counts() const;  // likewise
  WallCounts wall_counts() const;  // likewise

  /// Rank that owns each node of this rank's share in the contact decomposition, -1 for nodes that are not searched,
  /// for copies of nodes that other ranks own. After prepare(). Not collective.
  std::vector<double> contact_ranks() const;
  ContactClocks clocks() const;
  /// Messages of this rank since the start.
  Traffic traffic() const;

  /// Deepest penetration of any contact node behind a face that it touches or has entered, at positions x, relative to
  /// that face's shortest edge; for audits and tests, independent of the candidate lists in use.
  double measure_penetration(Rows3<const double> x) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
