#include "src/deck/laws/material_properties.hpp"

#include <limits>

#include "src/deck/laws/make_material.hpp"
#include "src/deck/range.hpp"

namespace percuss {

const Range& find_range(KeyRange range) {
  // Outside this range the bulk or shear modulus is not positive.
  static const Range poissons_ratio{"between -1 and 0.5, both excluded", -1, 0.5, true, true};
  static const Range share{"from 0 to 1", 0, 1};
  static const Range above_one{"above 1", 1, std::numeric_limits<double>::infinity(), true};
  static const Range not_positive{"zero or negative", -std::numeric_limits<double>::infinity(), 0};
  switch (range) {
    case KeyRange::positive:
      return positive;
    case KeyRange::not_negative:
      return not_negative;
    case KeyRange::not_positive:
      return not_positive;
    case KeyRange::above_one:
      return above_one;
    case KeyRange::share:
      return share;
    case KeyRange::poissons_ratio:
      return poissons_ratio;
    case KeyRange::any:
      break;
  }
  return any_number;
}

std::string find_code_file(const LawDeck& law) {
  for (const char* key : {"vumat", "vuhard", "law"})
    if (const auto file = law.texts.find(key); file != law.texts.end()) return file->second;
  return {};
}

bool has_scalar(const MaterialDeck& material, HistoryScalar name) {
  bool found = name == HistoryScalar::internal_energy && material.equation_of_state.has_value();
  visit_law(material, [&]<class Law>([[maybe_unused]] const Law& law) {
    if constexpr (requires { law.find_scalar(name); }) found = found || law.find_scalar(name) >= 0;
    if constexpr (requires { Law::history_names; }) {
      for (const HistoryScalar own : Law::history_names) found = found || own == name;
    }
  });
  return found;
}

int count_state_variables(const MaterialDeck& material) {
  int count = 0;
  visit_law(material, [&]([[maybe_unused]] const auto& law) {
    if constexpr (requires { law.count_states(); }) count = law.count_states();
  });
  return count;
}

std::vector<double> find_yields_of_code(const MaterialDeck& material) {
  std::vector<double> yields;
  visit_law(material, [&]([[maybe_unused]] const auto& law) {
    if constexpr (requires { law.find_first_yield(0.0, 0.0); })
      yields = {law.find_first_yield(0, 0), law.find_first_yield(1e-3, 1)};
  });
  return yields;
}

LameConstants find_moduli(const MaterialDeck& material) {
  LameConstants moduli;
  visit_law(material, [&](const auto& law) { moduli = law.moduli(); });
  if (material.equation_of_state) {
    visit_state(*material.equation_of_state, [&](const auto& state) {
      moduli.lambda = find_start_modulus(state, material.density) - 2.0 / 3.0 * moduli.mu;
    });
  }
  return moduli;
}

}  // namespace percuss
