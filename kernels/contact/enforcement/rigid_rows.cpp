#include "kernels/contact/enforcement/rigid_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "kernels/contact/enforcement/anderson.hpp"
#include "kernels/contact/enforcement/cone_row.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Wrench add(const Wrench& a, const Wrench& b) { return {a.impulse + b.impulse, a.moment + b.moment}; }

/// Power of a unit impulse whose wrench is w: what it sees of a body's velocity.
double see(const Wrench& w, const BodyChange& u) { return dot(w.impulse, u.velocity) + dot(w.moment, u.spin); }

/// A row within its island.
struct IslandRow {
  const RigidRow* row = nullptr;
  int count = 1;                                 // directions
  int body[RigidRow::most_bodies] = {-1, -1};    // of the island
  BodyChange reply[3][RigidRow::most_bodies]{};  // to the unit impulses
  double normal = 0, tangential = 0;             // diagonal of the push; larger eigenvalue of the block of the tangents
  double t11 = 0, t12 = 0, t21 = 0, t22 = 0;     // that block
  double b[3] = {0, 0, 0};                       // velocities to be closed
  double p[3] = {0, 0, 0};                       // impulses
  RowStatus status = is_apart;

  /// Whether the row does something else than at the last call.
  bool update_status() {
    constexpr double inside = 1 - 1e-9;  // share of Coulomb's limit below which friction was not shortened
    const double limit = inside * row->friction * p[0], square = p[1] * p[1] + p[2] * p[2];
    const RowStatus last = status;
    status = !(p[0] > 0) ? is_apart : count == 1 || square < limit * limit ? sticks : slides;
    return status != last;
  }

  const Wrench& seen(int d, int k) const { return d == 0 ? row->gap[k] : row->push[d][k]; }

  /// A of two directions of the row.
  double couple(int d, int of) const {
    double a = 0;
    for (int k = 0; k < RigidRow::most_bodies; ++k)
      if (body[k] >= 0) a += see(seen(d, k), reply[of][k]);
    return a;
  }
};

/// The rows of an island, by key, and the velocities that their impulses give its bodies.
class Island {
 public:
  Island(const std::vector<const RigidRow*>& rows, const std::vector<BodyResponse>& responses, double dt) {
    for (const RigidRow* row : rows)
      for (const int body : row->body)
        if (body >= 0) bodies_.push_back(body);
    std::sort(bodies_.begin(), bodies_.end());
    bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
    velocity_.resize(bodies_.size());
    rows_.reserve(rows.size());
    for (const RigidRow* row : rows) rows_.push_back(make_row(*row, responses, dt));
    for (IslandRow& row : rows_)
      for (int d = 0; d < row.count; ++d) push(row, d, row.p[d]);
  }

