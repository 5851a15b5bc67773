#include "src/step/glue/glue_stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/gather_items.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/node_mobility.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {
namespace {

constexpr double failed = 1;  // damage

/// Whether the glue of a node lies off it.
bool has_arm(const Point3& arm) { return dot(arm, arm) > 0; }

}  // namespace

GlueStage::GlueStage(const Deck& deck, const Model& model, ContactStage& contact)
    : deck_(deck),
      model_(model),
      contact_(contact),
      body_of_node_(share_bodies(model, model.glue)),
      nodes_(model, model.glue),
      moves_(model.glue.nodes.size()),
      points_(model.glue.points.size()),
      shares_(model.glue.points.size()),
      forces_(model.glue.nodes.size()),
      turns_(model.glue.points.size()),
      moments_(model.glue.points.size()),
      own_forces_("percuss::glue_forces", model.glue.owned_node.extent(0)),
      own_moments_("percuss::glue_moments", model.has_rotations ? model.glue.owned_node.extent(0) : 0) {}

void GlueStage::gather(const State& state) {
  const std::vector<double> before = nodes_.rows();
  nodes_.gather(state);
  for (std::size_t n = 0; n < moves_.size(); ++n) {
    const auto move = [&](std::size_t k) {
      return nodes_.value(n, Row::place + k) - before[n * Row::count + Row::place + k];
    };
    moves_[n] = {move(0), move(1), move(2)};
  }
}

/// Arms turn with their nodes, which have the spin of n+1/2.
void GlueStage::turn_arms(State& state, double dt) {
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (!has_arm(state.glue_arms[p])) continue;
    turns_[p] = dt * nodes_.vector(model_.glue.points[p].node[0], Row::spin);
    state.glue_arms[p] = rotate(turns_[p], state.glue_arms[p]);
  }
}

Separation GlueStage::find_separation_of(const GluePoint& point, const Point3& arm) const {
  FacePoints face;
  for (std::size_t i = 0; i < 4; ++i) face.corner[i] = nodes_.vector(point.node[i + 1], Row::place);
  return find_separation(point.geometry, point.side, nodes_.vector(point.node[0], Row::place) + arm, face);
}

/// Tractions and forces at the places of now, point after point.
void GlueStage::pull(const State& state, const std::vector<double>& damage_before) {
  forces_before_ = forces_;
  moments_before_ = moments_;
  std::fill(forces_.begin(), forces_.end(), Point3{});
  std::fill(moments_.begin(), moments_.end(), Point3{});
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const GluePoint& point = model_.glue.points[p];
    points_[p] = {};
    points_[p].damage = failed;
    if (damage_before[p] >= failed) continue;
    const Point3& arm = state.glue_arms[p];
    const Separation of = find_separation_of(point, arm);
    const double slide = norm(of.slide);
    const CohesivePoint now = separate(model_.glue.laws[at(point.tie)], of.opening, slide, damage_before[p]);
    if (now.damage >= failed) continue;
    points_[p] = now;
    shares_[p] = bound_shares(point.geometry, of);
    const Point3 shear = slide > 0 ? (now.shear / slide) * of.slide : Point3{};
    const GlueForces on = spread_force(point.geometry, of, (-point.area) * (now.normal * of.normal + shear));
    for (std::size_t i = 0; i < 5; ++i) forces_[at(point.node[i])] = forces_[at(point.node[i])] + on.force[i];
    if (has_arm(arm)) moments_[p] = cross(arm, on.force[0]);
  }
}

/// Energy that the forces and moments of n-1 and n have taken from the nodes in the last step, with a share of each.
double GlueStage::find_work(double share_before, double share_now) const {
  double work = 0;
  for (std::size_t n = 0; n < forces_.size(); ++n)
    work -= dot(share_before * forces_before_[n] + share_now * forces_[n], moves_[n]);
  for (std::size_t p = 0; p < moments_.size(); ++p)
    work -= dot(share_before * moments_before_[p] + share_now * moments_[p], turns_[p]);
  return work;
}

/// Damage dissipates at the rate of the energy that it takes; failure what compression has stored.
void GlueStage::book(State& state, const std::vector<double>& damage_before, const std::vector<CohesivePoint>& before) {
  state.books.glue_work += find_work(0.5, 0.5);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (damage_before[p] >= failed) continue;
    const double area = model_.glue.points[p].area, damage = points_[p].damage;
    if (damage >= failed) {
      state.books.glue_dissipated += area * before[p].stored();
      state.books.glue_failed += area;
    } else {
      state.books.glue_dissipated += 0.5 * area * (before[p].whole + points_[p].whole) * (damage - damage_before[p]);
    }
  }
}

/// Tells contact and the user of the nodes that have failed in this step.
void GlueStage::let_go(const State& state, const std::vector<double>& damage_before) {
  std::vector<std::int64_t> numbers;
  std::vector<long> counts(deck_.contact.ties.size(), 0);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (damage_before[p] >= failed || points_[p].damage < failed) continue;
    numbers.push_back(model_.glue.points[p].number);
    ++counts[at(model_.glue.points[p].tie)];
  }
  if (numbers.empty()) return;
  contact_.let_go(numbers);
  for (std::size_t t = 0; t < counts.size(); ++t) {
    if (counts[t] == 0) continue;
    const TieDeck& tie = deck_.contact.ties[t];
    warnings_.push_back({"tie_failure",
                         fmt::format("nodes of the cohesive tie of '{}' and '{}' have failed (their energy is spent): "
                                     "glue_failed in history.csv is their area",
                                     tie.a.name, tie.b.name),
                         deck_.where(tie.place), state.time, counts[t]});
  }
}

