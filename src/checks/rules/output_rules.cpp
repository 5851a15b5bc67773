// How long a run is, what is written of it, and when it is stopped.

#include <algorithm>
#include <cmath>

#include "src/checks/rules.hpp"

namespace percuss {
namespace {

/// Distance of a point from a box.
double find_distance(const Vec3& point, const Vec3& low, const Vec3& high) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double out = std::max({low[k] - point[k], point[k] - high[k], 0.0});
    square += out * out;
  }
  return std::sqrt(square);
}

/// "a minute at most", "40 minutes", "3 hours", "2 days".
std::string describe_wait(double seconds) {
  if (seconds < 90) return "a minute at most";
  if (seconds < 7200) return fmt::format("some {:.0f} minutes", seconds / 60);
  return seconds < 172800 ? fmt::format("some {:.0f} hours", seconds / 3600)
                          : fmt::format("some {:.0f} days", seconds / 86400);
}

}  // namespace

std::vector<Warning> check_end_time(const CheckedScene& scene) {
  constexpr double least = 5, most = 1e6;  // steps
  constexpr double element_time = 60e-9;   // seconds on one core: docs/performance.md
  const TimeDeck& time = scene.deck.time;
  double step = time.step_scale * scene.stable_step;
  if (time.max_step) step = std::min(step, *time.max_step);
  double steps = time.end / step;
  if (time.max_steps) steps = std::min(steps, static_cast<double>(*time.max_steps));
  const bool is_short = steps < least && !time.max_steps;
  if (!is_short && steps <= most) return {};
  double elements = 0;
  for (const PartMeasures& part : scene.measures->parts) elements += static_cast<double>(part.elements());
  const std::string why = is_short ? std::string("waves cross fewer than five elements")
                                   : fmt::format("their elements alone take {} on one core; percuss plan estimates all",
                                                 describe_wait(steps * elements * element_time));
  return {
      warn_at(scene.deck, "end_time", "time.end",
              fmt::format("time.end = {:g} takes about {:.2g} step{} of {:.2g} ({}): check its unit and those of the "
                          "materials{}",
                          time.end, std::ceil(steps), steps <= 1 ? "" : "s", step, why,
                          is_short ? "" : ", or use larger elements, mass scaling or a faster process"))};
}

std::vector<Warning> check_step_scale(const CheckedScene& scene) {
  constexpr double least = 0.1, least_limit = 0.02;  // a limit is lowered to see fast events step by step
  std::vector<Warning> warnings;
  const TimeDeck& time = scene.deck.time;
  if (time.step_scale < least)
    warnings.push_back(
        warn_at(scene.deck, "step_scale", "time.step_scale",
                fmt::format("time.step_scale is {:g} (the run takes {:.0f} times as many steps as with 0.9, "
                            "which is stable): raise it",
                            time.step_scale, 0.9 / time.step_scale)));
  if (time.max_step && *time.max_step < least_limit * scene.stable_step)
    warnings.push_back(
        warn_at(scene.deck, "step_scale", "time.max_step",
                fmt::format("time.max_step is {:g} (elements are stable up to {:.2g}): raise it or leave it "
                            "out",
                            *time.max_step, scene.stable_step)));
  if (time.max_step && *time.max_step > time.end)
    warnings.push_back(
        warn_at(scene.deck, "step_scale", "time.max_step",
                fmt::format("time.max_step is {:g}, longer than the run, {:g} (it limits nothing): check "
                            "its unit or leave it out",
                            *time.max_step, time.end)));
  return warnings;
}

std::vector<Warning> check_no_output(const CheckedScene& scene) {
  constexpr double most = 1e5;  // steps
  const OutputDeck& output = scene.deck.output;
  if (!output.list_fields().empty() || output.history_every || output.checkpoint_every || output.checkpoint_wall)
    return {};
  double steps = scene.deck.time.end / (scene.deck.time.step_scale * scene.stable_step);
  if (scene.deck.time.max_steps) steps = std::min(steps, static_cast<double>(*scene.deck.time.max_steps));
  if (steps <= most) return {};
  return {
      warn_at(scene.deck, "no_output", scene.deck.places.has("output") ? "output" : "time.end",
              fmt::format("some {:.2g} steps leave nothing but a summary (output asks for no fields, no history and "
                          "no checkpoint): add output: {{fields: {{every: {:g}}}, history: {{every: {:g}}}}}",
                          steps, scene.deck.time.end / 100, scene.deck.time.end / 1000))};
}