  /// Meets the rows until none changes by more than `enough` [velocity], or until sweeps no longer change what the rows
  /// see of the bodies: sticking rows of one body may demand displacements that no motion of the body has, and push
  /// against each other without end. `accepted` [velocity] takes the place of `enough` after patient_sweeps.
  RigidReport solve(double enough, double accepted) {
    constexpr int max_sweeps = 1000, plain_sweeps = 8, accelerated_sweeps = 300;  // after these plain ones again
    constexpr int patient_sweeps = accelerated_sweeps;
    RigidReport report;
    double last_move = std::numeric_limits<double>::infinity();
    while (report.sweeps < max_sweeps) {
      const bool is_accelerated = report.sweeps >= plain_sweeps && report.sweeps < accelerated_sweeps;
      if (is_accelerated) prepare_window();
      ++report.sweeps;
      double most = 0;
      for (IslandRow& row : rows_) most = std::max(most, meet(row));
      const double wanted = report.sweeps < patient_sweeps ? enough : accepted;
      if (most <= wanted || note_velocities() <= wanted) return report;
      ++report.sweeps;
      for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) meet(*row);
      if (is_accelerated) last_move = accelerate(last_move);
    }
    report.converged = 0;
    return report;
  }

  void get(std::size_t i, RowImpulse& impulse) const {
    const double* p = rows_[i].p;
    impulse = {p[0], {p[1], p[2]}};
  }

 private:
  IslandRow make_row(const RigidRow& row, const std::vector<BodyResponse>& responses, double dt) const {
    IslandRow r;
    r.row = &row;
    r.count = row.friction > 0 ? 3 : 1;
    for (int k = 0; k < RigidRow::most_bodies; ++k) {
      if (row.body[k] < 0) continue;
      r.body[k] = static_cast<int>(std::lower_bound(bodies_.begin(), bodies_.end(), row.body[k]) - bodies_.begin());
      for (int d = 0; d < r.count; ++d) r.reply[d][k] = find_change(responses[at(row.body[k])], row.push[d][k]);
    }
    r.normal = r.couple(0, 0);
    r.b[0] = row.missing / dt;
    r.p[0] = row.guess.normal;
    if (r.count == 1) return r;
    r.t11 = r.couple(1, 1);
    r.t12 = r.couple(1, 2);
    r.t21 = r.couple(2, 1);
    r.t22 = r.couple(2, 2);
    const double half = 0.5 * (r.t11 - r.t22), off = 0.5 * (r.t12 + r.t21);
    r.tangential = 0.5 * (r.t11 + r.t22) + std::sqrt(half * half + off * off);
    for (int d = 1; d < 3; ++d) {
      r.b[d] = row.slide[d - 1] / dt;
      r.p[d] = row.guess.tangential[d - 1];
    }
    return r;
  }

  double find_velocity(const IslandRow& row, int d) const {
    double w = row.b[d];
    for (int k = 0; k < RigidRow::most_bodies; ++k)
      if (row.body[k] >= 0) w += see(row.seen(d, k), velocity_[at(row.body[k])]);
    return w;
  }

  void push(const IslandRow& row, int d, double impulse) {
    if (impulse == 0) return;
    for (int k = 0; k < RigidRow::most_bodies; ++k) {
      if (row.body[k] < 0) continue;
      BodyChange& u = velocity_[at(row.body[k])];
      u.velocity = u.velocity + impulse * row.reply[d][k].velocity;
      u.spin = u.spin + impulse * row.reply[d][k].spin;
    }
  }

  /// Meets the conditions of a row; returns its largest change as a velocity.
  double meet(IslandRow& row) {
    if (!(row.normal > 0)) return 0;
    const double wanted = row.p[0] - find_velocity(row, 0) / row.normal, p = wanted > 0 ? wanted : 0;
    const double change = p - row.p[0], most = std::fabs(change) * row.normal;
    push(row, 0, change);
    row.p[0] = p;
    return row.count == 1 ? most : std::max(most, meet_friction(row));
  }

  /// The largest change of what the rows see of the bodies since the last call; infinite in the first.
  double note_velocities() {
    double most = seen_.empty() ? std::numeric_limits<double>::infinity() : 0;
    seen_.resize(3 * rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (int d = 0; d < rows_[i].count; ++d) {
        double& last = seen_[3 * i + at(d)];
        const double now = find_velocity(rows_[i], d);
        most = std::max(most, std::fabs(now - last));
        last = now;
      }
    }
    return most;
  }

  /// The friction that stops sliding, if Coulomb's limit allows; else the projected step, whose fixed points slide
  /// against the velocity.
  double meet_friction(IslandRow& row) {
    constexpr double singular = 1e-10;  // share of the square of the eigenvalue: one direction is held
    const double limit = row.row->friction * row.p[0];
    double t[2] = {0, 0};
    if (limit > 0 && row.tangential > 0) {
      const double w1 = find_velocity(row, 1), w2 = find_velocity(row, 2);
      const double determinant = row.t11 * row.t22 - row.t12 * row.t21;
      const bool is_regular = determinant > singular * row.tangential * row.tangential;
      if (is_regular) {
        t[0] = row.p[1] - (row.t22 * w1 - row.t12 * w2) / determinant;
        t[1] = row.p[2] - (row.t11 * w2 - row.t21 * w1) / determinant;
      }
      if (!is_regular || t[0] * t[0] + t[1] * t[1] > limit * limit) {
        t[0] = row.p[1] - w1 / row.tangential;
        t[1] = row.p[2] - w2 / row.tangential;
        project_on_disc(limit, t[0], t[1]);
      }
    }
    const double change[2] = {t[0] - row.p[1], t[1] - row.p[2]};
    for (int d = 1; d < 3; ++d) {
      push(row, d, change[d - 1]);
      row.p[d] = t[d - 1];
    }
    return std::sqrt(change[0] * change[0] + change[1] * change[1]) * row.tangential;
  }

  /// The impulses of all rows as one vector on the host.
  void store(const HostMirror<Array<double>>& p) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) p(3 * i + d) = rows_[i].p[d];
  }

  /// The size of impulses, by what they change of their own rows.
  double find_size(const HostMirror<Array<double>>& p) const {
    double square = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d)
        square += (d == 0 ? rows_[i].normal : rows_[i].tangential) * p(3 * i + d) * p(3 * i + d);
    return std::sqrt(square);
  }

  /// Notes where the sweeps begin.
  void prepare_window() {
    const std::size_t n = 3 * rows_.size();
    if (!window_) {
      std::vector<double> weight;
      for (const IslandRow& row : rows_) weight.insert(weight.end(), {row.normal, row.tangential, row.tangential});
      window_.emplace(static_cast<int>(n), to_view("contact::rigid_weight", weight));
      before_ = Array<double>("contact::rigid_before", n);
      after_ = Array<double>("contact::rigid_after", n);
      on_host_ = Kokkos::create_mirror_view(after_);
    }
    store(on_host_);
    copy_values(before_, on_host_);
  }

  /// Goes from the end of the sweeps to the accelerated point, unless a row does something else than before or they
  /// move by more than too_far times `last_move`. Returns by how much they move.
  double accelerate(double last_move) {
    constexpr double too_far = 2;
    bool has_changed = false;
    for (IslandRow& row : rows_) has_changed = row.update_status() || has_changed;
    if (has_changed) window_->clear();
    store(on_host_);
    copy_values(after_, on_host_);
    const double swept = find_size(on_host_), move = window_->accelerate(before_, after_);
    copy_values(on_host_, after_);
    // Where rows depend on each other there are impulses that change no velocity: nothing else holds them.
    if (move > too_far * last_move || !(find_size(on_host_) <= too_far * swept)) {
      window_->clear();
      return move;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) go_to(&on_host_(3 * i), rows_[i]);
    return move;
  }

  /// Gives a row impulses, as far as they are within its cone.
  void go_to(const double* impulses, IslandRow& row) {
    double p[3] = {std::max(0.0, impulses[0]), impulses[1], impulses[2]};
    project_on_disc(row.row->friction * p[0], p[1], p[2]);
    for (int d = 0; d < row.count; ++d) {
      push(row, d, p[d] - row.p[d]);
      row.p[d] = p[d];
    }
  }

  std::vector<int> bodies_;  // ascending
  std::vector<BodyChange> velocity_;
  std::vector<IslandRow> rows_;
  std::vector<double> seen_;  // [3 rows] velocities at the end of the last sweep forth
  std::optional<AndersonWindow> window_;
  Array<double> before_, after_;  // [3 rows] the sweeps
  HostMirror<Array<double>> on_host_;
};

