#include "src/step/springs/weld_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {
namespace {

/// Welds that share nodes are solved in turn, again and again, until impulses and moments change by no more than this
/// share of the largest, or of what moves at the weld: its velocities have this round-off.
constexpr double settled_share = 1e-13, velocity_round_off = 1e-14;
constexpr int most_turns = 500;

/// The share that may be left after so many turns without a warning.
constexpr double tolerated_share = 1e-6;

Vector3<double> turn_normal(const Vector3<double>& a, const Vector3<double>& w, double dt) {
  const Vector3<double> turned = a + dt * cross(w, a);
  return (1 / norm(turned)) * turned;
}

void add(const WeldImpulse& more, WeldImpulse& sum) {
  sum.impulse = sum.impulse + more.impulse;
  for (std::size_t i = 0; i < 2; ++i) sum.moment[i] = sum.moment[i] + more.moment[i];
}

}  // namespace

WeldStage::WeldStage(const Model& model)
    : model_(model),
      rows_(model, model.welds),
      nodes_(model.welds.nodes.size()),
      on_nodes_(model.welds.nodes.size()),
      sums_(model.welds.welds.size()) {}

void WeldStage::gather(const State& state) {
  rows_.gather(state);
  std::vector<double> masses(nodes_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const auto vector = [&](std::size_t what) { return rows_.vector(n, what); };
    masses[n] = rows_.value(n, NodeRow::mass);
    nodes_[n] = {vector(NodeRow::place),
                 vector(NodeRow::velocity),
                 vector(NodeRow::spin),
                 vector(NodeRow::inverse_mass),
                 vector(NodeRow::inverse_inertia),
                 rows_.value(n, NodeRow::inertia) > 0,
                 !(masses[n] > 0)};
  }
  patches_.clear();
  for (const WeldPatch& patch : model_.welds.patches) patches_.emplace_back(patch, nodes_, masses);
}

/// As bodies: nodes, or where both ends have patches that turn, these.
std::array<WeldNode, 2> WeldStage::find_ends(const Weld& weld) const {
  const auto find_patch = [&](std::size_t e) -> const MovingPatch& { return patches_[at(weld.patch[e])]; };
  if (weld.has_regions()) return {find_patch(0).find_end(nodes_), find_patch(1).find_end(nodes_)};
  const std::array<WeldNode, 2> ends{nodes_[at(weld.end[0])], nodes_[at(weld.end[1])]};
  if (weld.patch[0] < 0 || !find_patch(0).turns() || !find_patch(1).turns()) return ends;
  return {find_patch(0).find_end(nodes_, ends[0].place), find_patch(1).find_end(nodes_, ends[1].place)};
}

/// Makes the ends of a weld move as one. impulse, ends: out.
void WeldStage::join_one(std::size_t index, double dt, WeldImpulse& impulse, std::array<WeldNode, 2>& ends) {
  const Weld& weld = model_.welds.welds[index];
  ends = find_ends(weld);
  impulse = join_nodes(ends, weld.length, dt);
  for (std::size_t e = 0; e < 2; ++e) {
    const Vector3<double> own = (e == 0 ? -1.0 : 1.0) * impulse.impulse;
    if (ends[e].is_patch) {
      patches_[at(weld.patch[e])].give(own, impulse.moment[e], nodes_, on_nodes_);
      continue;
    }
    nodes_[at(weld.end[e])] = ends[e];
    NodeImpulse& sum = on_nodes_[at(weld.end[e])];
    sum.impulse = sum.impulse + own;
    sum.moment = sum.moment + impulse.moment[e];
  }
}

/// Every weld once. Returns the largest change as a share of the largest impulse.
double WeldStage::solve_once(const State& state, double dt) {
  double largest = 0, change = 0;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (state.welds[i].is_broken != 0) continue;
    WeldImpulse impulse;
    std::array<WeldNode, 2> ends;
    join_one(i, dt, impulse, ends);
    add(impulse, sums_[i]);
    largest = std::max(largest, find_impulse_size(sums_[i], ends));
    const double size = find_impulse_size(impulse, ends);
    if (size <= change || size <= velocity_round_off * find_motion_size(ends)) continue;
    change = size;
    slowest_ = i;
  }
  return change > 0 ? change / largest : 0;
}

