// Constants of rubber and foam that soften so far that the body is unstable.

#include <array>
#include <cmath>
#include <optional>

#include "src/checks/rules.hpp"
#include "src/deck/laws/make_material.hpp"

namespace percuss {
namespace {

using Logs = std::array<double, 3>;  // of the principal stretches

/// Derivatives of the Kirchhoff stresses by the logarithms of the stretches: diag(own) + volume everywhere.
struct Tangent {
  std::array<double, 3> own{};
  std::optional<double> volume;  // none: the volume does not change
};

/// Drucker's criterion: work of the change of stress on any change of strain is positive, with no change of volume
/// where that is not possible. The signs are those of the leading minors of the matrix, and of their limits for a large
/// volume.
bool is_stable(const Tangent& tangent) {
  const auto [a, b, c] = tangent.own;
  const double pairs = a * b + b * c + c * a;
  if (!tangent.volume) return a + b > 0 && pairs > 0;
  const double v = *tangent.volume;
  return a + v > 0 && a * b + v * (a + b) > 0 && a * b * c + v * pairs > 0;
}

/// The laws whose energy is a sum over the stretches; none of others.
template <class Law>
std::optional<Tangent> find_tangent(const Law& law, const Logs& logs) {
  Tangent tangent;
  if constexpr (requires { law.find_term(1.0); }) {
    for (std::size_t i = 0; i < 3; ++i) tangent.own[i] = law.find_term(std::exp(logs[i])).slope;
    if constexpr (requires { law.find_beta(); }) {
      const double beta = law.find_beta(), log_j = logs[0] + logs[1] + logs[2];
      tangent.volume = beta * add_powers(law.terms, std::exp(-beta * log_j)).slope;
    }
    return tangent;
  } else {
    return std::nullopt;
  }
}

/// How far the sides shrink by the stretch of a bar.
template <class Law>
double find_lateral(const Law& law) {
  if constexpr (requires { law.poissons_ratio; }) {
    return law.poissons_ratio;
  } else {
    return 0.5;
  }
}

/// The stretch nearest to 1 at which a bar (or a sheet whose width is held) is unstable, of 1/2 to 2.
template <class Law>
std::optional<double> find_unstable_stretch(const Law& law) {
  constexpr int steps = 50;
  const double lateral = find_lateral(law);
  for (int k = 1; k <= steps; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const double x = sign * k * std::log(2.0) / steps;
      for (const Logs& logs : {Logs{x, -lateral * x, -lateral * x}, Logs{x, 0, -lateral / (1 - lateral) * x}}) {
        const std::optional<Tangent> tangent = find_tangent(law, logs);
        if (tangent && !is_stable(*tangent)) return std::exp(x);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Warning> check_unstable_rubber(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    std::optional<double> stretch;
    visit_law(material, [&](const auto& law) { stretch = find_unstable_stretch(law); });
    if (!stretch) continue;
    const std::string key = material.law.tables.count("terms") == 1 ? "terms" : "uniaxial";
    warnings.push_back(warn_at(scene.deck, "unstable_rubber", "materials." + material.name + "." + key,
                               fmt::format("material '{}' is unstable at a stretch of {:.3g} (Drucker's criterion: a "
                                           "larger strain meets less stress): fit the constants again, over the "
                                           "strains of the scene",
                                           material.name, *stretch)));
  }
  return warnings;
}

}  // namespace percuss
