#include "src/step/rigid/joint_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "src/index.hpp"
#include "src/step/rigid/rigid_step.hpp"

namespace percuss {
namespace {

/// Share of the gap at n, which is round-off, that a step closes: all of it at once would shake the bodies.
constexpr double closing = 0.1;

/// Number of the chain of each joint: joints of one body belong together.
std::vector<int> number_chains(const RigidModel& rigid) {
  std::vector<int> chain_of_body(rigid.bodies.size());
  std::iota(chain_of_body.begin(), chain_of_body.end(), 0);
  const auto merge = [&](int a, int b) { std::replace(chain_of_body.begin(), chain_of_body.end(), a, b); };
  for (const Joint& joint : rigid.joints) {
    const int a = joint.ends[0].body, b = joint.ends[1].body;
    if (a != Joint::ground && b != Joint::ground) merge(chain_of_body[at(a)], chain_of_body[at(b)]);
  }
  std::vector<int> chains;
  for (const Joint& joint : rigid.joints)
    chains.push_back(chain_of_body[at(std::max(joint.ends[0].body, joint.ends[1].body))]);
  return chains;
}

double find_largest(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

Wrench sum_on_body(const std::vector<JointRow>& rows, const std::vector<double>& multipliers, int body) {
  Wrench sum{{0, 0, 0}, {0, 0, 0}};
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t e = 0; e < 2; ++e) {
      if (rows[r].body[e] != body) continue;
      sum.impulse = sum.impulse + multipliers[r] * rows[r].unit[e].impulse;
      sum.moment = sum.moment + multipliers[r] * rows[r].unit[e].moment;
    }
  }
  return sum;
}

/// Clears the diagonal of rows that the held directions of both bodies keep, up to round-off of the arms about their
/// centres: as rows of their own these would lock what still turns.
void drop_held_rows(const RigidModel& rigid, const std::vector<JointRow>& rows, std::vector<double>& mobilities) {
  constexpr double round_off = 1e-18;  // square of an arm, over that of the radius of gyration
  for (std::size_t r = 0; r < rows.size(); ++r) {
    double free = 0;  // at least so much, if nothing held them
    for (std::size_t e = 0; e < 2; ++e) {
      if (rows[r].body[e] == Joint::ground) continue;
      const RigidBody& body = rigid.bodies[at(rows[r].body[e])];
      const Wrench& unit = rows[r].unit[e];
      free += dot(unit.impulse, unit.impulse) / body.mass;
      if (trace(body.inertia) > 0) free += 2 * dot(unit.moment, unit.moment) / trace(body.inertia);
    }
    double& diagonal = mobilities[r * rows.size() + r];
    if (diagonal <= round_off * free) diagonal = 0;
  }
}

}  // namespace

JointSolver::JointSolver(const Model& model) : model_(model) {
  const std::vector<int> numbers = number_chains(model.rigid);
  std::vector<int> known;
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    auto place = std::find(known.begin(), known.end(), numbers[j]) - known.begin();
    if (place == std::ssize(known)) {
      known.push_back(numbers[j]);
      chains_.emplace_back();
    }
    Chain& chain = chains_[at(place)];
    chain.joints.push_back(static_cast<int>(j));
    for (const JointEnd& end : model.rigid.joints[j].ends)
      if (end.body != Joint::ground) chain.bodies.push_back(end.body);
  }
  for (Chain& chain : chains_) {
    std::sort(chain.bodies.begin(), chain.bodies.end());
    chain.bodies.erase(std::unique(chain.bodies.begin(), chain.bodies.end()), chain.bodies.end());
    bodies_.insert(bodies_.end(), chain.bodies.begin(), chain.bodies.end());
  }
}

void JointSolver::begin_step(const State& state, const std::vector<double>& growths) {
  const RigidModel& rigid = model_.rigid;
  frames_.clear();
  responses_.clear();
  for (const Joint& joint : rigid.joints) frames_.push_back(find_joint_frame(joint, state.bodies));
  for (std::size_t b = 0; b < rigid.bodies.size(); ++b)
    responses_.push_back(find_response(rigid.bodies[b], state.bodies[b], growths[b]));
  for (Chain& chain : chains_) {
    chain.rows.clear();
    for (const int j : chain.joints) add_joint_rows(rigid.joints[at(j)], frames_[at(j)], state.bodies, chain.rows);
    std::vector<double> mobilities = find_mobilities(chain.rows, responses_);
    drop_held_rows(rigid, chain.rows, mobilities);
    chain.solver.factorise(std::move(mobilities), static_cast<int>(chain.rows.size()));
  }
}

/// The momenta of bodies with the impulses of a chain.
void JointSolver::push(const Chain& chain, const std::vector<RigidState>& free, std::vector<RigidState>& next) const {
  for (const int b : chain.bodies) {
    next[at(b)] = free[at(b)];
    give_wrench(model_.rigid.bodies[at(b)], sum_on_body(chain.rows, chain.multipliers, b), responses_[at(b)].growth,
                next[at(b)]);
  }
}

/// Measures the gaps that a step leaves in a chain, but for what it is not to close.
void JointSolver::measure(const State& state, double dt, const Chain& chain, const std::vector<RigidState>& next) {
  gaps_.clear();
  for (const int j : chain.joints) {
    const Joint& joint = model_.rigid.joints[at(j)];
    const auto changes = find_gap_changes(joint, frames_[at(j)], state.bodies, next, dt);
    for (std::size_t r = 0; r < at(count_rows(joint)); ++r)
      gaps_.push_back(changes[r] + closing * frames_[at(j)].gap[r]);
  }
}