/// Returns the share of the last turn; 0 of welds that need but one.
double WeldStage::solve(const State& state, double dt) {
  std::fill(sums_.begin(), sums_.end(), WeldImpulse{});
  std::fill(on_nodes_.begin(), on_nodes_.end(), NodeImpulse{});
  double share = solve_once(state, dt);
  if (!model_.welds.shares_nodes) return 0;
  for (int turn = 1; turn < most_turns && share > settled_share; ++turn) share = solve_once(state, dt);
  return share;
}

void WeldStage::warn_of_unsettled(double time) {
  const WeldLaw& law = model_.welds.laws[at(model_.welds.welds[slowest_].law)];
  warnings_.push_back(
      {"unsettled_welds",
       fmt::format("welds of '{}' leave a part of the motion of their nodes to later steps (each node of "
                   "a long chain is welded to the next): weld all of them to one node",
                   law.name),
       law.place, time, 1});
}

/// Normal at n+1. That of regions rotates with the first.
Vector3<double> WeldStage::find_new_normal(const Weld& weld, const Vector3<double>& normal, double dt) const {
  if (weld.has_regions()) return turn_normal(normal, patches_[at(weld.patch[0])].find_end(nodes_).spin, dt);
  const WeldNode &a = nodes_[at(weld.end[0])], &b = nodes_[at(weld.end[1])];
  if (weld.is_normal_its_line) {
    const Vector3<double> across = b.place - a.place + dt * (b.velocity - a.velocity);
    const double length = norm(across);
    return length > 0 ? (1 / length) * across : normal;  // held nodes may meet
  }
  return a.turns || b.turns ? turn_normal(normal, a.turns ? a.spin : b.spin, dt) : normal;
}

/// Forces, new normals, and which welds have reached their strength or their time.
void WeldStage::judge(State& state, double dt, double dt_mean) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    WeldState& now = state.welds[i];
    if (now.is_broken != 0) {
      now.pull = now.shear = 0;
      continue;
    }
    const Weld& weld = model_.welds.welds[i];
    const WeldLaw& law = model_.welds.laws[at(weld.law)];
    const Vector3<double> force = (-1 / dt_mean) * sums_[i].impulse;
    now.pull = dot(force, now.normal);
    now.shear = norm(force - now.pull * now.normal);
    const double reached = find_strength_use(law.strength, std::abs(now.pull), now.shear);
    now.normal = find_new_normal(weld, now.normal, dt);
    if (reached < 1 && state.time + dt < law.time) continue;
    now.is_broken = 1;
    warnings_.push_back({"weld_failure",
                         fmt::format("welds of '{}' fail (their force or their time has reached the limit in failure): "
                                     "history.csv has the forces of each",
                                     law.name),
                         law.place, state.time + dt, 1});
  }
}

/// Work of impulses with the mean of the velocities before and after the step.
double WeldStage::find_work() const {
  double work = 0;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const NodeImpulse& on = on_nodes_[n];
    work += 0.5 * dot(on.impulse, rows_.vector(n, NodeRow::velocity_before) + nodes_[n].velocity);
    if (nodes_[n].turns) work += 0.5 * dot(on.moment, rows_.vector(n, NodeRow::spin_before) + nodes_[n].spin);
  }
  return work;
}

/// Contact has counted its work with the velocities that welds then changed.
double WeldStage::find_work_of_contact() const {
  double work = 0;
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    work += 0.5 * dot(rows_.vector(n, NodeRow::contact), nodes_[n].velocity - rows_.vector(n, NodeRow::velocity));
  return work;
}

