#include "src/deck/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace percuss {
namespace {

// NIST Special Publication 811, appendix B: exact.
constexpr double inch = 0.0254, foot = 0.3048, pound = 0.45359237, pound_force = 4.4482216152605;

struct KnownUnit {
  std::string_view plain, shown;
  double in_si;
};

constexpr std::array lengths{
    KnownUnit{"m", "m", 1},           KnownUnit{"mm", "mm", 1e-3},           KnownUnit{"cm", "cm", 1e-2},
    KnownUnit{"um", "\u00b5m", 1e-6}, KnownUnit{"\u00b5m", "\u00b5m", 1e-6}, KnownUnit{"km", "km", 1e3},
    KnownUnit{"in", "in", inch},      KnownUnit{"ft", "ft", foot},
};
constexpr std::array masses{
    KnownUnit{"kg", "kg", 1},
    KnownUnit{"t", "t", 1e3},
    KnownUnit{"g", "g", 1e-3},
    KnownUnit{"mg", "mg", 1e-6},
    KnownUnit{"lb", "lb", pound},
    KnownUnit{"lbf s2/in", "lbf\u00b7s\u00b2/in", pound_force / inch},
    KnownUnit{"lbf s2/ft", "lbf\u00b7s\u00b2/ft", pound_force / foot},
    KnownUnit{"slug", "slug", pound_force / foot},
};
constexpr std::array times{
    KnownUnit{"s", "s", 1},           KnownUnit{"ms", "ms", 1e-3},
    KnownUnit{"us", "\u00b5s", 1e-6}, KnownUnit{"\u00b5s", "\u00b5s", 1e-6},
    KnownUnit{"ns", "ns", 1e-9},
};
constexpr std::array temperatures{std::string_view("K"), std::string_view("C")};

/// Units with names of their own. Those of SI take prefixes as well.
struct NamedUnit {
  Dimension quantity;
  std::string_view name;
  double in_si;
  bool takes_prefixes;
};
constexpr std::array named_units{
    NamedUnit{dimensions::force, "N", 1, true},
    NamedUnit{dimensions::force, "lbf", pound_force, false},
    NamedUnit{dimensions::force, "dyn", 1e-5, false},
    NamedUnit{dimensions::stress, "Pa", 1, true},
    NamedUnit{dimensions::stress, "Mbar", 1e11, false},
    NamedUnit{dimensions::stress, "psi", pound_force / (inch * inch), false},
    NamedUnit{dimensions::stress, "psf", pound_force / (foot * foot), false},
    NamedUnit{dimensions::energy, "J", 1, true},
    NamedUnit{dimensions::energy, "erg", 1e-7, false},
    NamedUnit{dimensions::energy, "in\u00b7lbf", pound_force* inch, false},
    NamedUnit{dimensions::energy, "ft\u00b7lbf", pound_force* foot, false},
};

struct Prefix {
  std::string_view name;
  double factor;
};
constexpr std::array prefixes{Prefix{"", 1},     Prefix{"k", 1e3},  Prefix{"M", 1e6},       Prefix{"G", 1e9},
                              Prefix{"T", 1e12}, Prefix{"m", 1e-3}, Prefix{"\u00b5", 1e-6}, Prefix{"n", 1e-9}};

/// Products of powers of ten are not exact.
bool are_equal(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

bool are_equal(const Dimension& a, const Dimension& b) {
  return a.length == b.length && a.mass == b.mass && a.time == b.time;
}

/// "lbf s2/in" of "lbf s^2/in", "lbf*s²/in" and "lbf-s2/in": spaces, once, where factors are parted.
std::string make_plain(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    if (rest.starts_with("\u00b2") || rest.starts_with("\u00b7")) {
      plain += rest.starts_with("\u00b2") ? '2' : ' ';
      ++i;  // two bytes
    } else if (text[i] == '*' || text[i] == '-' || text[i] == ' ' || text[i] == '\t') {
      plain += ' ';
    } else if (text[i] != '^') {
      plain += text[i];
    }
  }
  const auto are_spaces = [](char a, char b) { return a == ' ' && b == ' '; };
  plain.erase(std::unique(plain.begin(), plain.end(), are_spaces), plain.end());
  const auto first = plain.find_first_not_of(' ');
  return first == std::string::npos ? "" : plain.substr(first, plain.find_last_not_of(' ') - first + 1);
}

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> items;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    items.push_back(make_plain(text.substr(first, end - first)));
    first = end + 1;
  }
  return items;
}