/// The lowest body of the island of each, as rows join them.
class BodyIslands {
 public:
  explicit BodyIslands(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int body) {
    while (parent_[at(body)] != body) body = parent_[at(body)] = parent_[at(parent_[at(body)])];
    return body;
  }
  void join(int a, int b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parent_[at(high)] = low;
  }

 private:
  std::vector<int> parent_;
};

/// Solves the island that has these rows, in their order; adds to the report.
void solve_island(const std::vector<RigidRow>& rows, std::span<const int> members,
                  const std::vector<BodyResponse>& responses, const RigidQuery& query,
                  std::vector<RigidImpulse>& impulses, RigidReport& report) {
  std::vector<const RigidRow*> chosen;
  double deepest = 0, smallest = std::numeric_limits<double>::infinity();
  bool is_asked = false;
  for (const int r : members) {
    const RigidRow& row = rows[at(r)];
    chosen.push_back(&row);
    deepest = std::max(deepest, -row.missing);
    smallest = std::min(smallest, row.size);
    is_asked = is_asked || row.missing < 0 || row.guess.normal > 0;
    impulses[at(r)].is_solved = 1;
  }
  if (!is_asked) return;  // no impulse is the solution
  Island island(chosen, responses, query.dt);
  const double least = query.least * smallest;
  const RigidReport solved = island.solve(std::max(query.tolerance * deepest, least) / query.dt,
                                          std::max(query.accepted * deepest, least) / query.dt);
  report.sweeps = std::max(report.sweeps, solved.sweeps);
  report.converged = std::min(report.converged, solved.converged);
  for (std::size_t i = 0; i < members.size(); ++i) island.get(i, impulses[at(members[i])].impulse);
}

/// The rigid bodies that a row touches.
struct TouchedBodies {
  int body[row_nodes] = {-1, -1, -1, -1, -1};
  int count = 0;
  bool has_others = false;  // nodes that are of none

  int find(int wanted) const { return static_cast<int>(std::find(body, body + count, wanted) - body); }
  void add(int touched) {
    if (touched < 0)
      has_others = true;
    else if (find(touched) == count)
      body[count++] = touched;
  }
};

/// The places of rows that are of bodies.
template <class OfPlace, class Rows>
struct BodyPlaces {
  OfPlace of_place;
  Rows x;
  const std::vector<BodyResponse>& responses;