void WeldStage::give_back(const State& state) const {
  const std::size_t count = model_.welds.local_node.extent(0);
  Kokkos::View<double**, Kokkos::LayoutRight, MemSpace> rows("percuss::welded_rows", count, 12);
  const auto host = Kokkos::create_mirror_view(rows);
  const auto places = to_host(model_.welds.local_place);
  for (std::size_t i = 0; i < count; ++i) {
    const WeldNode& node = nodes_[at(places(i))];
    const NodeImpulse& on = on_nodes_[at(places(i))];
    const Vector3<double> values[] = {node.velocity, node.spin, on.impulse, on.moment};
    for (std::size_t k = 0; k < 4; ++k) {
      host(i, 3 * k) = values[k].x;
      host(i, 3 * k + 1) = values[k].y;
      host(i, 3 * k + 2) = values[k].z;
    }
  }
  copy_values(rows, host);
  const auto v = state.v, w = state.w, impulse = state.weld_impulse, moment = state.weld_moment;
  const auto nodes = model_.welds.local_node;
  const bool turns = model_.has_rotations;
  parallel_for(
      "percuss::set_welded_nodes", RangeOf(ExecSpace(), 0, static_cast<int>(count)), KOKKOS_LAMBDA(const int i) {
        const int n = nodes(i);
        for (int k = 0; k < 3; ++k) {
          v(n, k) = rows(i, k);
          if (turns) w(n, k) = rows(i, 3 + k);
          impulse(n, k) = rows(i, 6 + k);
          moment(n, k) = rows(i, 9 + k);
        }
      });
}

void WeldStage::follow_contact(State& state, const StepTimes& times, const ContactReport* /*contact*/) {
  gather(state);
  if (solve(state, times.dt) > tolerated_share) warn_of_unsettled(state.time + times.dt);
  state.books.weld_work += find_work();
  state.books.contact_work += find_work_of_contact();
  judge(state, times.dt, times.dt_mean);
  give_back(state);
}

/// Whether a node of its ends or regions has vanished.
bool WeldStage::has_lost_nodes(const Weld& weld) const {
  const auto is_gone = [&](int n) { return nodes_[at(n)].is_gone; };
  if (!weld.has_regions()) return is_gone(weld.end[0]) || is_gone(weld.end[1]);
  return std::any_of(weld.patch.begin(), weld.patch.end(), [&](int patch) {
    const std::vector<int>& nodes = model_.welds.patches[at(patch)].nodes;
    return std::any_of(nodes.begin(), nodes.end(), is_gone);
  });
}

void WeldStage::drop_vanished(State& state) {
  gather(state);
  for (std::size_t i = 0; i < state.welds.size(); ++i) {
    WeldState& now = state.welds[i];
    if (now.is_broken != 0 || !has_lost_nodes(model_.welds.welds[i])) continue;
    now.is_broken = 1;
    now.pull = now.shear = 0;
  }
}

void WeldStage::archive(CheckpointArchive& archive, State& state) {
  archive.each("welds", state.welds, [](WeldState& w, const auto& take) {
    take(w.normal.x, w.normal.y, w.normal.z, w.pull, w.shear, w.is_broken);
  });
  archive.number("books/weld_work", state.books.weld_work);
}

std::vector<Warning> WeldStage::take_warnings() {
  std::vector<Warning> taken;
  taken.swap(warnings_);
  return taken;
}

std::vector<HistoryColumn> WeldStage::list_columns() const {
  std::vector<HistoryColumn> columns = {
      {"weld_work", dimensions::energy, "work of welds on their nodes, taken from the viscous energy"},
      {"welds_failed", {}, "number of welds that have failed"}};
  for (const Weld& weld : model_.welds.welds) {
    if (!weld.has_columns) continue;
    columns.push_back({"weld_normal:" + weld.name, dimensions::force,
                       fmt::format("force of weld '{}' along its normal, positive in tension", weld.name)});
    columns.push_back({"weld_shear:" + weld.name, dimensions::force,
                       fmt::format("magnitude of the force of weld '{}' across its normal", weld.name)});
  }
  return columns;
}

void WeldStage::append_values(const State& state, std::vector<double>& row) {
  row.push_back(state.books.weld_work);
  row.push_back(static_cast<double>(std::count_if(state.welds.begin(), state.welds.end(),
                                                  [](const WeldState& weld) { return weld.is_broken != 0; })));
  for (std::size_t i = 0; i < state.welds.size(); ++i) {
    if (!model_.welds.welds[i].has_columns) continue;
    row.push_back(state.welds[i].pull);
    row.push_back(state.welds[i].shear);
  }
}

}  // namespace percuss
