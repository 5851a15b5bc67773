#include "src/deck/laws/law_traits.hpp"

#include <algorithm>
#include <iterator>

#include "kernels/beam/fibre_laws.hpp"
#include "kernels/shell/layer_of_law.hpp"
#include "src/deck/laws/make_material.hpp"

namespace percuss {
namespace {

template <class Law>
constexpr bool remembers(HistoryScalar name) {
  if constexpr (requires { Law::history_names; })
    return std::find(std::begin(Law::history_names), std::end(Law::history_names), name) !=
           std::end(Law::history_names);
  else
    return false;
}

template <class Law>
LawTraits find_traits_of() {
  LawTraits traits;
  traits.name = Law::name;
  traits.takes_equation_of_state = takes_equation_of_state<Law>;
  traits.needs_equation_of_state = needs_equation_of_state<Law>;
  traits.grows_in_increments = GrowingLaw<Law>;
  traits.is_skin = std::is_same_v<Law, Skin>;
  traits.is_of_shells = LayerLaw<Law> || traits.is_skin;
  traits.is_of_membranes_alone = !is_of_solids<Law> && !traits.is_skin;
  traits.is_of_beams = BeamLaw<Law>;
  traits.is_compiled_in = requires { requires Law::is_compiled_in; };
  traits.has_plastic_strain = remembers<Law>(HistoryScalar::equivalent_plastic_strain);
  traits.has_temperature = remembers<Law>(HistoryScalar::temperature) || requires(const Law& law) {
    law.find_temperature();
  };
  traits.has_void_fraction = remembers<Law>(HistoryScalar::void_fraction);
  traits.deletes_points = remembers<Law>(HistoryScalar::remains);
  traits.has_axes = requires { &Law::Constants::follows_elements; };
  return traits;
}

template <class... Laws>
std::vector<LawTraits> list_traits(TypeList<Laws...>) {
  return {find_traits_of<Laws>()...};
}

}  // namespace

const std::vector<LawTraits>& list_law_traits() {
  static const std::vector<LawTraits> traits = list_traits(AllLaws());
  return traits;
}

bool is_uncomputed(const Deck& deck, std::size_t part) {
  if (deck.parts[part].rigid) return true;
  const std::string& name = deck.parts[part].material;
  return std::any_of(deck.materials.begin(), deck.materials.end(), [&](const MaterialDeck& material) {
    return material.name == name && find_traits(material).is_skin;
  });
}

const LawTraits& find_traits(const std::string& model) {
  const auto& all = list_law_traits();
  const auto found = std::find_if(all.begin(), all.end(), [&](const LawTraits& law) { return law.name == model; });
  static const LawTraits none;
  return found == all.end() ? none : *found;
}

const LawTraits& find_traits(const MaterialDeck& material) { return find_traits(material.law.model); }

bool is_stretched_far(const MaterialDeck& material) {
  bool is = false;
  visit_law(material, [&]<class Law>(const Law& law) {
    if constexpr (requires { law.made.entry; })
      is = law.made.entry->stores_energy;
    else
      is = requires { requires Law::stores_energy; }
    || requires { requires Law::is_stretched_far; };
  });
  return is;
}

std::string name_laws(bool LawTraits::*trait) {
  std::vector<std::string> names;
  for (const LawTraits& law : list_law_traits())
    if (law.*trait) names.push_back(law.name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

bool grows_in_increments(const MaterialDeck& material) {
  return find_traits(material).grows_in_increments && !material.equation_of_state && material.plies.empty();
}

}  // namespace percuss