  /// Adds a unit impulse along d to the wrenches of the bodies that a row touches.
  void add_wrenches(const ContactRow& row, const Point3& d, const TouchedBodies& bodies, Wrench* sums) const {
    const Point3 couple = find_couple(row, d);
    for (int slot = 0; slot < count_nodes(row); ++slot) {
      const int body = of_place(row.place[slot]);
      const Point3 arm = load_row(x, row.place[slot]) - responses[at(body)].center;
      Wrench& sum = sums[bodies.find(body)];
      sum = add(sum, find_wrench(arm, spread_impulse(row, slot, d, couple)));
    }
  }

  RigidRow make_row(const ContactRow& row, const TouchedBodies& bodies) const {
    RigidRow rigid;
    rigid.key = row.key;
    std::copy(bodies.body, bodies.body + bodies.count, rigid.body);
    for (int d = 0; d < count_directions(row); ++d) add_wrenches(row, get_direction(row, d), bodies, rigid.push[d]);
    add_wrenches(row, row.gap_gradient, bodies, rigid.gap);
    rigid.missing = row.gap - row.target;
    std::copy(row.slide, row.slide + 2, rigid.slide);
    rigid.friction = row.friction;
    rigid.size = row.size;
    rigid.guess = row.impulse;
    return rigid;
  }
};

}  // namespace

RigidReport solve_rigid_rows(const std::vector<RigidRow>& rows, const std::vector<int>& others,
                             const std::vector<BodyResponse>& responses, const RigidQuery& query,
                             std::vector<RigidImpulse>& impulses) {
  const std::size_t num_bodies = others.size() - 2;
  BodyIslands islands(num_bodies);
  for (const RigidRow& row : rows)
    if (row.body[1] >= 0) islands.join(row.body[0], row.body[1]);
  std::vector<char> is_shared(num_bodies, 0);
  for (std::size_t b = 0; b < num_bodies; ++b)
    if (others[b] > 0) is_shared[at(islands.find(static_cast<int>(b)))] = 1;
  std::vector<int> order(rows.size()), island(rows.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t r = 0; r < rows.size(); ++r) island[r] = islands.find(rows[r].body[0]);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return island[at(a)] != island[at(b)] ? island[at(a)] < island[at(b)] : rows[at(a)].key < rows[at(b)].key;
  });
  impulses.assign(rows.size(), {});
  RigidReport report;
  report.rows = others.back();
  bool is_all = others[num_bodies] == 0;
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    const int root = island[at(order[first])];
    while (last < order.size() && island[at(order[last])] == root) ++last;
    if (is_shared[at(root)] != 0)
      is_all = false;
    else
      solve_island(rows, std::span(order).subspan(first, last - first), responses, query, impulses, report);
  }
  report.is_all = is_all ? 1 : 0;
  return report;
}

RigidRowList list_rigid_rows(const RowSystem& system) {
  const auto rows = to_host(system.rows);
  const auto of_place = to_host(system.bodies.of_place);
  const auto x = to_host(system.at.x);
  const auto responses = to_host(system.bodies.inputs.responses);
  RigidRowList list;
  const std::size_t num_bodies = at(system.bodies.count());
  list.responses.assign(responses.data(), responses.data() + num_bodies);
  const BodyPlaces<decltype(of_place), decltype(x)> places{of_place, x, list.responses};
  list.others.assign(num_bodies + 2, 0);
  list.others.back() = system.num_rows;
  for (int r = 0; r < system.num_rows; ++r) {
    const ContactRow& row = rows(r);
    if (row.is_held) continue;
    TouchedBodies bodies;
    for (int slot = 0; slot < count_nodes(row); ++slot) bodies.add(of_place(row.place[slot]));
    if (is_tie(row) || row.spring > 0 || bodies.has_others || bodies.count > RigidRow::most_bodies) {
      for (int k = 0; k < bodies.count; ++k) ++list.others[at(bodies.body[k])];
      if (!(row.spring > 0)) ++list.others[num_bodies];
      continue;
    }
    list.rows.push_back(places.make_row(row, bodies));
    list.index.push_back(r);
  }
  return list;
}

void set_rigid_impulses(const WorkSpace& space, const RigidRowList& list, const std::vector<RigidImpulse>& impulses,
                        const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const Array<const int> index = to_view("contact::rigid_rows", list.index);
  const Array<const RigidImpulse> values = to_view("contact::rigid_impulses", impulses);
  parallel_for(
      "contact::set_rigid_impulses", RangeOf(space, 0, static_cast<int>(impulses.size())), KOKKOS_LAMBDA(int i) {
        if (values(i).is_solved == 0) return;
        ContactRow& row = rows(index(i));
        row.is_solved = true;
        set_impulse(row, values(i).impulse);
      });
  space.fence();
}

}  // namespace percuss
