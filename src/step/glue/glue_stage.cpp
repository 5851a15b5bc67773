#include "src/step/glue/glue_stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/springs/gathered_rows.hpp"
#include "src/step/springs/node_mobility.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {
namespace {

constexpr double failed = 1;  // damage

}  // namespace

GlueStage::GlueStage(const Deck& deck, const Model& model, ContactStage& contact)
    : deck_(deck),
      model_(model),
      contact_(contact),
      body_of_node_(share_bodies(model, model.glue.nodes.size(), model.glue.owned_node, model.glue.owned_place)),
      rows_(model.glue.nodes.size() * NodeRow::count),
      moves_(model.glue.nodes.size()),
      points_(model.glue.points.size()),
      shares_(model.glue.points.size()),
      forces_(model.glue.nodes.size()),
      own_rows_("percuss::glue_rows", model.glue.owned_node.extent(0), NodeRow::count),
      own_forces_("percuss::glue_forces", model.glue.owned_node.extent(0)) {}

Point3 GlueStage::place_of(int node) const {
  const std::size_t n = at(node);
  return {value(n, NodeRow::place), value(n, NodeRow::place + 1), value(n, NodeRow::place + 2)};
}

void GlueStage::gather(const State& state) {
  const std::vector<double> before = rows_;
  gather_forced_nodes<false>(model_, state, {model_.glue.owned_node, model_.glue.owned_place}, own_rows_, rows_);
  for (std::size_t n = 0; n < moves_.size(); ++n) {
    const auto move = [&](std::size_t k) { return value(n, k) - before[n * NodeRow::count + k]; };
    moves_[n] = {move(NodeRow::place), move(NodeRow::place + 1), move(NodeRow::place + 2)};
  }
}

Separation GlueStage::find_separation_of(const GluePoint& point) const {
  FacePoints face;
  for (std::size_t i = 0; i < 4; ++i) face.corner[i] = place_of(point.node[i + 1]);
  return find_separation(point.geometry, point.side, place_of(point.node[0]), face);
}

/// Tractions and forces at the places of now, point after point.
void GlueStage::pull(const std::vector<double>& damage_before) {
  forces_before_ = forces_;
  std::fill(forces_.begin(), forces_.end(), Point3{});
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const GluePoint& point = model_.glue.points[p];
    points_[p] = {};
    points_[p].damage = failed;
    if (damage_before[p] >= failed) continue;
    const Separation of = find_separation_of(point);
    const double slide = norm(of.slide);
    const CohesivePoint now = separate(model_.glue.laws[at(point.tie)], of.opening, slide, damage_before[p]);
    if (now.damage >= failed) continue;
    points_[p] = now;
    shares_[p] = bound_shares(point.geometry, of);
    const Point3 shear = slide > 0 ? (now.shear / slide) * of.slide : Point3{};
    const GlueForces on = spread_force(point.geometry, of, (-point.area) * (now.normal * of.normal + shear));
    for (std::size_t i = 0; i < 5; ++i) forces_[at(point.node[i])] = forces_[at(point.node[i])] + on.force[i];
  }
}

/// That the mean forces of the last step have taken from the nodes.
double GlueStage::find_work() const {
  double work = 0;
  for (std::size_t n = 0; n < forces_.size(); ++n) work -= 0.5 * dot(forces_before_[n] + forces_[n], moves_[n]);
  return work;
}

/// Damage dissipates at the rate of the energy that it takes; failure what compression has stored.
void GlueStage::book(State& state, const std::vector<double>& damage_before, const std::vector<CohesivePoint>& before) {
  state.books.glue_work += find_work();
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
  pull(damage_before);
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
  pull(state.glue_damage);
  double given_back = 0;
  for (std::size_t n = 0; n < forces_.size(); ++n) given_back += 0.5 * dot(forces_before_[n] - forces_[n], moves_[n]);
  state.books.glue_work += given_back;
  state.books.glue_dissipated += given_back;
}

void GlueStage::add_forces(State& state, double /*time*/) {
  const auto own = Kokkos::create_mirror_view(own_forces_);
  const auto places = to_host(model_.glue.owned_place);
  for (std::size_t i = 0; i < places.extent(0); ++i) {
    const Point3& force = forces_[at(places(i))];
    own(i, 0) = force.x;
    own(i, 1) = force.y;
    own(i, 2) = force.z;
  }
  const std::size_t first = at(model_.glue.first_slot);
  Kokkos::deep_copy(Kokkos::subview(state.slot_force, std::pair(first, first + own.extent(0)), Kokkos::ALL), own);
}

/// By node: the largest inverse mass in a direction, or the mobility of its rigid body there.
std::vector<double> GlueStage::find_mobilities(const State& state) const {
  std::vector<double> mobilities;
  for (std::size_t n = 0; n < body_of_node_.size(); ++n) {
    const Point3 place = place_of(static_cast<int>(n));
    mobilities.push_back(find_mobility(
        model_, state, body_of_node_[n],
        {{place.x, place.y, place.z}, std::max(value(n, NodeRow::mobility), 0.0)}));  // a node that is gone has none
  }
  return mobilities;
}

// As of springs (SpringStage::find_rates()): the mass of a node is divided among its points by stiffness times share.
// With shares c_i of a point's force, (sum c_i |u_i|)^2 <= sum c_i^2 / m_i sum m_i |u_i|^2.
void GlueStage::limit_step(const State& state, StepBound& bound) const {
  const std::vector<double> mobility = find_mobilities(state);
  std::vector<double> carried(mobility.size() + state.bodies.size(), 0);
  const auto carrier = [&](int n) {
    return body_of_node_[at(n)] < 0 ? at(n) : mobility.size() + at(body_of_node_[at(n)]);
  };
  const auto visit = [&](const auto& take) {
    for (std::size_t p = 0; p < points_.size(); ++p) {
      if (state.glue_damage[p] >= failed) continue;
      const GluePoint& point = model_.glue.points[p];
      take(point, shares_[p]);
    }
  };
  visit([&](const GluePoint& point, const GlueShares& of) {
    const CohesiveLaw& law = model_.glue.laws[at(point.tie)];
    const double stiffness = point.area * std::max(law.normal_stiffness, law.shear_stiffness);
    for (std::size_t i = 0; i < 5; ++i)
      carried[carrier(point.node[i])] += stiffness * of.share[i] * mobility[at(point.node[i])];
  });
  SpringRates rates;
  visit([&](const GluePoint& point, const GlueShares& of) {
    double rate = 0;
    for (std::size_t i = 0; i < 5; ++i) rate += of.share[i] * carried[carrier(point.node[i])];
    rates.stiffness = std::max(rates.stiffness, rate);
  });
  if (rates.stiffness > 0) bound.step = find_step_with_springs(rates, bound.step);
}

void GlueStage::archive(CheckpointArchive& archive, State& state) {
  archive.numbers("glue/damage", state.glue_damage);
  archive.number("books/glue_work", state.books.glue_work);
  archive.number("books/glue_dissipated", state.books.glue_dissipated);
  archive.number("books/glue_failed", state.books.glue_failed);
}

void GlueStage::resume(const State& state) {
  gather(state);
  pull(state.glue_damage);
}

std::vector<Warning> GlueStage::take_warnings() { return std::exchange(warnings_, {}); }

}  // namespace percuss