void GlueStage::advance(State& state, double dt) {
  const std::vector<double> damage_before = state.glue_damage;
  const std::vector<CohesivePoint> before = points_;
  gather(state);
  turn_arms(state, dt);
  pull(state, damage_before);
  for (std::size_t p = 0; p < points_.size(); ++p) state.glue_damage[p] = points_[p].damage;
  if (dt > 0)
    book(state, damage_before, before);
  else
    for (std::size_t p = 0; p < points_.size(); ++p)
      state.books.glue_work += model_.glue.points[p].area * points_[p].stored();
  let_go(state, damage_before);
}

// Half of the force at n has been booked for the step to n. That force is gone, for the nodes that are left too.
void GlueStage::drop_vanished(State& state) {
  std::vector<std::int64_t> tied = gather_items(model_.ranks, contact_.list_tied_nodes());
  std::sort(tied.begin(), tied.end());
  bool some = false;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const GluePoint& point = model_.glue.points[p];
    if (state.glue_damage[p] >= failed || std::binary_search(tied.begin(), tied.end(), point.number)) continue;
    state.books.glue_dissipated += point.area * points_[p].stored();
    state.glue_damage[p] = failed;
    some = true;
  }
  if (!some) return;
  pull(state, state.glue_damage);
  const double given_back = find_work(-0.5, 0.5);
  state.books.glue_work += given_back;
  state.books.glue_dissipated += given_back;
}

void GlueStage::add_forces(State& state, double /*time*/) {
  fill_force_slots(model_.glue, forces_, own_forces_, state.slot_force);
  if (own_moments_.extent(0) == 0) return;
  std::vector<Point3> moments(forces_.size());
  for (std::size_t p = 0; p < moments_.size(); ++p) {
    Point3& moment = moments[at(model_.glue.points[p].node[0])];
    moment = moment + moments_[p];
  }
  fill_force_slots(model_.glue, moments, own_moments_, state.slot_moment);
}

// As of springs (SpringStage::find_rates()): the mass of a node is divided among its points by stiffness times share.
// With shares c_i of a point's force, (sum c_i |u_i|)^2 <= sum c_i^2 / m_i sum m_i |u_i|^2.
void GlueStage::limit_step(const State& state, StepBound& bound) const {
  const std::vector<double> mobility = find_mobilities(model_, state, body_of_node_, nodes_);
  std::vector<double> carried(mobility.size() + state.bodies.size(), 0);
  const auto carrier = [&](int n) {
    return body_of_node_[at(n)] < 0 ? at(n) : mobility.size() + at(body_of_node_[at(n)]);
  };
  const auto visit = [&](const auto& take) {
    for (std::size_t p = 0; p < points_.size(); ++p) {
      if (state.glue_damage[p] >= failed) continue;
      const GluePoint& point = model_.glue.points[p];
      const CohesiveLaw& law = model_.glue.laws[at(point.tie)];
      take(point, shares_[p], point.area * std::max(law.normal_stiffness, law.shear_stiffness));
    }
  };
  visit([&](const GluePoint& point, const GlueShares& of, double stiffness) {
    for (std::size_t i = 0; i < 5; ++i)
      carried[carrier(point.node[i])] += stiffness * of.share[i] * mobility[at(point.node[i])];
  });
  SpringRates rates;
  visit([&](const GluePoint& point, const GlueShares& of, double stiffness) {
    // Only this point turns its node.
    double rate = stiffness * dot(point.arm, point.arm) * nodes_.value(point.node[0], Row::turning);
    for (std::size_t i = 0; i < 5; ++i) rate += of.share[i] * carried[carrier(point.node[i])];
    rates.stiffness = std::max(rates.stiffness, rate);
  });
  if (rates.stiffness > 0) bound.step = find_step_with_springs(rates, bound.step);
}

void GlueStage::archive(CheckpointArchive& archive, State& state) {
  archive.numbers("glue/damage", state.glue_damage);
  archive.each("glue/arms", state.glue_arms, [](Point3& arm, const auto& take) { take(arm.x, arm.y, arm.z); });
  archive.number("books/glue_work", state.books.glue_work);
  archive.number("books/glue_dissipated", state.books.glue_dissipated);
  archive.number("books/glue_failed", state.books.glue_failed);
}

void GlueStage::resume(const State& state) {
  gather(state);
  pull(state, state.glue_damage);
}

std::vector<Warning> GlueStage::take_warnings() { return std::exchange(warnings_, {}); }

std::vector<HistoryColumn> GlueStage::list_columns() const {
  return {{"glue_work", dimensions::energy, "energy of cohesive ties, part of internal"},
          {"glue_dissipated", dimensions::energy, "energy dissipated by cohesive ties, part of glue_work"},
          {"glue_failed", dimensions::area, "failed area of cohesive ties"}};
}

void GlueStage::append_values(const State& state, std::vector<double>& row) {
  row.push_back(state.books.glue_work);
  row.push_back(state.books.glue_dissipated);
  row.push_back(state.books.glue_failed);
}

}  // namespace percuss
