#include "src/contact/contact_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/approach/approach.hpp"
#include "src/contact/approach/wall_watch.hpp"
#include "src/contact/enforcement/enforcer.hpp"
#include "src/contact/enforcement/node_areas.hpp"
#include "src/contact/folds/fold_watch.hpp"
#include "src/contact/history/carried_history.hpp"
#include "src/contact/history/contact_checkpoint.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/start/part_gaps.hpp"
#include "src/contact/start/start_overlap.hpp"
#include "src/contact/ties/tie_failures.hpp"
#include "src/contact/ties/tie_rows.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Why a surface is another now.
struct SurfaceCause {
  enum class Kind { elements, ties, folds } kind = Kind::elements;
  ReleasedTies released = {};  // whose surfaces may touch from now on
};

/// Displacement and speed of each wall.
std::vector<WallMotion> list_motions(const Deck& deck, const MovingWalls& moving) {
  std::vector<WallMotion> motions(deck.walls.size());
  std::size_t next = 0;
  for (std::size_t w = 0; w < motions.size(); ++w)
    if (deck.walls[w].moves()) motions[w] = moving.motions()[next++];
  return motions;
}

}  // namespace

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
        share(build_surface_share(chunked, deck, ties, exchange)),
        failures(chunked, deck, ties, world),
        tie_rows(seen(), ties, deck.contact),
        walls(build_walls(chunked, deck, share)),
        has_walls(!deck.walls.empty()),
        contact(deck.contact),
        bound(world, share, deck.contact.reuse_search),
        watch(world, share),
        wall_watch(world, scene, chunked.mesh),
        folds(chunked, deck.contact, ranks),
        finder(make_contact_finder(seen(), share, deck.contact)),
        forces(scene, chunked, world),
        enforcer(seen(), share, walls, tie_rows.geometry(), deck, forces),
        history(make_history(share, walls)) {
    wall_watch.redefine(walls);
    history.ties = Rows3<double>("contact::history_ties", tie_rows.keys().size());
    forces.set_surface(seen(), share);
    is_active = has_pairs() || has_walls || ties.any();
    if (ties.any()) start_notes = describe_ties(deck, ties);
  }

  ContactRanks seen() const { return {ranks, numbering, mesh}; }
  bool has_pairs() const { return share.total_searched_faces > 0; }

  bool search(const SurfaceMotion& motion);
  bool may_walls_limit(double way, double dt) const;
  Approach look_at_walls(const SurfaceMotion& motion, double way) const;
  void count_search();
  void search_again();
  int check(const SurfaceMotion& motion);
  RowMeeting meet(const ContactMotion& motion, int num_touches);
  void judge_ties(double time, ContactReport& report);
  OverlapSearch look_for_overlap(ContactFinder& with) const { return {ranks, share, walls, bound, with}; }
  std::int64_t find_user_id(std::int64_t node) const;
  void refuse_torn_ties(const ContactReport& report) const;
  const AreaNodes& find_areas(const Rows3<const double>& x);
  void forget_last_step();
  void archive_pushes(CheckpointArchive& archive);
  void redefine_surface();
  void redefine_share();
  void redefine_finder();
  void redefine_edges();
  void redefine(Rows3<const double> x, Rows3<const double> v, const SurfaceCause& cause);
  HistoryOwners list_owners() const { return list_history_owners(chunks, share, walls, tie_rows.keys()); }

  const Communicator ranks;
  const Deck& deck;
  const ChunkedMesh& chunks;
  const Numbering& numbering;
  const Mesh& mesh;
  UnstructuredExchange exchange;
  TiedSurfaces ties_of_start;  // but those that have failed
  TiedSurfaces ties;           // those that erosion has left
  SurfaceShare share;
  TieFailures failures;
  TieRows tie_rows;
  WallPairs walls;
  const bool has_walls;
  bool is_active = false;  // from the start to the end
  const ContactDeck contact;
  ReuseBound bound;
  ApproachWatch watch;
  WallWatch wall_watch;
  Approach approach;  // bounds the next step
  FoldWatch folds;
  std::unique_ptr<ContactFinder> finder;
  ContactForces forces;
  Enforcer enforcer;
  std::optional<NodeAreas> areas;  // of the surface as it is; none: not asked for since it was redefined
  ContactHistory history;
  std::vector<std::string> start_notes;
  StartOverlap start_overlap;
  std::int64_t overlap_at_start = 0;  // nodes and pairs of edges that began inside another
  Array<RowTouch> touches = Array<RowTouch>("contact::row_touches", 0);
  std::int64_t candidates = 0;  // of the last search, on all ranks
  long searches = 0;            // steps that did
  bool is_step_counted = true;  // among these; the start is no step
  bool is_new_surface = false;  // since the last step
  Array<double> tie_uses = Array<double>("contact::tie_uses", 0);
  std::int64_t failing_now = 0;  // tied nodes, on all ranks, until break_ties()
  bool is_relaxing = false;      // steps before time 0, in which ties do not fail
  std::vector<Warning> warnings;
  ContactReport last;     // of the last step
  int touches_last = 0;   // of this rank in it
  int same_steps = 0;     // in a row that found, on all ranks, what the step before did
  long enforcements = 0;  // steps that looked for impulses
  ContactClocks clocks;
  PhaseClock decomposed_at_start;  // in searches before the first step, which are in no phase
  Traffic sent_at_start;           // in steps before time 0
  long rebalances_at_start = 0;    // likewise
};

