#include "src/step/elements/block_builder.hpp"

#include "src/deck/make_material.hpp"

namespace percuss {
namespace {

template <class Law, class Material>
std::array<int, history_scalars> find_named_history(const Material& material) {
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
  return places;
}

template <class Law, class Material>
KernelMaterial name_history(const Material& material) {
  return {material, find_named_history<Law>(material)};
}

}  // namespace

KernelMaterial make_kernel_material(const MaterialDeck& deck) {
  KernelMaterial made;
  visit_law(deck, [&]<class Law>(const Law& law) {
    if (deck.equation_of_state) {
      if constexpr (takes_equation_of_state<Law>) {
        visit_state(*deck.equation_of_state, [&](const auto& state) {
          made = name_history<Law>(make_called_material(law, deck.density, state));
        });
      }
    } else if constexpr (is_compiled_in<Law>) {
      made = name_history<Law>(law);
    } else {
      made = name_history<Law>(make_called_material(law, deck.density));
    }
  });
  return made;
}

}  // namespace percuss
