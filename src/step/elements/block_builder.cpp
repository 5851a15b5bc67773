#include "src/step/elements/block_builder.hpp"

#include "src/deck/laws/make_material.hpp"

namespace percuss {
namespace {

template <class Law, class Material>
std::array<int, history_scalars> find_named_history(const Law& law, const Material& material) {
  std::array<int, history_scalars> places;
  places.fill(-1);
  int place = 0;
  if constexpr (is_called<Material>) {
    place = CalledMaterial::law_place;
    places[static_cast<std::size_t>(HistoryScalar::internal_energy)] = material.find_state_place();
  }
  if constexpr (requires { Law::history_names; }) {
    for (const HistoryScalar name : Law::history_names) places[static_cast<std::size_t>(name)] = place++;
  }
  if constexpr (requires { law.find_scalar(HistoryScalar::none); }) {
    for (int i = 0; i < history_scalars; ++i) {
      const int found = law.find_scalar(static_cast<HistoryScalar>(i));
      if (found >= 0) places[static_cast<std::size_t>(i)] = CalledMaterial::law_place + found;
    }
  }
  if constexpr (requires { law.count_states(); }) {
    const int first = CalledMaterial::law_place + law.first_state();
    if (law.count_states() > 0) {
      places[static_cast<std::size_t>(HistoryScalar::first_state)] = first;
      places[static_cast<std::size_t>(HistoryScalar::after_states)] = first + law.count_states();
    }
  }
  if constexpr (requires { law.find_deletion(); }) {
    const int deletion = law.find_deletion();
    if (deletion >= 0) places[static_cast<std::size_t>(HistoryScalar::remains)] = CalledMaterial::law_place + deletion;
  }
  return places;
}

template <class Law, class Material>
KernelMaterial name_history(const Law& law, const Material& material) {
  return {material, find_named_history(law, material)};
}

}  // namespace

KernelMaterial make_kernel_material(const MaterialDeck& material) {
  KernelMaterial made;
  visit_law(material, [&]<class Law>(const Law& law) {
    if (material.equation_of_state) {
      if constexpr (takes_equation_of_state<Law>) {
        visit_state(*material.equation_of_state, [&](const auto& state) {
          made = name_history(law, make_called_material(law, material.density, state));
        });
      }
    } else if constexpr (is_compiled_in<Law>) {
      made = name_history(law, law);
    } else if constexpr (is_of_solids<Law>) {
      made = name_history(law, make_called_material(law, material.density));
    }
  });
  return made;
}

}  // namespace percuss
