#include "src/contact/enforcement/enforcer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/index_lists.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/ties/tie_rows.hpp"

namespace percuss {
namespace {

/// Shared nodes with their owners as the mesh numbers them.
SharedNodes find_copies(const ContactRanks& ranks) {
  UnstructuredExchange exchange(ranks.ranks);
  SharedNodes shared = find_shared_nodes(exchange, ranks.mesh.node_numbers);
  for (std::size_t n = 0; n < shared.owners.size(); ++n) {
    shared.owners[n] = ranks.numbering.find_node_owner(ranks.mesh.node_numbers[n]);
  }
  return shared;
}

/// Factor on the stiffness of springs between sheets. Softer springs rebound better, and let sheets sink in deeper.
constexpr double scale_of_sheets = 0.1;

/// Contact stiffness by mesh node, also of those that only walls stop.
Array<const double> find_springs(const Mesh& mesh, const SurfaceShare& share, const WallPairs& walls) {
  if (share.springs == SpringRows::none) return {};
  std::vector<double> springs(mesh.nodes.size(), 0);
  const auto node = to_host(walls.node);
  const auto spring = to_host(walls.spring);
  for (std::size_t p = 0; p < node.extent(0); ++p) springs[static_cast<std::size_t>(node(p))] = spring(p);
  for (std::size_t n = 0; n < share.nodes.mesh_nodes.size(); ++n)
    springs[static_cast<std::size_t>(share.nodes.mesh_nodes[n])] = share.nodes.springs[n];
  return to_view("contact::springs", springs);
}

/// RowInputs::depth_tolerance of a scene.
double find_depth_tolerance(const Mesh& mesh) {
  double farthest = 0;
  for (std::size_t d = 0; d < 3; ++d) farthest = std::max({farthest, std::abs(mesh.low[d]), std::abs(mesh.high[d])});
  return contact_limits::depth_tolerance * farthest;
}

}  // namespace

std::vector<std::string> name_contact_pairs(const Deck& deck) {
  std::vector<std::string> names;
  if (deck.contact.surfaces == ContactDeck::Surfaces::all) names.emplace_back("surfaces");
  const auto name = [](const Selector& surface) { return surface.name.empty() ? std::string("all") : surface.name; };
  for (const SurfacePairDeck& pair : deck.contact.pairs) names.push_back(name(pair.a) + ":" + name(pair.b));
  for (const TieDeck& tie : deck.contact.ties) names.push_back("tie:" + name(tie.a) + ":" + name(tie.b));
  if (!deck.walls.empty() && !names.empty()) names.emplace_back("walls");
  if (names.size() < 2) names.clear();
  return names;
}

Enforcer::Enforcer(const ContactRanks& ranks, const SurfaceShare& share, const WallPairs& walls,
                   const Array<const TieGeometry>& ties, const Deck& deck, ContactForces& forces)
    : walls_(walls),
      moving_walls_(deck, ranks.ranks),
      wall_sleep_(deck.contact.reuse_search),
      ties_(ties),
      node_numbers_(to_view("contact::mesh_node_numbers", ranks.mesh.node_numbers)),
      has_many_ranks_(ranks.ranks.size() > 1),
      is_first_rank_(ranks.ranks.rank() == 0),
      deck_(deck.contact),
      springs_(share.springs),
      exchange_(ranks),
      copied_(find_copies(ranks)),
      ties_rotations_(deck.contact.ties_rotations()),
      copies_(ranks.ranks, copied_, ties_rotations_ ? 3 : 2),
      depth_tolerance_(find_depth_tolerance(ranks.mesh)),
      forces_(forces),
      spring_(find_springs(ranks.mesh, share, walls)),
      pair_work_(deck.output.history_every ? name_contact_pairs(deck).size() : 0) {}

void Enforcer::redefine(const Mesh& mesh, const SurfaceShare& share, const WallPairs& walls,
                        const Array<const TieGeometry>& ties) {
  walls_ = walls;
  moving_walls_.place(walls_);
  wall_sleep_.wake();
  ties_ = ties;
  springs_ = share.springs;
  spring_ = find_springs(mesh, share, walls);
  remembers_ = true;
  system_.num_written = -1;
}

/// Only the nodes of the last step's rows and copies of others' can have impulses, if it is the same memory.
void Enforcer::list_pushed(const ContactMotion& motion) {
  num_pushed_ = 0;
  const Rows3<const double> impulse = motion.impulse;
  if (last_impulse_ != motion.impulse.data()) {
    reserve(pushed_, static_cast<int>(impulse.extent(0)));
    num_pushed_ = list_where(
        ExecSpace(), static_cast<int>(impulse.extent(0)),
        [impulse] KOKKOS_FUNCTION(int n) { return was_pushed(impulse, n); }, pushed_);
  } else if (was_pushed_) {
    const Array<const int> copies = copies_.copies(), own = system_.nodes;
    const int num_own = system_.num_nodes;
    num_pushed_ = num_own + static_cast<int>(copies.extent(0));
    reserve(pushed_, num_pushed_);
    const Array<int> pushed = pushed_;
    loop_where_it_pays(
        "contact::list_pushed", num_pushed_, num_pushed_ / 10,
        KOKKOS_LAMBDA(int i) { pushed(i) = i < num_own ? own(i) : copies(i - num_own); });
  }
}

void Enforcer::set_contact_velocities(const ContactMotion& motion) {
  list_pushed(motion);
  if (num_pushed_ == 0) return;
  reserve(predicted_, num_pushed_);
  const Array<const int> pushed = pushed_;
  const Rows3<double> v = motion.v, predicted = predicted_;
  const Rows3<const double> v_before = motion.v_before, impulse = motion.impulse;
  loop_where_it_pays(
      "contact::set_contact_velocities", num_pushed_, num_pushed_ / 10, KOKKOS_LAMBDA(int i) {
        const int n = pushed(i);
        store_row(predicted, i, load_row(v, n));
        if (was_pushed(impulse, n)) store_row(v, n, load_row(v_before, n));
      });
}

void Enforcer::restore_predicted_velocities(const ContactMotion& motion) {
  if (num_pushed_ == 0) return;
  const Array<const int> pushed = pushed_;
  const Rows3<double> v = motion.v;
  const Rows3<const double> predicted = predicted_;
  loop_where_it_pays(
      "contact::restore_predicted_velocities", num_pushed_, num_pushed_ / 10,
      KOKKOS_LAMBDA(int i) { store_row(v, pushed(i), load_row(predicted, i)); });
}

void Enforcer::clear_last_impulse(const ContactMotion& motion) {
  if (num_pushed_ > 0) {
    run_where_it_pays(num_pushed_ / 10,
                      [&](const auto& space) { clear_impulses(space, pushed_, num_pushed_, motion.impulse); });
  }
  num_pushed_ = 0;
  last_impulse_ = motion.impulse.data();
  was_pushed_ = false;
  restored_pushes_ = {};
}

/// Copies of nodes on other ranks get what their owners found, if rows touched nodes of these.
void Enforcer::update_copies(const ContactMotion& motion) {
  if (!has_many_ranks_) return;
  copies_.choose_sources([this](int rank) { return exchange_.is_touched(rank); });
  std::vector<Rows3<double>> corrected{motion.v, motion.impulse};
  if (ties_rotations_) corrected.push_back(motion.spins.spin);
  copies_.begin(ExecSpace(), std::vector<Rows3<const double>>(corrected.begin(), corrected.end()));
  copies_.end(ExecSpace(), corrected);
}

void Enforcer::hold_walls() {
  moving_walls_.hold(true);
  moving_walls_.place(walls_);
  wall_sleep_.wake();
}

void Enforcer::begin_anew() {
  moving_walls_.hold(false);
  wall_sleep_.wake();
  wall_sleep_.clear_counts();
  last_dt_ = 0;
  starts_loaded_ = true;
  std::fill(pair_work_.begin(), pair_work_.end(), PairWork{});
}

void Enforcer::archive(CheckpointArchive& archive) {
  if (archive.is_loading()) system_.num_written = -1;
  moving_walls_.archive(archive);
  if (archive.is_loading()) {
    moving_walls_.place(walls_);
    wall_sleep_.wake();
  }
  archive.number("contact/last_dt", last_dt_);
  archive.number("contact/last_pushes", last_pushes_);
  for (std::size_t p = 0; p < pair_work_.size(); ++p) {
    archive.sum(fmt::format("contact/pair_{}/normal_work", p), pair_work_[p].normal);
    archive.sum(fmt::format("contact/pair_{}/friction_work", p), pair_work_[p].friction);
  }
}

void Enforcer::rest(const ContactMotion& motion, ContactHistory& history) {
  clear_last_impulse(motion);
  has_solved_ = false;
  last_dt_ = motion.dt;
  last_pushes_ = 0;
  if (remembers_) set_values(history.face, std::int64_t{-1});
  history.edges.count = 0;
  remembers_ = false;
}

void Enforcer::repeat(const ContactMotion& motion) {
  clear_last_impulse(motion);
  has_solved_ = false;
  last_dt_ = motion.dt;
}

void Enforcer::find_tie_uses(const TieStrengths& strengths, const Array<double>& use) const {
  run_where_it_pays(system_.num_rows / 8, [&](const auto& space) {
    percuss::find_tie_uses(space, system_, strengths, last_dt_mean_, use);
    space.fence();
  });
}

SolveReport Enforcer::solve(const WorkSpace& space, double dt, double dt_mean) {
  const double scale = springs_ == SpringRows::all ? deck_.penalty_scale : scale_of_sheets;
  const SolveQuery query{dt, dt_mean, deck_.tolerance, scale, node_numbers_};
  if (springs_ != SpringRows::none) return solve_springs(space, query, system_, sums_, exchange_);
  if (deck_.enforcement == ContactDeck::Enforcement::lagrange)
    return solve_lagrange(space, query, system_, sums_, exchange_);
  return solve_kinematic(space, query, system_, sums_, exchange_);
}

void Enforcer::book_pairs(const WorkSpace& space) {
  for (std::size_t p = 0; p < pair_work_.size(); ++p) {
    pair_work_[p].merge(sum_pair_work(space, static_cast<int>(p), system_, sums_));
    pair_work_[p].normal.normalize();
    pair_work_[p].friction.normalize();
  }
}

/// The work of contact is what walls and bodies do to each other as the walls see it; the rest comes from outside, or
/// from the kinetic energy of walls with a mass.
void Enforcer::finish_walls(const WorkSpace& space, int first_row, const ContactMotion& motion, ContactReport& report) {
  const WallWork work = moving_walls_.finish_step(space, first_row, motion, report.converged, system_, sums_);
  moving_walls_.place(walls_);
  report.normal_work -= work.push;
  report.friction_work -= work.friction;
  if (!is_first_rank_) return;
  report.walls.work.add(work.driven);
  if (pair_work_.empty()) return;
  pair_work_.back().normal.add(-work.push);
  pair_work_.back().friction.add(-work.friction);
}

Traffic Enforcer::traffic() const {
  Traffic sum = exchange_.traffic();
  sum.messages += copies_.traffic().messages;
  sum.bytes += copies_.traffic().bytes;
  return sum;
}

RowInputs Enforcer::make_inputs(const ContactMotion& motion) const {
  const double restitution = deck_.find_restitution();
  return {{motion.x, motion.v, motion.dt},
          motion.v_before,
          motion.inverse_mass,
          node_numbers_,
          last_dt_ > 0 ? motion.dt / last_dt_ : 1,
          springs_,
          count_booked_surfaces(deck_) + static_cast<int>(deck_.ties.size()),
          depth_tolerance_,
          spring_,
          motion.growth,
          ties_,
          motion.impulse,
          last_pushes_ != 0,
          motion.bodies,
          ties_rotations_ ? motion.spins : SpinInputs{},
          springs_ == SpringRows::all || restitution > 0 ? restitution : -1};
}

WallWays Enforcer::find_wall_ways(const ContactMotion& motion) const {
  WallWays ways;
  if (motion.fastest >= 0)
    ways.next = motion.dt * (motion.fastest + moving_walls_.find_fastest(motion.time, motion.dt));
  if (motion.fastest_before >= 0) ways.last = last_dt_ * (motion.fastest_before + moving_walls_.find_fastest_before());
  return ways;
}

RowMeeting Enforcer::meet(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches,
                          bool is_same) {
  const RowInputs inputs = make_inputs(motion);
  exchange_.find_foreign_nodes(touches, num_touches, system_);
  if (walls_.count() > 0) wall_sleep_.enter_step(find_wall_ways(motion), motion.x, walls_);
  run_where_it_pays(num_touches + walls_.count_looked_at() / 8, [&](const auto& space) {
    moving_walls_.start_step(space, walls_, inputs, motion.time, sums_);
    count_rows(space, inputs, {touches, num_touches, walls_}, system_);
    space.fence();
  });
  meeting_ = exchange_.meet(system_, is_same, motion.bodies.count > 0);
  return meeting_;
}

/// What all ranks did.
void Enforcer::report_outcome(const WorkSpace& space, const ContactMotion& motion, int num_touches,
                              const SolveReport& solved, ContactReport& report) {
  RowOutcome outcome;
  if (has_solved_)
    outcome = {sum_outcome(space, motion.dt, system_, sums_), solved.iterations, solved.converged ? 0 : 1,
               solved.complementarity};
  exchange_.reduce(outcome);
  EnforcementSums& done = outcome.sums;
  report.enforced = true;
  report.iterations = static_cast<int>(outcome.iterations);
  report.converged = outcome.failures == 0;
  report.complementarity = outcome.complementarity;
  report.interactions = static_cast<int>(done.pushes);
  last_pushes_ = done.pushes;
  report.normal_work = done.normal_work.round();
  report.friction_work = done.friction_work.round();
  report.stored = done.stored.round();
  report.stored_slip = done.stored_slip.round();
  report.rate = done.rate;
  if (system_.num_rows > num_touches)
    report.walls = sum_wall_impulses(space, num_touches, motion.x, motion.center, system_, sums_);
  report.bodies = system_.bodies.wrench;
  report.residual = done.residual;
  report.deepest = done.deepest;
  report.deepest_node = done.deepest_key < 0 ? -1 : find_key_node(done.deepest_key);
  report.giving_node = done.given_key < 0 ? -1 : find_key_node(done.given_key);
  report.held_apart = done.held_apart;
  report.held_apart_node = done.held_apart_key < 0 ? -1 : find_key_node(done.held_apart_key);
}

void Enforcer::enforce(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches,
                       ContactHistory& history, ContactReport& report) {
  const RowInputs inputs = make_inputs(motion);
  // The first step goes from time 0 to its middle. Springs that begin without a force stop what it brings in all of it.
  const bool halves_first = last_dt_ > 0 || starts_loaded_;
  const double dt_mean = halves_first ? 0.5 * (last_dt_ + motion.dt) : motion.dt;
  starts_loaded_ = false;
  last_dt_ = motion.dt;
  last_dt_mean_ = dt_mean;
  last_pushes_ = 0;
  remembers_ = true;
  exchange_.announce_foreign_nodes(system_);
  // A row's solution costs some dozen passes; a wall's pair that is out of reach costs one look.
  run_where_it_pays(num_touches + walls_.count_looked_at() / 8, [&](const auto& space) {
    if (exchange_.takes_part(system_))
      build_rows(space, inputs, {touches, num_touches, walls_}, history, system_, exchange_);
    else
      system_.num_nodes = 0;
    clear_last_impulse(motion);
    if (ties_rotations_) set_values(space, motion.spins.moment, 0.0);
    const SolveReport solved = solve(space, motion.dt, dt_mean);
    has_solved_ = solved.rows > 0;
    if (has_solved_) {
      apply_impulses(space, system_, motion.v, motion.impulse);
      if (ties_rotations_) apply_moments(space, system_, motion.spins);
    }
    if (meeting_.any_rows) {
      report_outcome(space, motion, num_touches, solved, report);
      book_pairs(space);
      forces_.book(space, {system_, node_numbers_, exchange_, motion.x, motion.dt});
      update_copies(motion);
      was_pushed_ = true;
    }
    if (moving_walls_.any()) finish_walls(space, meeting_.any_rows ? num_touches : system_.num_rows, motion, report);
    write_history(space, motion.dt, system_, history);
    space.fence();
  });
}

}  // namespace percuss
