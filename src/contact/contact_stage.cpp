#include "src/contact/contact_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kernels/core/contract.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/contact_stage_impl.hpp"
#include "src/contact/history/contact_checkpoint.hpp"
#include "src/contact/overlap/part_gaps.hpp"
#include "src/error.hpp"

namespace percuss {

/// (1.7) Search for potential contacts, if the candidate pairs may have become too few. Returns whether it searched.
/// fastest: no node of this rank is faster in the motion; negative: not known.
bool ContactStage::Impl::search(const SurfaceMotion& motion, double fastest) {
  if (!has_pairs()) {
    approach.look_at_walls_alone(motion, fastest, enforcer.walls());
    return false;
  }
  const Phase phase("percuss::contact_search", clocks.search);
  bound.enter_step(motion);
  const bool is_near = bound.covers_near(motion);
  approach.clear();
  if (!is_near || approach.may_limit(bound.near_way(), motion.dt, enforcer.walls()))
    approach.look(motion, bound.find_way(motion), enforcer.walls());
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

/// One of a step may be made before its contact and one after it.
void ContactStage::Impl::count_search() {
  if (!is_step_counted) ++searches;
  is_step_counted = true;
}

/// Repeats, after a restart, the search that found the candidate pairs in use.
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

/// Finds what ranks know of each other's contact in this step. is_same becomes whether enforcement would repeat the
/// last step on every rank, without impulses, because all contacts are at rest. The second such step in a row computes
/// the history from that of the first, the third the same again.
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

/// The ties that have reached their strength. time: of the end of the step.
void ContactStage::Impl::judge_ties(double time, ContactReport& report) {
  report.failed_ties = breaking.count();
  if (!breaking.can_fail() || !report.enforced) return;
  reserve(tie_uses, static_cast<int>(ties.nodes.size()));
  enforcer.find_tie_uses(breaking.strengths(), tie_uses);
  report.failed_ties += breaking.judge(tie_uses, time);
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
void ContactStage::Impl::refuse_ties_held_apart(const ContactReport& report) const {
  constexpr double round_off = 1e-3;  // share of a face: conditions that move both alike differ by round-off
  if (!(report.held_apart > round_off)) return;
  throw RunError(
      fmt::format("conditions move tied node {} and its face apart (by {:.2g} of the face size): remove the condition "
                  "on one of them",
                  find_user_id(report.held_apart_node), report.held_apart));
}

/// A relaxation looks for rest, and the first step after it changes the stiffness of springs, which follows the step:
/// neither is energy that they give back. The next step begins with what Hooke's law holds.
void ContactStage::Impl::forget_spring_energy() {
  forgets_springs = is_relaxing;
  for (const Array<double>& held : {history.held, history.edges.held})
    if (held.extent(0) > 0) set_values(held, 0.0);
}

/// Discards results of the last step that say nothing about this one.
void ContactStage::Impl::forget_last_step() {
  last = {};
  touches_last = same_steps = 0;
}

ContactStage::ContactStage(const ChunkedMesh& chunked, const Deck& deck, const Communicator& ranks)
    : impl_(std::make_unique<Impl>(chunked, deck, ranks)) {}
ContactStage::~ContactStage() = default;

bool ContactStage::is_active() const { return impl_->is_active; }

bool ContactStage::wants_speeds() const { return impl_->has_walls && impl_->contact.reuse_search; }

const std::vector<std::string>& ContactStage::start_notes() const { return impl_->start_notes; }

TieMeasures ContactStage::measure_ties() const {
  return {find_tie_hinges(impl_->chunks, impl_->deck, impl_->ties_of_start, impl_->ranks),
          find_tie_sizes(impl_->chunks, impl_->ties_of_start, impl_->ranks)};
}

std::string ContactStage::prepare(Rows3<const double> x, Rows3<const double> v) {
  Impl& stage = *impl_;
  PERCUSS_EXPECT(!stage.is_begun);  // prepared, or loaded from a checkpoint
  stage.is_begun = true;
  // The finder of the run: its first step searches again, but the decomposition is made here and seen in the first
  // frame.
  const ContactDeck::Overlap overlap = stage.contact.overlap;
  StartOverlap& found = stage.start_overlap;
  if (stage.is_active) {
    stage.flush = find_flush_ties(stage.ranks, stage.share, stage.ties);
    found = seed_history(stage.look_for_overlap(*stage.finder), {x, v, 0}, stage.history);
  }
  found.crossings = stage.find_crossings(x);
  if (stage.has_pairs()) complete_gaps(find_tied_gaps(stage.ranks, stage.share, stage.ties), found);
  const std::string free = describe_crossings("crossing at the start, without contact: ", PartCrossing::Contact::never,
                                              found.crossings, stage.mesh);
  if (!free.empty()) stage.start_notes.push_back(free);
  if (const std::string gaps = describe_gaps(found.gaps, stage.mesh); !gaps.empty()) stage.start_notes.push_back(gaps);
  stage.decomposed_at_start = stage.finder->decomposition_clock();
  std::string line = stage.describe(found, "at the start");
  const std::string crossings = describe_refused_crossings(found.crossings, overlap, stage.mesh);
  const std::string& refused = overlap == ContactDeck::Overlap::refuse && crossings.empty() ? line : crossings;
  if (!refused.empty())
    throw InputError(fmt::format("{}: error: {}: move the parts apart, or set contact.overlap to accept{}",
                                 stage.deck.where(stage.deck.places.find("contact.overlap")), refused,
                                 crossings.empty() ? " or push_out" : ""));
  stage.overlap_at_start = found.nodes + found.edge_pairs;
  return line;
}

std::string ContactStage::describe_overlap_left(Rows3<const double> x) const {
  const Impl& stage = *impl_;
  if (stage.overlap_at_start == 0) return "";
  const auto finder = stage.make_look({});
  ContactHistory unused = make_history(stage.share, stage.walls, stage.contact);
  return percuss::describe_overlap_left(seed_history(stage.look_for_overlap(*finder), {x, x, 0}, unused));
}

const StartOverlap& ContactStage::start_overlap() const { return impl_->start_overlap; }

void ContactStage::watch_start(Rows3<const double> x, Rows3<const double> v, double dt) {
  impl_->approach.look_at_start(x, v, dt, impl_->enforcer.walls());
}

const Approach& ContactStage::approach() const { return impl_->approach.next(); }

void ContactStage::begin_relaxation() {
  impl_->is_relaxing = impl_->forgets_springs = true;
  impl_->breaking.hold(true);
  impl_->enforcer.hold_walls();
}

void ContactStage::end_relaxation(Rows3<const double> x) {
  Impl& stage = *impl_;
  stage.is_relaxing = false;
  stage.forget_last_step();
  stage.breaking.hold(false);
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
  if (stage.archive_active(archive)) restore_surface();
  if (stage.late.archive(archive, stage.active, stage.ties_of_start)) restore_surface();
  if (stage.breaking.archive(archive, stage.ties_of_start)) restore_surface();
  if (stage.folds.archive(archive, stage.share)) restore_surface();
  archive_history(archive, stage.chunks, stage.share, stage.walls, stage.contact, stage.history);
  archive_edges(archive, stage.chunks, stage.share, stage.history.edges);
  if (stage.ties.any())
    archive_ties(archive, stage.chunks, stage.tie_rows.keys(), stage.contact.ties_rotations(), stage.history);
  stage.bound.archive(archive, find_rows_of_nodes(stage.chunks, stage.share.nodes.numbers));
  stage.enforcer.archive(archive);
  stage.forces.archive(archive);
  if (stage.deck.output.writes("contact_pressure"))
    stage.enforcer.archive_pushes(archive, stage.chunks, stage.share.nodes);
  stage.archive_watch(archive);
  stage.approach.archive(archive);
  if (!archive.is_loading()) return;
  stage.is_begun = true;
  stage.forget_last_step();
  stage.search_again();
}

// (1.7), (1.8), (1.9), the last in Enforcer::enforce().
ContactReport ContactStage::apply(const ContactMotion& motion) {
  Impl& stage = *impl_;
  PERCUSS_EXPECT(stage.is_active && stage.is_begun);
  stage.enforcer.set_contact_velocities(motion);
  const SurfaceMotion checked{motion.x, motion.v, motion.dt};
  stage.is_step_counted = false;
  const bool is_speed_known = motion.fastest >= 0 && motion.fastest_before >= 0;
  const bool has_searched =
      stage.search(checked, is_speed_known ? std::max(motion.fastest, motion.fastest_before) : -1);
  if (has_searched) stage.count_search();
  const int num_touches = stage.check(checked);
  stage.enforcer.restore_predicted_velocities(motion);
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
  if (stage.forgets_springs) stage.forget_spring_energy();
  stage.enforcements += report.enforced ? 1 : 0;
  stage.judge_ties(motion.time + motion.dt, report);
  stage.last = report;
  stage.refuse_ties_held_apart(report);
  return report;
}

}  // namespace percuss
