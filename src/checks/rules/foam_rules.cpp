// Curves of foam for several rates that contradict each other or the scene.

#include <optional>

#include "kernels/material/laws/rate_table_foam.hpp"
#include "src/checks/rules.hpp"
#include "src/deck/laws/make_law.hpp"

namespace percuss {
namespace {

constexpr const char* key = "compression_at_rates";

/// Where a curve lies below that of a lower rate.
struct Crossing {
  double low_rate, high_rate, strain;
};

std::optional<Crossing> find_crossing(const RateTableFoam& law) {
  constexpr double much = 0.02;  // share of the stress: measured curves lie so close
  const RateCurves& curves = law.compression;
  for (int k = 0; k + 1 < curves.rates; ++k) {
    for (int i = curves.first[k]; i < curves.first[k + 2]; ++i) {
      const double strain = curves.x[i];
      if (!(strain > 0)) continue;
      if (law.find_line(k + 1, strain).value < (1 - much) * law.find_line(k, strain).value)
        return Crossing{curves.rate[k], curves.rate[k + 1], strain};
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Warning> check_foam_rates(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (material.law.model != RateTableFoam::name) continue;
    const RateTableFoam law = make_law<RateTableFoam>(material.law);
    const auto warn = [&](const std::string& text) {
      warnings.push_back(warn_at(scene.deck, "foam_rates", "materials." + material.name + "." + key, text));
    };
    if (const auto crossing = find_crossing(law)) {
      warn(
          fmt::format("the curve of material '{}' at the rate {:g} lies below that at {:g} at a strain of {:.3g} (its "
                      "curves cross; foam resists more at higher rates): correct the rows, or remove the noise of "
                      "the test",
                      material.name, crossing->high_rate, crossing->low_rate, crossing->strain));
    }
    const double strain = law.compression.rate[0] * scene.deck.time.end;
    if (law.compression.rates > 1 && strain > 1) {
      warn(
          fmt::format("the lowest rate of material '{}' is {:g}, at which the run strains it by {:.2g} (no curve is "
                      "near rest, and unloading follows that of the lowest rate): add a slow curve, or check the unit "
                      "of the rates",
                      material.name, law.compression.rate[0], strain));
    }
  }
  return warnings;
}

}  // namespace percuss
