// Step bounds by part.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "src/checks/rules.hpp"

namespace percuss {
namespace {

/// Parts whose elements bound the step, those with the shortest first.
std::vector<std::size_t> list_by_step(const CheckedScene& scene) {
  std::vector<std::size_t> parts(scene.part_steps->size());
  std::iota(parts.begin(), parts.end(), std::size_t{0});
  std::erase_if(parts, [&](std::size_t p) { return !std::isfinite((*scene.part_steps)[p]); });
  std::stable_sort(parts.begin(), parts.end(),
                   [&](std::size_t a, std::size_t b) { return (*scene.part_steps)[a] < (*scene.part_steps)[b]; });
  return parts;
}

/// Whether elements fill a part across: a column of slices, as of a wave in one dimension.
bool is_column(const PartMeasures& part) {
  std::array<double, 3> size{};
  for (std::size_t k = 0; k < 3; ++k) size[k] = part.high[k] - part.low[k];
  std::sort(size.begin(), size.end());
  return part.longest_edge >= (1 - 1e-9) * size[1];
}

}  // namespace

std::vector<Warning> check_slow_parts(const CheckedScene& scene) {
  constexpr double least = 8;            // times: evenly sized elements of steel and rubber differ by less
  constexpr double most_elements = 0.5;  // share of all: what is most of the mesh is what the run is about
  const std::vector<std::size_t> parts = list_by_step(scene);
  std::int64_t all = 0, slow = 0;
  for (const std::size_t p : parts) all += scene.measures->parts[p].elements();
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    slow += scene.measures->parts[parts[i]].elements();
    if (static_cast<double>(slow) > most_elements * static_cast<double>(all)) break;
    const double own = (*scene.part_steps)[parts.front()], next = (*scene.part_steps)[parts[i + 1]];
    const double limit = scene.deck.time.max_step.value_or(next) / scene.deck.time.step_scale;
    const double cost = std::min(next, limit) / own;
    if (next < least * (*scene.part_steps)[parts[i]] || cost < least) continue;
    const std::string& name = scene.deck.parts[parts.front()].name;
    const std::string others = i == 0 ? "" : fmt::format(" (and {} other part{})", i, i == 1 ? "" : "s");
    return {warn_at(
        scene.deck, "slow_part", "parts." + name,
        fmt::format("the elements of part '{}'{} allow a step of {:.2g}, those of all other parts {:.2g} (the "
                    "run takes {:.2g} times as many steps for {:.2g} % of its elements): use larger elements "
                    "there, make the part rigid, or scale its mass",
                    name, others, own, next, cost, 100.0 * static_cast<double>(slow) / static_cast<double>(all)))};
  }
  return {};
}

std::vector<Warning> check_sharp_elements(const CheckedScene& scene) {
  constexpr double round_off = 1e-9, much = 1.5;  // much: times longer, without these elements
  const std::vector<std::size_t> parts = list_by_step(scene);
  if (parts.empty()) return {};
  const std::size_t p = parts.front();
  const PartMeasures& part = scene.measures->parts[p];
  if (!std::isfinite(part.thinnest_sliver) || is_column(part)) return {};  // beams have none
  if (part.thinnest_sliver > (1 + round_off) * part.thinnest) return {};
  const double own = (*scene.part_steps)[p];
  if (scene.deck.time.max_step.value_or(HUGE_VAL) < own * scene.deck.time.step_scale / much) return {};
  return {
      warn_at(scene.deck, "sharp_element", "parts." + scene.deck.parts[p].name,
              fmt::format("elements of part '{}' are up to {:.3g} times as long as thin, and the thinnest, {:.3g} "
                          "across, sets the step of the whole run (elements of a ratio of 10 would allow a step {:.2g} "
                          "times as long at their size): mesh it more evenly, take shells for a thin layer, or scale "
                          "its mass",
                          scene.deck.parts[p].name, part.sharpest, part.thinnest, part.sharpest / 10))};
}

std::vector<Warning> check_idle_mass_scaling(const CheckedScene& scene) {
  constexpr double round_off = 1e-9;
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  // Elements that were given mass have just the step requested.
  const auto check = [&](const MassScalingDeck& scaling, const std::string& path, auto is_scaled) {
    double bound = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < deck.parts.size(); ++p)
      if (is_scaled(deck.parts[p])) bound = std::min(bound, (*scene.part_steps)[p]);
    if (scaling.every || !(bound > scaling.step * (1 + round_off))) return;
    const std::string why = std::isfinite(bound) ? fmt::format("the elements allow {:.3g} by themselves", bound)
                                                 : std::string("the elements are rigid and bound no step");
    warnings.push_back(
        warn_at(deck, "idle_mass_scaling", path + ".step",
                fmt::format("mass scaling to a step of {:g} adds nothing ({}): ask for a longer step, or "
                            "leave it out",
                            scaling.step, why)));
  };
  if (deck.time.mass_scaling)
    check(*deck.time.mass_scaling, "time.mass_scaling", [](const PartDeck& part) { return !part.mass_scaling; });
  for (const PartDeck& part : deck.parts) {
    if (!part.mass_scaling) continue;
    check(*part.mass_scaling, "parts." + part.name + ".mass_scaling", [&](const PartDeck& p) { return &p == &part; });
  }
  return warnings;
}

}  // namespace percuss
