#pragma once
// The parts of the contact stage and its state. contact_stage.cpp has the steps, contact_stage_changes.cpp what makes
// the surface another, contact_stage_watch.cpp what is missed, contact_stage_results.cpp what the stage tells.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/contact/approach/approach_bound.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/contact/enforcement/enforcer.hpp"
#include "src/contact/enforcement/node_areas.hpp"
#include "src/contact/history/carried_history.hpp"
#include "src/contact/overlap/missed_contact.hpp"
#include "src/contact/overlap/start_overlap.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/surface/fold_watch.hpp"
#include "src/contact/surface/touching_beams.hpp"
#include "src/contact/ties/breaking_ties.hpp"
#include "src/contact/ties/late_ties.hpp"
#include "src/contact/ties/tie_rows.hpp"
#include "src/contact/ties/ties.hpp"

namespace percuss {

struct ContactStage::Impl {
  Impl(const ChunkedMesh& chunked, const Deck& scene, const Communicator& world)
      : ranks(world),
        deck(scene),
        chunks(chunked),
        numbering(chunked.numbering),
        mesh(chunked.mesh),
        exchange(world),
        ties_of_start(find_ties(chunked, deck, world)),
        ties(ties_of_start),
        active(find_active_contact(deck, std::vector<char>(deck.sensors.size(), 0))),
        share(build_surface_share(chunked, deck, ties, exchange, {}, active)),
        late(chunked, deck, ties, world),
        breaking(chunked, deck, ties, late.numbers(), world),
        tie_rows(contact_ranks(), ties, deck.contact),
        walls(build_walls(chunked, deck, share)),
        has_walls(!deck.walls.empty()),
        contact(deck.contact),
        bound(world, share, deck.contact.reuse_search),
        approach(world, share, walls, scene, chunked.mesh),
        folds(chunked, deck.contact, ranks),
        finder(make_contact_finder(contact_ranks(), share, deck.contact)),
        forces(scene, chunked, world),
        enforcer(contact_ranks(), share, walls, tie_rows.geometry(), deck, forces),
        history(make_history(share, walls, contact)) {
    history.ties = Rows3<double>("contact::history_ties", tie_rows.keys().size());
    forces.set_surface(contact_ranks(), share);
    is_active = has_pairs() || has_switched_pairs(deck.contact) || has_walls || ties.any();
    if (ties.any()) start_notes = describe_ties(deck, ties);
    for (const std::string& line : describe_touching_beams(deck, find_touching_radii(mesh, deck)))
      start_notes.push_back(line);
    if (!late.any()) return;
    measure_late_areas(place_at_start());
    restore_surface();
  }

  ContactRanks contact_ranks() const { return {ranks, numbering, mesh}; }
  bool has_pairs() const { return share.may_touch(); }

  bool search(const SurfaceMotion& motion, double fastest);
  void count_search();
  void search_again();
  int check(const SurfaceMotion& motion);
  RowMeeting meet(const ContactMotion& motion, int num_touches);
  void judge_ties(double time, ContactReport& report);
  std::optional<KnownContact> find_known() const;
  PiercingEdges find_piercings(const Rows3<const double>& x);
  void archive_watch(CheckpointArchive& archive);
  void archive_pierced(CheckpointArchive& archive);
  void archive_inside(CheckpointArchive& archive);
  void warn_of_missed(const std::optional<MissedContact>& found, double time);
  std::unique_ptr<ContactFinder> make_look(const LookedAt& at) const {
    return make_look_finder(*finder, contact_ranks(), share, contact, at);
  }
  OverlapSearch look_for_overlap(ContactFinder& with) const { return {ranks, share, walls, bound, with, flush}; }
  std::int64_t find_user_id(std::int64_t node) const;
  void refuse_ties_held_apart(const ContactReport& report) const;
  const AreaNodes& find_areas(const Rows3<const double>& x);
  void forget_last_step();
  void forget_spring_energy();
  void redefine_surface();
  void follow_share();
  void renew_finder();
  void search_changed(const SurfaceMotion& here);
  void redefine(const SurfaceMotion& here, const ReleasedTies* ties_let_go);
  void redefine_folds(const SurfaceMotion& here);
  void restore_surface();
  BornContact list_born(const ActiveContact& before) const;
  std::string describe(const StartOverlap& found, const std::string& when) const;
  std::string describe_born_crossings(const Rows3<const double>& x) const;
  std::vector<PartCrossing> find_crossings(const Rows3<const double>& x) const {
    return percuss::find_crossings({ranks, chunks, deck, share, ties}, x);
  }
  bool archive_active(CheckpointArchive& archive);
  Rows3<const double> place_at_start() const;
  void measure_late_areas(const Rows3<const double>& x);
  ReleasedTies switch_ties(const ActiveContact& before, const Rows3<const double>& x, std::vector<std::string>& lines);
  std::vector<std::int64_t> list_sticking(std::size_t tie) const;
  bool stick(const Rows3<const double>& x);
  HistoryOwners list_owners() const { return list_history_owners(chunks, share, walls, tie_rows.keys()); }

  const Communicator ranks;
  const Deck& deck;
  const ChunkedMesh& chunks;
  const Numbering& numbering;
  const Mesh& mesh;
  UnstructuredExchange exchange;
  TiedSurfaces ties_of_start;  // without ties that have failed
  TiedSurfaces ties;           // ties that erosion has left
  ActiveContact active;
  SurfaceShare share;
  LateTies late;
  BreakingTies breaking;
  TieRows tie_rows;
  WallPairs walls;
  const bool has_walls;
  bool is_active = false;  // from the start to the end
  bool is_begun = false;   // by prepare(), or from a checkpoint
  bool is_relaxing = false;
  bool forgets_springs = false;  // from the start of a relaxation to the end of the first step after it
  const ContactDeck contact;
  ReuseBound bound;
  ApproachBound approach;  // bounds the next step
  FoldWatch folds;
  std::unique_ptr<ContactFinder> finder;
  ContactForces forces;
  Enforcer enforcer;
  std::optional<NodeAreas> areas;  // of the surface as it is; none: not requested since it was redefined
  ContactHistory history;
  std::vector<std::string> start_notes;
  FlushTies flush;  // of the start
  StartOverlap start_overlap;
  std::int64_t overlap_at_start = 0;  // nodes and pairs of edges that began inside another
  Array<RowTouch> touches = Array<RowTouch>("contact::row_touches", 0);
  std::int64_t candidates = 0;  // of the last search, on all ranks
  long searches = 0;            // steps that did
  bool is_step_counted = true;  // among these; the start is no step
  bool is_new_surface = false;  // since the last step
  Array<double> tie_uses = Array<double>("contact::tie_uses", 0);
  ContactReport last;     // of the last step
  int touches_last = 0;   // of this rank in it
  int same_steps = 0;     // in a row that found, on all ranks, what the step before did
  long enforcements = 0;  // steps that looked for impulses
  ContactClocks clocks;
  PhaseClock decomposed_at_start;  // in searches before the first step, which are in no phase
  Traffic sent_at_start;           // in steps before time 0
  long rebalances_at_start = 0;    // likewise
  std::vector<Warning> missed;     // of watch_depth() and watch_edges()
  bool has_warned_missed = false;
  long next_edge_look = 0, next_piercing_look = 0;                   // steps
  std::optional<std::vector<std::pair<int, int>>> pierced_at_start;  // bodies, ascending; none: not looked at yet
};

}  // namespace percuss