template <std::size_t N>
std::optional<BaseUnit> find_unit(const std::array<KnownUnit, N>& known, const std::string& text) {
  const auto unit = std::find_if(known.begin(), known.end(), [&](const KnownUnit& u) { return u.plain == text; });
  if (unit == known.end()) return std::nullopt;
  return BaseUnit{std::string(unit->shown), unit->in_si, std::string(unit->plain)};
}

std::string write_power(const std::string& unit, int power) {
  const bool is_product = unit.find('/') != std::string::npos;  // lbf s2/in
  const std::string base = is_product ? "(" + unit + ")" : unit;
  return power == 1 ? base : base + (power == 2 ? "\u00b2" : power == 3 ? "\u00b3" : fmt::format("^{}", power));
}

}  // namespace

std::string Units::text() const {
  const std::string base = fmt::format("{}, {}, {}", length.plain, mass.plain, time.plain);
  return temperature.empty() ? base : base + ", " + temperature;
}

double Units::in_si(const Dimension& quantity) const {
  return std::pow(length.in_si, quantity.length) * std::pow(mass.in_si, quantity.mass) *
         std::pow(time.in_si, quantity.time);
}

std::string Units::name_of(const Dimension& quantity) const {
  if (are_equal(quantity, dimensions::mass)) return mass.name;
  const double size = in_si(quantity);
  for (const NamedUnit& unit : named_units) {
    if (!are_equal(unit.quantity, quantity)) continue;
    for (const Prefix& prefix : prefixes) {
      if (are_equal(size, unit.in_si * prefix.factor)) return std::string(prefix.name) + std::string(unit.name);
      if (!unit.takes_prefixes) break;
    }
  }
  std::string above, below;
  int factors_below = 0;
  const auto add = [&](const std::string& unit, int power) {
    if (power == 0) return;
    std::string& side = power > 0 ? above : below;
    side += (side.empty() ? "" : "\u00b7") + write_power(unit, std::abs(power));
    factors_below += power < 0 ? 1 : 0;
  };
  add(mass.name, quantity.mass);
  add(length.name, quantity.length);
  add(time.name, quantity.time);
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (factors_below > 1 ? "(" + below + ")" : below);
}

std::optional<Units> find_units(std::string_view text) {
  if (text == "SI") text = "m, kg, s";
  const std::vector<std::string> items = split_at_commas(text);
  if (items.size() < 3 || items.size() > 4) return std::nullopt;
  const auto length = find_unit(lengths, items[0]), mass = find_unit(masses, items[1]),
             time = find_unit(times, items[2]);
  if (!length || !mass || !time) return std::nullopt;
  if (items.size() == 3) return Units{*length, *mass, *time, ""};
  if (std::find(temperatures.begin(), temperatures.end(), items[3]) == temperatures.end()) return std::nullopt;
  return Units{*length, *mass, *time, items[3]};
}

std::vector<std::string> list_unit_systems() {
  return {"m, kg, s",  "mm, t, s", "mm, kg, ms",       "mm, g, ms",  "mm, kg, s",
          "cm, g, us", "cm, g, s", "in, lbf s2/in, s", "ft, slug, s"};
}

std::string list_base_units() {
  std::string text;
  const auto add = [&](const auto& known) {
    text += text.empty() ? "" : ";";
    for (const KnownUnit& unit : known) {
      if (!text.empty()) text += ' ';
      text += unit.plain;
    }
  };
  add(lengths);
  add(masses);
  add(times);
  return text;
}

std::string unit_suffix(const std::string& units, const Dimension& quantity) {
  const auto found = find_units(units);
  return found ? fmt::format(" {}", found->name_of(quantity)) : "";
}

}  // namespace percuss