/// (1.7) Search for potential contacts, if the candidate pairs may have become too few. Returns whether it searched.
bool ContactStage::Impl::search(const SurfaceMotion& motion) {
  if (!has_pairs()) {
    approach = has_walls ? look_at_walls(motion, wall_watch.find_way(walls, motion)) : Approach{};
    return false;
  }
  const Phase phase("percuss::contact_search", clocks.search);
  bound.enter_step(motion);
  const bool is_near = bound.covers_near(motion);
  approach = {};
  if (!is_near || watch.may_limit(bound.near_way()) || may_walls_limit(bound.near_way(), motion.dt)) {
    const double way = bound.find_way(motion);
    approach = choose_shorter(watch.look(motion, way), look_at_walls(motion, way));
  }
  if (is_near) {
    bound.leave_step();
    return false;
  }
  const bool is_due = !bound.covers(motion);
  if (is_due) candidates = finder->search(motion, bound.restart(motion));
  // Where elements are eroded step by step, a list would serve a single one.
  finder->narrow(is_new_surface ? NearWay{} : bound.restart_near(motion));
  is_new_surface = false;
  bound.leave_step();
  return is_due;
}

bool ContactStage::Impl::may_walls_limit(double way, double dt) const {
  return has_walls && wall_watch.may_limit(way, list_motions(deck, enforcer.walls()), dt);
}

/// way: the longest of a node in the step.
Approach ContactStage::Impl::look_at_walls(const SurfaceMotion& motion, double way) const {
  if (!may_walls_limit(way, motion.dt)) return {};
  return wall_watch.look({walls, list_motions(deck, enforcer.walls())}, motion);
}

/// One of a step may be made before its contact and one after it.
void ContactStage::Impl::count_search() {
  if (!is_step_counted) ++searches;
  is_step_counted = true;
}

/// After a restart: the search that found the candidate pairs in use.
void ContactStage::Impl::search_again() {
  if (!has_pairs() || !bound.is_valid()) return;
  const Rows3<double> x = spread_to_mesh(ranks, chunks, share, bound.origin());
  const Rows3<double> v = spread_to_mesh(ranks, chunks, share, bound.velocity());
  candidates = finder->search({x, v, bound.dt()}, bound.margin());
  decomposed_at_start = finder->decomposition_clock();
}

/// (1.8) Detailed contact check of the candidate pairs; ties are added. Returns the number of touches.
int ContactStage::Impl::check(const SurfaceMotion& motion) {
  if (candidates == 0) return tie_rows.append(0, touches);
  const Phase phase("percuss::contact_check", clocks.check);
  return tie_rows.append(finder->check(motion, history, touches), touches);
}

/// What ranks know of each other's contact in this step. is_same becomes whether enforcement would repeat the last step
/// on every rank, without impulses, because all contacts are at rest. The second such step in a row computes the
/// history from that of the first, the third the same again.
RowMeeting ContactStage::Impl::meet(const ContactMotion& motion, int num_touches) {
  const bool is_same = finder->has_found_nothing_new() && num_touches == touches_last;
  touches_last = num_touches;
  const bool acts_always = has_walls || ties.any();
  const bool has_rested = last.iterations > 0 && last.interactions == 0 && !acts_always;
  RowMeeting meeting;
  if (acts_always || candidates > 0 || has_rested) meeting = enforcer.meet(motion, touches, num_touches, is_same);
  same_steps = has_rested && meeting.is_same ? same_steps + 1 : 0;
  return {acts_always || (candidates > 0 && meeting.any_rows), same_steps > 1};
}

