#pragma once
// A deck after reading: plain data, checked value by value, in the units that the user chose.
//
// docs/deck.md documents every key with unit, default and range; the tables of keys (src/deck/reading/deck_keys.cpp and
// those of its sections) map keys to these members.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/deck/contact_deck.hpp"
#include "src/deck/element_deck.hpp"
#include "src/deck/functions/selector.hpp"
#include "src/deck/load_deck.hpp"
#include "src/deck/material_deck.hpp"
#include "src/deck/mesh_changes.hpp"
#include "src/deck/output_deck.hpp"
#include "src/deck/part_deck.hpp"
#include "src/deck/sensor_deck.hpp"
#include "src/deck/spring_deck.hpp"
#include "src/deck/start_deck.hpp"
#include "src/deck/yaml/key_places.hpp"
#include "src/warning.hpp"

namespace percuss {

struct TimeDeck {
  double end = 0;
  std::string until;  // a sensor that ends the run before; empty: none
  double step_scale = 0.9;
  /// Estimate of the stable step: the least bound of an element, or the largest eigenvalue of the mesh, estimated now
  /// and then.
  enum class StepEstimate { element, global };
  StepEstimate step_estimate = StepEstimate::element;
  std::optional<MassScalingDeck> mass_scaling;  // of every part
  std::optional<double> max_step;               // upper bound of the step [s]
  std::optional<long> max_steps;                // stop as "completed" after so many
  double collapse_ratio = 1e-4;                 // a step below this share of the first one is an error
};

struct AuditDeck {
  double max_energy_error = 0.1;     // relative; a run that leaves it stops with exit code 3
  double max_momentum_error = 1e-6;  // relative, linear and angular; as above
  // Energy that contact may give / largest energy, beyond which the run stops with exit code 3; none: it warns.
  std::optional<double> max_contact_gain;
};

struct Deck {
  // Not inline: every source would compile them, which takes longer than the rest of this header.
  Deck();
  Deck(const Deck&);
  Deck(Deck&&) noexcept;
  Deck& operator=(const Deck&);
  Deck& operator=(Deck&&) noexcept;
  ~Deck();

  std::string file;  // as given on the command line
  std::string text;  // of the file, without what --set changes
  std::string title;
  std::string units;
  TimeDeck time;
  std::vector<PartDeck> parts;        // in the order of the deck
  std::vector<MirrorDeck> mirrors;    // whose images are among the parts
  std::vector<PatternDeck> patterns;  // likewise
  std::vector<PlaceDeck> placements;  // in the order of the deck
  std::vector<JoinDeck> joins;
  std::vector<MaterialDeck> materials;
  std::vector<ImperfectionDeck> imperfections;
  std::vector<AddedMassDeck> added_masses;
  std::vector<RigidSetDeck> rigid_sets;
  std::vector<SpringDeck> springs;
  std::vector<WeldDeck> welds;
  std::vector<ConstraintDeck> constraints;
  std::vector<EmbeddedDeck> embedded;
  std::vector<JointDeck> joints;
  std::vector<TurnSpringDeck> turn_springs;
  ElementDeck elements;
  ErosionDeck erosion;
  std::vector<InitialDeck> initial;
  StartDeck start;
  std::vector<SensorDeck> sensors;
  GravityDeck gravity;
  std::vector<PressureDeck> pressures;
  std::vector<NodalLoadDeck> nodal_loads;
  std::vector<ConditionDeck> conditions;
  std::vector<DampingDeck> dampings;  // of several that name a node the last one holds
  std::vector<WallDeck> walls;
  ContactDeck contact;
  OutputDeck output;
  AuditDeck audit;
  std::vector<std::string> motion_values;  // "time.step_scale = 0.9": all that the motion depends on (deck_values.hpp)
  std::vector<std::string> settings;       // the --set arguments
  std::vector<std::string> overrides;      // left sides of the --set arguments
  KeyPlaces places;                        // of its keys
  std::vector<UsedSelector> selectors;     // all of the deck
  std::vector<Warning> warnings;           // of the deck alone; what is silenced is still among them
  std::set<std::string> silenced;          // rules whose warnings are not shown (src/output/warning_log.hpp)
  std::string resolved;                    // all its values, with the --set arguments, as JSON (yaml/deck_json.hpp)

  /// "deck.yaml:LINE:COLUMN" or "--set KEY" for messages found after reading (meshing, selection).
  std::string where(Place place) const;

  /// Settings of a part: its own, and those of the whole scene where it has none.
  ElementDeck find_elements(std::size_t part) const { return find_settings(elements, parts[part].own_elements); }
  /// Mass scaling of a part: its own, or that of the whole scene; null: its masses stay.
  const MassScalingDeck* find_mass_scaling(std::size_t part) const;
  /// Whether any part is given mass during the run.
  bool scales_mass_in_run() const;
};

}  // namespace percuss
