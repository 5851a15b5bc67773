#include "src/deck/make_material.hpp"

namespace percuss {

bool has_scalar(const MaterialDeck& material, HistoryScalar name) {
  bool found = name == HistoryScalar::internal_energy && material.equation_of_state.has_value();
  visit_law(material, [&]<class Law>(const Law&) {
    if constexpr (requires { Law::history_names; }) {
      for (const HistoryScalar own : Law::history_names) found = found || own == name;
    }
  });
  return found;
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