/// Which ties have reached their strength. time: of the end of the step.
void ContactStage::Impl::judge_ties(double time, ContactReport& report) {
  report.failed_ties = failures.count();
  if (!failures.any_left() || !report.enforced || is_relaxing) return;
  reserve(tie_uses, static_cast<int>(ties.nodes.size()));
  enforcer.find_tie_uses(failures.strengths(), tie_uses);
  const std::vector<std::int64_t> counts = failures.judge(tie_uses);
  failing_now = 0;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    if (counts[t] == 0) continue;
    failing_now += counts[t];
    const TieDeck& tie = contact.ties[t];
    warnings.push_back({"tie_failure",
                        fmt::format("nodes of the tie of '{}' and '{}' let go (the stress on them has come to what "
                                    "failure says): failed_ties in history.csv counts them",
                                    tie.a.name, tie.b.name),
                        deck.where(tie.place), time, static_cast<long>(counts[t])});
  }
  report.failed_ties += failing_now;
}

/// The user's id of a node, which its owner knows.
std::int64_t ContactStage::Impl::find_user_id(std::int64_t node) const {
  const int owner = numbering.find_node_owner(node);
  std::int64_t id = 0;
  if (owner == ranks.rank()) {
    const auto place = std::lower_bound(mesh.node_numbers.begin(), mesh.node_numbers.end(), node);
    id = mesh.node_ids[static_cast<std::size_t>(place - mesh.node_numbers.begin())];
  }
  wait_mpi([&] { return MPI_Bcast(&id, 1, MPI_INT64_T, owner, ranks.handle()); }, "MPI_Bcast");
  return id;
}

/// Conditions that hold a tied node and its face in one direction must move both alike.
void ContactStage::Impl::refuse_torn_ties(const ContactReport& report) const {
  constexpr double torn = 1e-3;  // of a face: conditions that move both alike differ by round-off
  if (!(report.torn > torn)) return;
  throw RunError(
      fmt::format("conditions move tied node {} and its face apart (by {:.2g} of the face size): remove the condition "
                  "on one of them",
                  find_user_id(report.torn_node), report.torn));
}

/// Areas of the owned contact nodes at positions x.
const AreaNodes& ContactStage::Impl::find_areas(const Rows3<const double>& x) {
  if (!areas) areas.emplace(seen(), share);
  areas->update(x);
  return areas->nodes();
}

/// What the last step did says nothing about this one.
void ContactStage::Impl::forget_last_step() {
  last = {};
  touches_last = same_steps = 0;
}

/// Everything that follows from the mesh as it is now, but the history.
void ContactStage::Impl::redefine_surface() {
  ties = keep_living_ties(chunks, ties_of_start, ranks);
  failures.use(ties);
  tie_rows = TieRows(seen(), ties, contact);
  redefine_share();
  walls = build_walls(chunks, deck, share);
  watch.redefine();
  wall_watch.redefine(walls);
  redefine_finder();
}

void ContactStage::Impl::redefine_share() {
  forget_last_step();
  areas.reset();
  share = build_surface_share(chunks, deck, ties, exchange, folds.folds());
  bound.redefine();
  is_new_surface = true;
}

void ContactStage::Impl::redefine_finder() {
  std::unique_ptr<ContactFinder> next = make_contact_finder(seen(), share, contact);
  next->take_over(*finder);
  finder = std::move(next);
  enforcer.redefine(mesh, share, walls, tie_rows.geometry());
  forces.set_surface(seen(), share);
  candidates = 0;
}

/// Nodes, faces, walls and ties are as they were.
void ContactStage::Impl::redefine_edges() {
  redefine_share();
  watch.redefine();  // numbers of classes are others
  redefine_finder();
}

ContactStage::ContactStage(const ChunkedMesh& chunked, const Deck& deck, const Communicator& ranks)
    : impl_(std::make_unique<Impl>(chunked, deck, ranks)) {}
ContactStage::~ContactStage() = default;

bool ContactStage::is_active() const { return impl_->is_active; }

const std::vector<std::string>& ContactStage::start_notes() const { return impl_->start_notes; }