/// Whether the gaps of a joint are round-off, against what its bodies measure.
bool JointSolver::keeps(const State& state, int joint, const double* gap) const {
  constexpr double round_off = 1e-9;
  double size = model_.rigid.joints[at(joint)].length;
  for (const JointEnd& end : model_.rigid.joints[at(joint)].ends)
    if (end.body != Joint::ground) size += norm(frames_[at(joint)].point - state.bodies[at(end.body)].center);
  for (int r = 0; r < count_rows(model_.rigid.joints[at(joint)]); ++r)
    if (!(std::abs(gap[r]) <= round_off * size)) return false;
  return true;
}

/// Newton's method with the mobilities at n, which the turn of a step hardly changes.
int JointSolver::solve_chain(const State& state, double dt, Chain& chain, std::vector<RigidState>& next) {
  constexpr int most_iterations = 40;
  constexpr double enough = 1e-16, stalls = 0.9;  // share of the first gap; of the one before
  const std::vector<RigidState> free = next;
  chain.multipliers.assign(chain.rows.size(), 0);
  double first = 0, before = 0;
  for (int i = 0;; ++i) {
    push(chain, free, next);
    for (const int b : chain.bodies) move_body(model_, state, at(b), dt, next[at(b)]);
    measure(state, dt, chain, next);
    const double left = find_largest(gaps_);
    if (i == 0) first = left;
    if (!(left > enough * first) || i == most_iterations || (i > 1 && left > stalls * before)) break;
    before = left;
    const std::vector<double> change = chain.solver.solve(gaps_);
    for (std::size_t r = 0; r < change.size(); ++r) chain.multipliers[r] -= change[r] / dt;
  }
  const double* gap = gaps_.data();
  for (const int j : chain.joints) {
    if (!keeps(state, j, gap)) return j;
    gap += count_rows(model_.rigid.joints[at(j)]);
  }
  return -1;
}

void JointSolver::take_impulses(const Chain& chain) {
  const double* multipliers = chain.multipliers.data();
  for (const int j : chain.joints) {
    const Joint& joint = model_.rigid.joints[at(j)];
    of_joints_[at(j)] = sum_joint_rows(joint, frames_[at(j)], multipliers);
    multipliers += count_rows(joint);
  }
  for (const int b : chain.bodies) on_bodies_[at(b)] = sum_on_body(chain.rows, chain.multipliers, b);
}

int JointSolver::solve(const State& state, double dt, std::vector<RigidState>& next) {
  on_bodies_.assign(model_.rigid.bodies.size(), Wrench{{0, 0, 0}, {0, 0, 0}});
  of_joints_.assign(model_.rigid.joints.size(), Wrench{{0, 0, 0}, {0, 0, 0}});
  int lost = -1;
  for (Chain& chain : chains_) {
    const int joint = solve_chain(state, dt, chain, next);
    if (lost < 0) lost = joint;
    take_impulses(chain);
  }
  return lost;
}

/// A joint whose rates are more than a share of the speeds of a chain, -1: none. One that is driven starts as it must.
int JointSolver::find_parting(const Chain& chain, const std::vector<RigidState>& bodies,
                              const std::vector<double>& rates) const {
  constexpr double share = 1e-3;
  for (const int b : chain.bodies) {
    const auto& motion = model_.rigid.bodies[at(b)].motion;
    if (std::any_of(motion.begin(), motion.end(), [](int row) { return row > 0; })) return -1;  // row 0 is rest
  }
  double speed = 0;
  for (const JointRow& row : chain.rows) {
    for (std::size_t e = 0; e < 2; ++e) {
      if (row.body[e] == Joint::ground) continue;
      const RigidState& body = bodies[at(row.body[e])];
      speed = std::max(speed, norm(body.velocity) + norm(row.unit[e].moment) * norm(body.spin));
    }
  }
  const double* rate = rates.data();
  for (const int j : chain.joints) {
    const int count = count_rows(model_.rigid.joints[at(j)]);
    if (std::any_of(rate, rate + count, [&](double r) { return std::abs(r) > share * speed; })) return j;
    rate += count;
  }
  return -1;
}

int JointSolver::settle(const State& state, std::vector<RigidState>& bodies) {
  int parting = -1;
  for (Chain& chain : chains_) {
    const std::vector<double> rates = find_gap_rates(chain.rows, bodies);
    if (parting < 0) parting = find_parting(chain, bodies, rates);
    chain.multipliers = chain.solver.solve(rates);
    for (double& multiplier : chain.multipliers) multiplier = -multiplier;
    for (const int b : chain.bodies) {
      const BodyChange change = find_change(responses_[at(b)], sum_on_body(chain.rows, chain.multipliers, b));
      bodies[at(b)].velocity = bodies[at(b)].velocity + change.velocity;
      bodies[at(b)].spin = bodies[at(b)].spin + change.spin;
      bodies[at(b)].spin_momentum = find_inertia(model_.rigid.bodies[at(b)], state.bodies[at(b)]) * bodies[at(b)].spin;
    }
  }
  return parting;
}

std::vector<Wrench> find_joint_forces(JointSolver& joints, const Model& model, const State& state,
                                      const std::vector<Wrench>& forces) {
  if (!joints.any()) return {};
  const double dt = state.next_dt > 0 ? state.next_dt : state.dt, dt_mean = 0.5 * (state.dt + dt);
  std::vector<RigidState> next = predict_momenta(model, state, forces, dt_mean);
  joints.begin_step(state, std::vector<double>(next.size(), 1));
  joints.solve(state, dt, next);
  std::vector<Wrench> found;
  for (const Wrench& on : joints.on_bodies()) found.push_back({(1 / dt_mean) * on.impulse, (1 / dt_mean) * on.moment});
  return found;
}

}  // namespace percuss
