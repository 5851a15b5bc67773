#include "src/output/field_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace percuss {
namespace {

enum class Quantity { length, mass, time };

// A unit of one quantity, ten to this power of metres, kilograms or seconds; none: of no decimal system.
struct Unit {
  std::string_view name;
  Quantity quantity;
  std::optional<int> power;
};

constexpr std::array known_units{
    Unit{"km", Quantity::length, 3},  Unit{"m", Quantity::length, 0},     Unit{"cm", Quantity::length, -2},
    Unit{"mm", Quantity::length, -3}, Unit{"um", Quantity::length, -6},   Unit{"\u00b5m", Quantity::length, -6},
    Unit{"in", Quantity::length, {}}, Unit{"inch", Quantity::length, {}}, Unit{"ft", Quantity::length, {}},
    Unit{"t", Quantity::mass, 3},     Unit{"tonne", Quantity::mass, 3},   Unit{"Mg", Quantity::mass, 3},
    Unit{"kg", Quantity::mass, 0},    Unit{"g", Quantity::mass, -3},      Unit{"mg", Quantity::mass, -6},
    Unit{"lb", Quantity::mass, {}},   Unit{"slug", Quantity::mass, {}},   Unit{"s", Quantity::time, 0},
    Unit{"ms", Quantity::time, -3},   Unit{"us", Quantity::time, -6},     Unit{"\u00b5s", Quantity::time, -6},
    Unit{"ns", Quantity::time, -9},   Unit{"min", Quantity::time, {}},
};

struct UnitSystem {
  Unit length, mass, time;
};

std::vector<std::string_view> split_words(std::string_view text) {
  constexpr std::string_view between = ",; \t";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t first = text.find_first_not_of(between);
    if (first == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(between, first), text.size());
    words.push_back(text.substr(first, end - first));
    text.remove_prefix(end);
  }
}

std::optional<UnitSystem> read_system(std::string_view text) {
  std::array<std::optional<Unit>, 3> found;
  for (const std::string_view word : split_words(text)) {
    const auto* unit =
        std::find_if(known_units.begin(), known_units.end(), [&](const Unit& u) { return u.name == word; });
    if (unit == known_units.end() || found[static_cast<std::size_t>(unit->quantity)]) return std::nullopt;
    found[static_cast<std::size_t>(unit->quantity)] = *unit;
  }
  if (!found[0] || !found[1] || !found[2]) return std::nullopt;
  return UnitSystem{*found[0], *found[1], *found[2]};
}

// The named unit, Pa or N, that is ten to this power of it, with its prefix; empty if there is none.
std::string name_with_prefix(std::optional<int> power, const char* name) {
  if (!power) return "";
  switch (*power) {
    case 9:
      return fmt::format("G{}", name);
    case 6:
      return fmt::format("M{}", name);
    case 3:
      return fmt::format("k{}", name);
    case 0:
      return name;
    case -3:
      return fmt::format("m{}", name);
    case -6:
      return fmt::format("\u00b5{}", name);
    default:
      return "";
  }
}

// Power of ten of mass length^by / time^2 in SI units.
std::optional<int> find_power(const UnitSystem& system, int by) {
  if (!system.mass.power || !system.length.power || !system.time.power) return std::nullopt;
  return *system.mass.power + by * *system.length.power - 2 * *system.time.power;
}

std::string name_pressure(const UnitSystem& system) {
  const auto power = find_power(system, -1);
  if (power == 11) return "Mbar";  // cm, g, us
  const std::string named = name_with_prefix(power, "Pa");
  return !named.empty() ? named
                        : fmt::format("{}/({}\u00b7{}\u00b2)", system.mass.name, system.length.name, system.time.name);
}

std::string name_force(const UnitSystem& system) {
  const std::string named = name_with_prefix(find_power(system, 1), "N");
  return !named.empty() ? named
                        : fmt::format("{}\u00b7{}/{}\u00b2", system.mass.name, system.length.name, system.time.name);
}

bool is_stress(std::string_view field) {
  return field == "pressure" || field == "von_mises" || field == "internal_energy" || field == "stress" ||
         field.substr(0, 7) == "stress_";
}

}  // namespace

std::string name_field_unit(const std::string& field, const std::string& units) {
  const auto system = read_system(units);
  if (!system) return "";
  if (field == "points" || field == "displacement" || field == "thickness") return std::string(system->length.name);
  if (field == "time") return std::string(system->time.name);
  if (field == "mass") return std::string(system->mass.name);
  if (field == "velocity") return fmt::format("{}/{}", system->length.name, system->time.name);
  if (field == "contact_force") return name_force(*system);
  return is_stress(field) ? name_pressure(*system) : "";
}

}  // namespace percuss
