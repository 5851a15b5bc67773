#include "src/deck/contact/tie_keys.hpp"

#include "src/deck/keys/strength_keys.hpp"
#include "src/deck/keys/switch_keys.hpp"

namespace percuss {
namespace {

const Keys<TieDeck>& tie_failure_keys() {
  static const Keys<TieDeck> keys = strength_keys<TieDeck>();
  return keys;
}

bool check_tie_failure(const Reader& reader, const Node& node, TieDeck& tie) {
  if (tie.has_strength()) return check_strengths(reader, node, tie);
  reader.error(node.spot, fmt::format("{} names no strength (must have normal or shear)", reader.self()));
  return false;
}

const Keys<CohesiveDeck>& cohesive_keys() {
  using Mix = CohesiveDeck::Mix;
  using Onset = CohesiveDeck::Onset;
  using Softening = CohesiveDeck::Softening;
  static const Keys<CohesiveDeck> keys = {
      need("normal_stiffness", &CohesiveDeck::normal_stiffness, NumberValue{positive}),
      may("shear_stiffness", &CohesiveDeck::shear_stiffness, NumberValue{positive}),
      need("normal_strength", &CohesiveDeck::normal_strength, NumberValue{positive}),
      need("shear_strength", &CohesiveDeck::shear_strength, NumberValue{positive}),
      need("normal_energy", &CohesiveDeck::normal_energy, NumberValue{positive}),
      need("shear_energy", &CohesiveDeck::shear_energy, NumberValue{positive}),
      may("plateau", &CohesiveDeck::plateau, NumberValue{{"at least 0 and below 1", 0, 1, false, true}}),
      may("mix", &CohesiveDeck::mix,
          ChoiceValue<Mix>{{{"benzeggagh_kenane", Mix::benzeggagh_kenane}, {"power_law", Mix::power_law}}}),
      may("exponent", &CohesiveDeck::exponent, NumberValue{positive}),
      may("onset", &CohesiveDeck::onset,
          ChoiceValue<Onset>{{{"quadratic", Onset::quadratic}, {"maximum", Onset::maximum}}}),
      may("softening", &CohesiveDeck::softening,
          ChoiceValue<Softening>{{{"linear", Softening::linear}, {"exponential", Softening::exponential}}}),
  };
  return keys;
}

/// The energy that is left beside a plateau is more than what is stored as damage begins: otherwise tractions would
/// jump.
bool check_cohesive(const Reader& reader, const Node& node, CohesiveDeck& glue) {
  bool good = true;
  if (glue.plateau > 0 && glue.softening == CohesiveDeck::Softening::exponential) {
    reader.error(node.find("plateau")->spot,
                 fmt::format("{} stands beside softening: exponential (which has no constant "
                             "traction): remove one of them",
                             reader.name_of("plateau")));
    good = false;
  }
  const auto check = [&](const char* key, double energy, double strength, double stiffness) {
    const double stored = 0.5 * strength * strength / stiffness, least = stored / (1 - glue.plateau);
    if (energy > least) return;
    reader.error(
        node.find(key)->spot,
        fmt::format("{} is {:g} (must be above {:.4g}, which is stored when the strength is reached): give more "
                    "stiffness, less strength{} or more energy",
                    reader.name_of(key), energy, least, glue.plateau > 0 ? ", a smaller plateau" : ""));
    good = false;
  };
  check("normal_energy", glue.normal_energy, glue.normal_strength, glue.normal_stiffness);
  check("shear_energy", glue.shear_energy, glue.shear_strength, glue.shear_stiffness.value_or(glue.normal_stiffness));
  return good;
}

const Keys<TieDeck>& tie_keys() {
  using Sticks = TieDeck::Sticks;
  static const Keys<TieDeck> keys = with_switch<TieDeck>({
      need("a", &TieDeck::a, SelectorValue{Chosen::surface_nodes}),
      need("b", &TieDeck::b, SelectorValue{Chosen::faces}),
      may("distance", &TieDeck::distance, NumberValue{positive}),
      may("empty", &TieDeck::may_be_empty, ChoiceValue<bool>{{{"refuse", false}, {"ignore", true}}}),
      may("rotations", &TieDeck::rotations, BooleanValue{}),
      may("sticks", &TieDeck::sticks,
          ChoiceValue<Sticks>{{{"at_start", Sticks::at_start}, {"on_contact", Sticks::on_contact}}}),
      group<TieDeck>("failure", MapValue<TieDeck>{tie_failure_keys, check_tie_failure}),
      may("cohesive", &TieDeck::cohesive, MapValue<CohesiveDeck>{cohesive_keys, check_cohesive}),
  });
  return keys;
}

/// Glue begins with the run, holds no rotations and fails by its own law.
bool check_tie(const Reader& reader, const Node& node, TieDeck& tie) {
  tie.place = node.spot.place;
  if (!tie.cohesive) return true;
  bool good = true;
  const auto refuse = [&](const char* key, bool is_used) {
    if (!is_used) return;
    reader.error(node.find(key)->key,
                 fmt::format("{} has no effect with cohesive{} (glue holds places of nodes, from the "
                             "start until its law lets go): leave it out",
                             reader.name_of(key), reader.in()));
    good = false;
  };
  refuse("failure", tie.has_strength());
  refuse("rotations", tie.rotations);
  refuse("sticks", tie.sticks == TieDeck::Sticks::on_contact);
  refuse("from", !tie.when.from.empty());
  refuse("until", !tie.when.until.empty());
  return good;
}

}  // namespace

MapValue<TieDeck> tie_value() { return {tie_keys, check_tie}; }

}  // namespace percuss
