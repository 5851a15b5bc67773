#include "src/deck/reading/time_keys.hpp"

#include <limits>

#include "src/deck/keys/switch_keys.hpp"
#include "src/deck/parts/mass_keys.hpp"

namespace percuss {
namespace {

const Keys<TimeDeck>& time_keys() {
  using StepEstimate = TimeDeck::StepEstimate;
  static const Keys<TimeDeck> keys = {
      need("end", &TimeDeck::end, NumberValue{positive}),
      may("step_scale", &TimeDeck::step_scale, NumberValue{{"above 0, at most 1", 0, 1, true}}),
      may("step_estimate", &TimeDeck::step_estimate,
          ChoiceValue<StepEstimate>{{{"element", StepEstimate::element}, {"global", StepEstimate::global}}}),
      may("mass_scaling", &TimeDeck::mass_scaling, mass_scaling_value()),
      may("until", &TimeDeck::until, SensorNameValue{}),
      may("max_step", &TimeDeck::max_step, NumberValue{positive}),
      may("max_steps", &TimeDeck::max_steps, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("collapse_ratio", &TimeDeck::collapse_ratio, NumberValue{{"at least 0 and below 1", 0, 1, false, true}}),
  };
  return keys;
}

const Keys<AuditDeck>& audit_keys() {
  static const Keys<AuditDeck> keys = {
      may("max_energy_error", &AuditDeck::max_energy_error, NumberValue{positive}),
      may("max_momentum_error", &AuditDeck::max_momentum_error, NumberValue{positive}),
      may("max_contact_gain", &AuditDeck::max_contact_gain, NumberValue{positive}),
  };
  return keys;
}

}  // namespace

MapValue<TimeDeck> time_value() { return {time_keys}; }
MapValue<AuditDeck> audit_value() { return {audit_keys}; }

}  // namespace percuss