std::vector<Warning> check_output_interval(const CheckedScene& scene) {
  const OutputDeck& output = scene.deck.output;
  const double end = scene.deck.time.end;
  std::vector<Warning> warnings;
  const auto check = [&](const std::optional<double>& every, const std::string& section, const char* effect) {
    if (!every || *every <= end) return;
    warnings.push_back(warn_at(
        scene.deck, "output_interval", section + ".every",
        fmt::format("{}.every is {:g}, longer than the run, {:g} ({}): shorten it", section, *every, end, effect)));
  };
  for (const FieldsDeck* const fields : output.list_fields())
    check(fields->every, fields->key(), "only the first and last state are written");
  check(output.history_every, "output.history", "only the first and last row are written");
  check(output.checkpoint_every, "output.checkpoint", "an interrupted run could not be continued from one");
  return warnings;
}

std::vector<Warning> check_output_count(const CheckedScene& scene) {
  constexpr double most_frames = 2000, most_rows = 1e7, most_checkpoints = 1e4;
  const OutputDeck& output = scene.deck.output;
  std::vector<Warning> warnings;
  const auto check = [&](const std::optional<double>& every, const std::string& section, double most, const char* why) {
    if (!every || !(*every > 0)) return;
    const double count = scene.deck.time.end / *every;
    if (count <= most * (1 + 1e-9)) return;
    warnings.push_back(
        warn_at(scene.deck, "output_count", section + ".every",
                fmt::format("{}.every = {:g} writes {:.3g} {}: take a longer interval", section, *every, count, why)));
  };
  for (const FieldsDeck* const fields : output.list_fields())
    check(fields->every, fields->key(), most_frames, "frames (they fill the disk, and nobody looks at so many)");
  check(output.history_every, "output.history", most_rows, "rows (they fill the disk, and no program plots so many)");
  check(output.checkpoint_every, "output.checkpoint", most_checkpoints, "checkpoints (the run waits for each of them)");
  return warnings;
}

std::vector<Warning> check_history_points(const CheckedScene& scene) {
  constexpr double most = 0.1;  // share of the longest edge of the box: a point beside the surface is meant
  std::vector<Warning> warnings;
  for (const HistoryPoint& point : scene.deck.output.points) {
    if (!point.near || point.is_inside) continue;
    Vec3 low = scene.measures->low, high = scene.measures->high;
    for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
      if (scene.deck.parts[p].name != point.part) continue;
      low = scene.measures->parts[p].low;
      high = scene.measures->parts[p].high;
    }
    const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const double distance = find_distance(*point.near, low, high);
    if (distance <= most * size) continue;
    const std::string where = point.part.empty() ? "the mesh" : "part '" + point.part + "'";
    warnings.push_back(
        {"history_point",
         fmt::format("history point '{}' is {:.3g} away from {}, which is {:.3g} long (the nearest {} is "
                     "followed instead): check its place",
                     point.name, distance, where, size, point.is_element ? "element" : "node"),
         scene.deck.where(point.place), 0, 1});
  }
  return warnings;
}

std::vector<Warning> check_audit_limits(const CheckedScene& scene) {
  constexpr double most_energy = 0.5, most_momentum = 0.01;
  const AuditDeck& audit = scene.deck.audit;
  std::vector<Warning> warnings;
  const auto check = [&](double limit, double most, const std::string& key) {
    if (limit <= most) return;
    warnings.push_back(
        warn_at(scene.deck, "audit_limit", "audit." + key,
                fmt::format("audit.{} is {:g} (a run that has gone wrong is not stopped): keep it at {:g} or "
                            "less",
                            key, limit, most)));
  };
  check(audit.max_energy_error, most_energy, "max_energy_error");
  check(audit.max_momentum_error, most_momentum, "max_momentum_error");
  return warnings;
}

}  // namespace percuss