std::vector<TieHinge> ContactStage::find_hinges() const {
  return find_tie_hinges(impl_->chunks, impl_->deck, impl_->ties_of_start, impl_->ranks);
}

std::string ContactStage::prepare(Rows3<const double> x, Rows3<const double> v) {
  Impl& stage = *impl_;
  // The finder of the run: its first step searches again, but the decomposition is made here and seen in the first
  // frame.
  const ContactDeck::Overlap overlap = stage.contact.overlap;
  stage.start_overlap = seed_history(stage.look_for_overlap(*stage.finder), {x, v, 0}, overlap, stage.history);
  const StartOverlap& found = stage.start_overlap;
  if (const std::string gaps = describe_gaps(found.gaps, stage.mesh); !gaps.empty()) stage.start_notes.push_back(gaps);
  stage.decomposed_at_start = stage.finder->decomposition_clock();
  const std::int64_t deepest = found.deepest_node < 0 ? -1 : stage.find_user_id(found.deepest_node);
  std::string line = describe_overlap(found, overlap, stage.mesh, deepest);
  if (overlap == ContactDeck::Overlap::refuse && !line.empty())
    throw InputError(fmt::format("{}: error: {}: move the parts apart, or set contact.overlap to accept or push_out",
                                 stage.deck.where(stage.deck.places.find("contact.overlap")), line));
  stage.overlap_at_start = found.nodes + found.edge_pairs;
  return line;
}

std::string ContactStage::describe_overlap_left(Rows3<const double> x) const {
  const Impl& stage = *impl_;
  if (stage.overlap_at_start == 0) return "";
  ContactDeck once = stage.contact;
  once.rebalance = ContactDeck::Rebalance::never;
  const auto finder = make_contact_finder(stage.seen(), stage.share, once);
  ContactHistory unused = make_history(stage.share, stage.walls);
  return percuss::describe_overlap_left(
      seed_history(stage.look_for_overlap(*finder), {x, x, 0}, ContactDeck::Overlap::accept, unused));
}

const StartOverlap& ContactStage::start_overlap() const { return impl_->start_overlap; }

void ContactStage::restore_surface() {
  Impl& stage = *impl_;
  stage.folds.redefine();
  stage.redefine_surface();
  stage.history = make_history(stage.share, stage.walls);
  stage.history.ties = Rows3<double>("contact::history_ties", stage.tie_rows.keys().size());
}

void ContactStage::redefine(Rows3<const double> x, Rows3<const double> v) { impl_->redefine(x, v, {}); }

void ContactStage::watch_folds(Rows3<const double> x, Rows3<const double> v, long step) {
  Impl& stage = *impl_;
  if (!stage.folds.is_due(step)) return;
  {
    const Phase phase("percuss::contact_folds", stage.clocks.search);
    if (!stage.folds.look(stage.share, x, step)) return;
  }
  stage.redefine(x, v, {SurfaceCause::Kind::folds});
}

void ContactStage::Impl::redefine(Rows3<const double> x, Rows3<const double> v, const SurfaceCause& cause) {
  const Phase phase("percuss::contact_redefine", clocks.search);
  const bool are_folds = cause.kind == SurfaceCause::Kind::folds;
  const HistoryOwners before = list_owners();
  if (are_folds) {
    redefine_edges();
  } else {
    folds.redefine();
    redefine_surface();
  }
  const HistoryOwners now = list_owners();
  history = carry_history(ranks, history, before, now, share, walls);
  if (!has_pairs()) return;
  // One search for both: where opened surfaces overlap, and the pairs of the next steps.
  const SurfaceMotion here{x, v, 0};
  candidates = finder->search(here, bound.restart(here, true));
  count_search();
  const SurfaceChange change{before, now, cause.released.nodes, cause.released.faces};
  if (cause.kind != SurfaceCause::Kind::elements) seed_edges(look_for_overlap(*finder), here, change, history.edges);
  if (!are_folds) seed_opened(look_for_overlap(*finder), here, contact.overlap, change, history);
}

bool ContactStage::break_ties(Rows3<const double> x, Rows3<const double> v) {
  Impl& stage = *impl_;
  if (stage.failing_now == 0) return false;
  stage.failing_now = 0;
  stage.redefine(x, v, {SurfaceCause::Kind::ties, stage.failures.release(stage.ties_of_start)});
  return true;
}

std::vector<Warning> ContactStage::take_warnings() { return std::exchange(impl_->warnings, {}); }

