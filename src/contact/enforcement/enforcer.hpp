#pragma once
// Enforcement (1.9) in the FE decomposition, on all ranks together (the paper's section 4.3.2).
//
// A row belongs to the rank that owns its contact node; other ranks may own corners of its face. In each iteration all
// ranks that touch or own a node swap their rows' forces on it, and each adds up all of them in one global order. The
// reduction for convergence runs at the same time. Ranks without rows, none of whose nodes others touch, take no part.

#include "comm/halo/node_copies.hpp"
#include "kernels/contact/enforcement/row_solution.hpp"
#include "kernels/contact/enforcement/tie_strength.hpp"
#include "kernels/contact/rows/wall_sleep.hpp"
#include "src/contact/enforcement/contact_forces.hpp"
#include "src/contact/enforcement/contact_report.hpp"
#include "src/contact/enforcement/moving_walls.hpp"
#include "src/contact/enforcement/row_exchange.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

class Enforcer {
 public:
  /// Collective, as are all calls. forces: books what the rows give; outlives this.
  Enforcer(const ContactRanks& ranks, const SurfaceShare& share, const WallPairs& walls,
           const Array<const TieGeometry>& ties, const Deck& deck, ContactForces& forces);

  /// Puts the velocity of n-1/2 into motion.v of nodes that contact pushed in the last step, for search and check:
  /// their internal forces alone do not predict their motion. It stays until restore_predicted_velocities().
  void set_contact_velocities(const ContactMotion& motion);
  /// Puts the velocities predicted without contact back.
  void restore_predicted_velocities(const ContactMotion& motion);

  /// Begins a step of contact: who has rows, given the touches of this rank's contact nodes, its ties last. is_same:
  /// whether this rank found what it did in the last step.
  RowMeeting meet(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches, bool is_same);

  /// Call after meet(), with the same arguments. Corrects motion.v and fills motion.impulse on every copy of a node;
  /// writes the history for the next step; fills in what the report says of enforcement.
  void enforce(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches,
               ContactHistory& history, ContactReport& report);

  /// find_tie_uses() of the last step. Not collective.
  void find_tie_uses(const TieStrengths& strengths, const Array<double>& use) const;

  /// The surface is another now: `walls` with the pairs of its nodes, the ties that are left.
  void redefine(const Mesh& mesh, const SurfaceShare& share, const WallPairs& walls,
                const Array<const TieGeometry>& ties);

  /// A step without contact on any rank: no impulses, no history.
  void rest(const ContactMotion& motion, ContactHistory& history);

  /// A step like the last one, in which rows pushed nothing: what was remembered still is.
  void repeat(const ContactMotion& motion);

  /// Impulses of the pushes along the normals on the nodes in the last step [force x time]: [mesh nodes], of copies of
  /// others' nodes zero. Collective.
  Rows3<double> find_pushes();
  /// Reads or writes these pushes in a checkpoint, if the deck that wrote it had them: after a restart they are these
  /// until the next step.
  void archive_pushes(CheckpointArchive& archive, const ChunkedMesh& chunked, const OwnedContactNodes& nodes);

  /// Walls that move stand still until begin_anew().
  void hold_walls();
  /// The next step is the first, with contacts that may push already.
  void begin_anew();

  void archive(CheckpointArchive& archive);

  /// Work of this rank's rows since the start by name_contact_pairs().
  const std::vector<PairWork>& pair_work() const { return pair_work_; }

  const MovingWalls& walls() const { return moving_walls_; }
  /// Pairs of a wall and a node of this rank since begin_anew().
  const WallCounts& wall_counts() const { return wall_sleep_.counts(); }

  Traffic traffic() const;

  // Kernels of its own: nvcc takes none in a private function.
  void list_pushed(const ContactMotion& motion);

 private:
  RowInputs make_inputs(const ContactMotion& motion) const;
  WallWays find_wall_ways(const ContactMotion& motion) const;
  void report_outcome(const WorkSpace& space, const ContactMotion& motion, int num_touches, const SolveReport& solved,
                      ContactReport& report);
  SolveReport solve(const WorkSpace& space, double dt, double dt_mean);
  void book_pairs(const WorkSpace& space);
  void finish_walls(const WorkSpace& space, int first_row, const ContactMotion& motion, ContactReport& report);
  void clear_last_impulse(const ContactMotion& motion);
  void update_copies(const ContactMotion& motion);

  WallPairs walls_;
  MovingWalls moving_walls_;
  WallSleep wall_sleep_;
  Array<const TieGeometry> ties_;
  const Array<const std::int64_t> node_numbers_;  // [mesh nodes]
  const bool has_many_ranks_, is_first_rank_;
  const ContactDeck deck_;
  SpringRows springs_;
  RowExchange exchange_;
  const SharedNodes copied_;
  const bool ties_rotations_;
  NodeCopies copies_;             // velocities and impulses, spins where they are tied
  const double depth_tolerance_;  // RowInputs::depth_tolerance
  RowSystem system_;
  RowMeeting meeting_;
  RowSumMemory sums_;
  ContactForces& forces_;
  Array<const double> spring_;       // [mesh nodes] of owned contact nodes; empty without penalty
  std::vector<PairWork> pair_work_;  // empty: not requested
  // Mesh nodes that the last step may have pushed, copies of others' among them, from set_contact_velocities() on, and
  // their predicted velocities until restore_predicted_velocities().
  int num_pushed_ = 0;
  Array<int> pushed_ = Array<int>("contact::pushed_nodes", 0);
  Rows3<double> predicted_ = Rows3<double>("contact::predicted_velocity", 0);
  bool was_pushed_ = false;               // impulses of the last step stand in motion.impulse
  const double* last_impulse_ = nullptr;  // where they were written
  double last_dt_ = 0, last_dt_mean_ = 0;
  bool starts_loaded_ = false;     // the next step is the first, from a state in which contacts push
  std::int64_t last_pushes_ = -1;  // of all ranks in the last step; -1: not known
  bool has_solved_ = false;        // system_ is that of the last step
  Rows3<double> restored_pushes_;  // of the step before a restart; empty from the next one on
  bool remembers_ = true;          // the history may hold something
};

}  // namespace percuss
