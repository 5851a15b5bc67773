// Tables over time that do not fit the run: cut off before its end, or over times of another unit.

#include <algorithm>
#include <cmath>

#include "src/checks/rules.hpp"
#include "src/deck/asked_for.hpp"

namespace percuss {
namespace {

using Rows = std::vector<std::pair<double, double>>;

/// A curve that drives the scene.
struct NamedCurve {
  enum class Of { load, velocity, displacement };
  const Curve& curve;
  std::string path;
  Of of = Of::load;
};

void list_conditions(const Deck& deck, std::vector<NamedCurve>& curves) {
  for (std::size_t c = 0; c < deck.conditions.size(); ++c) {
    if (const auto& turn = deck.conditions[c].turn) {
      curves.push_back(
          {turn->angular_velocity, join_path("conditions", c) + ".turn.angular_velocity", NamedCurve::Of::velocity});
      continue;
    }
    const bool is_velocity = deck.conditions[c].kind == ConditionDeck::Kind::velocity;
    for (std::size_t k = 0; k < 6; ++k)
      curves.push_back(
          {deck.conditions[c].value[k],
           join_path("conditions", c) + (is_velocity ? ".velocity." : ".displacement.") + direction_names[k],
           is_velocity ? NamedCurve::Of::velocity : NamedCurve::Of::displacement});
  }
}

/// Curves of conditions, loads, gravity and walls.
std::vector<NamedCurve> list_curves(const Deck& deck) {
  std::vector<NamedCurve> curves;
  list_conditions(deck, curves);
  for (std::size_t i = 0; i < deck.pressures.size(); ++i)
    curves.push_back({deck.pressures[i].value, join_path("loads.pressure", i) + ".value"});
  for (std::size_t i = 0; i < deck.nodal_loads.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k)
      curves.push_back({deck.nodal_loads[i].value[k],
                        join_path("loads.nodal", i) + (k < 3 ? ".force." : ".moment.") + direction_names[k % 3]});
  }
  for (std::size_t k = 0; k < 3; ++k) curves.push_back({deck.gravity.along[k], join_path("loads.gravity", k)});
  for (std::size_t w = 0; w < deck.walls.size(); ++w) {
    if (deck.walls[w].speed)
      curves.push_back({*deck.walls[w].speed, join_path("walls", w) + ".speed", NamedCurve::Of::velocity});
  }
  return curves;
}

/// Whether the values of a table only rise or only fall, as those of a ramp to a value that is held.
bool is_monotone(const Rows& rows) {
  const auto rises = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto falls = [](const auto& a, const auto& b) { return a.second > b.second; };
  return std::is_sorted(rows.begin(), rows.end(), rises) || std::is_sorted(rows.begin(), rows.end(), falls);
}

/// Whether a table was cut off: it has a course of its own, and neither ends flat nor at zero.
bool is_cut_off(const Rows& rows, double end) {
  constexpr double flat = 1e-3;  // share of the largest value
  if (rows.empty() || is_monotone(rows) || rows.back().first >= end) return false;
  double largest = 0;
  for (const auto& row : rows) largest = std::max(largest, std::abs(row.second));
  const double last = rows.back().second, before = rows[rows.size() - 2].second;
  return std::abs(last) > flat * largest && std::abs(last - before) > flat * largest;
}

/// Whether all rows have one value.
bool is_flat(const Rows& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.second == rows.front().second; });
}

}  // namespace

std::vector<Warning> check_curve_end(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (const NamedCurve& of : list_curves(deck)) {
    const Rows rows = of.curve.rows();
    if (!is_cut_off(rows, deck.time.end)) continue;
    warnings.push_back(
        warn_at(deck, "curve_end", of.path,
                fmt::format("the table ends at t = {:g}, the run at {:g} (its last value, {:g}, is held from there "
                            "on): extend it, or end it flat or at 0",
                            rows.back().first, deck.time.end, rows.back().second)));
  }
  return warnings;
}

// A displacement of two rows is a constant speed, which may be written over any time.
std::vector<Warning> check_curve_time(const CheckedScene& scene) {
  constexpr double most = 100;  // runs: milliseconds beside seconds are a thousand
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  for (const NamedCurve& of : list_curves(deck)) {
    const Rows rows = of.curve.rows();
    if (rows.size() < 2 || is_flat(rows) || rows.back().first <= most * deck.time.end) continue;
    if (rows.size() == 2 && of.of == NamedCurve::Of::displacement) continue;
    warnings.push_back(
        warn_at(deck, "curve_time", of.path,
                fmt::format("the table goes on to t = {:g}, {:.3g} times the run of {:g} (the run sees only its "
                            "beginning): check the unit of its times",
                            rows.back().first, rows.back().first / deck.time.end, deck.time.end)));
  }
  return warnings;
}

std::vector<Warning> check_short_pulse(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  const TimeDeck& time = scene.deck.time;
  double step = time.step_scale * scene.stable_step;
  if (time.max_step) step = std::min(step, *time.max_step);
  for (const NamedCurve& of : list_curves(scene.deck)) {
    const Rows rows = of.curve.rows();
    if (rows.size() < 3 || is_monotone(rows) || rows.back().first > step) continue;
    warnings.push_back(
        warn_at(scene.deck, "short_pulse", of.path,
                fmt::format("the table ends at t = {:g}, within the first step of {:.2g} (the run sees none of its "
                            "course): check the unit of its times, or give time.max_step",
                            rows.back().first, step)));
  }
  return warnings;
}

}  // namespace percuss