/// Pushes of the last step, for the contact_pressure of a frame that a restart writes before its first step. Nothing
/// else needs them: only where the deck writes that field, and the checkpoint is of a deck that did.
void ContactStage::Impl::archive_pushes(CheckpointArchive& archive) {
  bool is_written = deck.output.writes("contact_pressure");
  if (!is_written || !archive.has_number("contact/has_pushes")) return;
  archive.integer("contact/has_pushes", is_written);
  const bool is_loading = archive.is_loading();
  const Rows3<double> pushes =
      is_loading ? Rows3<double>("contact::restored_pushes", mesh.nodes.size()) : enforcer.find_pushes();
  const auto host = to_host(pushes);
  std::vector<double> rows;
  for (const int n : share.nodes.mesh_nodes) {
    for (std::size_t k = 0; k < 3; ++k) rows.push_back(host(at(n), k));
  }
  archive.rows("contact/nodes/push", find_rows_of_nodes(chunks, share.nodes.numbers), 3, std::span<double>(rows));
  if (!is_loading) return;
  for (std::size_t i = 0; i < share.nodes.mesh_nodes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) host(at(share.nodes.mesh_nodes[i]), k) = rows[3 * i + k];
  }
  Kokkos::deep_copy(pushes, host);
  enforcer.restore_pushes(pushes);
}

void ContactStage::watch_start(Rows3<const double> x, Rows3<const double> v, double dt) {
  Impl& stage = *impl_;
  stage.approach = stage.watch.look_at_start(x, v, dt);
  if (!stage.has_walls) return;
  const MovedWalls moved{stage.walls, list_motions(stage.deck, stage.enforcer.walls())};
  stage.approach = choose_shorter(stage.approach, stage.wall_watch.look_at_start(moved, x, v, dt));
}

const Approach& ContactStage::approach() const { return impl_->approach; }

void ContactStage::begin_relaxation() {
  impl_->is_relaxing = true;
  impl_->enforcer.hold_walls();
}

void ContactStage::end_relaxation(Rows3<const double> x) {
  Impl& stage = *impl_;
  stage.forget_last_step();
  stage.is_relaxing = false;
  stage.enforcer.begin_anew();
  take_forces(x);
  stage.searches = stage.enforcements = 0;
  stage.clocks = {};
  stage.decomposed_at_start = stage.finder->decomposition_clock();
  stage.sent_at_start = traffic();
  stage.rebalances_at_start = stage.finder->report().rebalances;
}

void ContactStage::archive(CheckpointArchive& archive) {
  Impl& stage = *impl_;
  if (stage.failures.archive(archive, stage.ties_of_start)) restore_surface();
  if (stage.folds.archive(archive, stage.share)) restore_surface();
  archive_history(archive, stage.chunks, stage.share, stage.walls, stage.history);
  archive_edges(archive, stage.chunks, stage.share, stage.history.edges);
  if (stage.ties.any())
    archive_ties(archive, stage.chunks, stage.tie_rows.keys(), stage.contact.ties_rotations(), stage.history);
  stage.bound.archive(archive, find_rows_of_nodes(stage.chunks, stage.share.nodes.numbers));
  stage.enforcer.archive(archive);
  stage.forces.archive(archive);
  stage.archive_pushes(archive);
  archive.number("contact/overlap_at_start", stage.overlap_at_start);
  archive_approach(archive, stage.approach);
  if (!archive.is_loading()) return;
  stage.forget_last_step();
  stage.search_again();
}

// (1.7), (1.8), (1.9), the last in Enforcer::enforce().
ContactReport ContactStage::apply(const ContactMotion& motion) {
  Impl& stage = *impl_;
  stage.enforcer.show_seen(motion);
  const SurfaceMotion seen{motion.x, motion.v, motion.dt};
  stage.is_step_counted = false;
  const bool has_searched = stage.search(seen);
  if (has_searched) stage.count_search();
  const int num_touches = stage.check(seen);
  stage.enforcer.show_predicted(motion);
  const Phase phase("percuss::contact_enforce", stage.clocks.enforce);
  const auto [is_anything_touched, is_repetition] = stage.meet(motion, num_touches);
  ContactReport report = is_repetition ? stage.last : ContactReport{};
  report.searched = has_searched;
  report.candidates = stage.candidates;
  report.enforced = false;
  if (is_repetition)
    stage.enforcer.repeat(motion);
  else if (is_anything_touched)
    stage.enforcer.enforce(motion, stage.touches, num_touches, stage.history, report);
  else
    stage.enforcer.rest(motion, stage.history);
  stage.enforcements += report.enforced ? 1 : 0;
  stage.judge_ties(motion.time + motion.dt, report);
  stage.last = report;
  stage.refuse_torn_ties(report);
  return report;
}

