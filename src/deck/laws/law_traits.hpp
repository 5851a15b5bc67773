#pragma once
// What the laws of materials can do, by name: for checks, messages, `percuss schema` and the importer. Nothing else
// lists laws. Everything follows from the laws themselves.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

struct LawTraits {
  std::string name;
  bool takes_equation_of_state = false, needs_equation_of_state = false;
  /// The stress at the end of a step is that at its beginning and an increment: it may begin with any, and the elastic
  /// constants do not change.
  bool grows_in_increments = false;
  bool is_of_shells = false, is_of_beams = false;
  bool is_compiled_in = false;      // elements call it without a branch
  bool has_plastic_strain = false;  // its history has the equivalent plastic strain
  bool has_temperature = false;
  bool has_void_fraction = false;
  bool deletes_points = false;  // whatever the constants; their elements erode
  bool has_axes = false;        // directions of its own, by which a shell of it is a laminate
  bool is_of_membranes_alone = false;
  bool is_skin = false;  // shells alone, which are not computed
};

/// Traits of all laws, in their order.
const std::vector<LawTraits>& list_law_traits();

/// Whether the elements of a part are not computed: they are rigid, or a skin.
bool is_uncomputed(const Deck& deck, std::size_t part);

/// Traits of a law; for a name that is no law, which the deck reader refuses, those of one that can do nothing.
const LawTraits& find_traits(const std::string& model);
const LawTraits& find_traits(const MaterialDeck& material);

/// Whether its stress follows from the stretch, so that it may be as large as the moduli: rubber and foam, and laws of
/// a library that store energy.
bool is_stretched_far(const MaterialDeck& material);

/// "elastic, j2_plasticity and johnson_cook": those with a trait.
std::string name_laws(bool LawTraits::*trait);

/// Whether the stress at the end of a step is that at its beginning and an increment: not with an equation of state.
bool grows_in_increments(const MaterialDeck& material);

}  // namespace percuss