std::vector<double> ContactStage::sum_pair_work() const {
  std::vector<double> work;
  for (const PairWork& pair : impl_->enforcer.pair_work()) {
    std::array<ExactSum, 2> sums{pair.normal, pair.friction};
    sum_over_ranks(impl_->ranks, sums);
    for (const ExactSum& sum : sums) work.push_back(sum.round());
  }
  return work;
}

std::vector<double> ContactStage::list_wall_motions() const {
  std::vector<double> values;
  for (const WallMotion& motion : impl_->enforcer.walls().motions()) {
    values.push_back(motion.displacement);
    values.push_back(motion.speed);
  }
  return values;
}

std::vector<ContactImpulse> ContactStage::take_forces(Rows3<const double> x) {
  if (impl_->forces.is_empty()) return {};
  return impl_->forces.take(impl_->find_areas(x));
}

std::vector<double> ContactStage::find_pressures(Rows3<const double> x, double dt) const {
  Impl& stage = *impl_;
  std::vector<double> pressures(stage.mesh.nodes.size(), 0);
  if (!(dt > 0)) return pressures;
  const auto pushes = to_host(stage.enforcer.find_pushes());
  const AreaNodes& nodes = stage.find_areas(x);
  const NodeFaces around{to_host(nodes.around.first), to_host(nodes.around.faces), to_host(nodes.around.areas)};
  for (int i = 0; i < stage.share.nodes.count(); ++i) {
    const auto n = static_cast<std::size_t>(stage.share.nodes.mesh_nodes[static_cast<std::size_t>(i)]);
    double area = 0;
    pressures[n] = find_press(around, i, {pushes(n, 0), pushes(n, 1), pushes(n, 2)}, area) / dt;
  }
  return pressures;
}

std::int64_t ContactStage::contact_nodes() const { return impl_->share.total_nodes; }
std::int64_t ContactStage::contact_faces() const { return impl_->share.total_faces; }
long ContactStage::searches() const { return impl_->searches; }
long ContactStage::enforcements() const { return impl_->enforcements; }
ContactClocks ContactStage::clocks() const {
  ContactClocks clocks = impl_->clocks;
  clocks.decomposition = impl_->finder->decomposition_clock();
  clocks.decomposition -= impl_->decomposed_at_start;
  clocks.search -= clocks.decomposition;
  return clocks;
}

Traffic ContactStage::traffic() const {
  Traffic sum = impl_->finder->traffic();
  sum.messages += impl_->enforcer.traffic().messages;
  sum.bytes += impl_->enforcer.traffic().bytes;
  sum.messages -= impl_->sent_at_start.messages;
  sum.bytes -= impl_->sent_at_start.bytes;
  return sum;
}

DecompositionReport ContactStage::decomposition() const {
  DecompositionReport report = impl_->finder->report();
  report.rebalances -= impl_->rebalances_at_start;
  return report;
}
SearchLoad ContactStage::load() const { return impl_->finder->load(); }
PairCounts ContactStage::pair_counts() const { return impl_->finder->pair_counts(); }

std::vector<double> ContactStage::contact_ranks() const {
  const Impl& stage = *impl_;
  std::vector<double> ranks(stage.mesh.nodes.size(), -1);
  const std::vector<int> owners = stage.finder->node_ranks();
  std::size_t next = 0;
  for (std::size_t n = 0; n < stage.share.nodes.mesh_nodes.size(); ++n) {
    if (stage.share.nodes.searched[n] == 0) continue;
    ranks[static_cast<std::size_t>(stage.share.nodes.mesh_nodes[n])] = owners[next++];
  }
  return ranks;
}

double ContactStage::measure_penetration(Rows3<const double> x) const {
  ContactDeck once = impl_->contact;
  once.rebalance = ContactDeck::Rebalance::never;
  const auto finder = make_contact_finder(impl_->seen(), impl_->share, once);
  return find_deepest_penetration(impl_->look_for_overlap(*finder), {x, x, 0});
}

}  // namespace percuss
