#pragma once
// The tables of keys, one function for each section of the deck. A new key is one row in one of them, a member in
// deck.hpp and a row in docs/deck.md.

#include "src/deck/keys/keys.hpp"

namespace percuss {

/// A part: one shape, where it stands, its copies and its material.
struct PartValue {
  bool read_inside(const Reader& reader, const Node& node, PartDeck& out) const;
  Form form() const;
};

/// A material: `model` says which table its other keys come from.
struct MaterialValue {
  bool read_inside(const Reader& reader, const Node& node, MaterialDeck& out) const;
  Form form() const;
};

/// `failure` in a material.
MapValue<FailureDeck> failure_value();
MapValue<ErosionDeck> erosion_value();

MapValue<InitialDeck> initial_value();
MapValue<StartDeck> start_value();

/// A file that the deck names: relative paths are relative to the deck.
struct FileValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const;
  std::string takes() const { return "a file, relative to the deck"; }
  Form form() const { return TextValue{}.form(); }
};

/// `conditions`: each entry holds nodes in one way.
struct ConditionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ConditionDeck& out) const;
  Form form() const;
  std::string takes() const { return "a map"; }
};

MapValue<PressureDeck> pressure_value();
MapValue<NodalLoadDeck> nodal_load_value();
MapValue<DampingDeck> damping_value();
MapValue<MirrorDeck> mirror_value();
MapValue<PatternDeck> pattern_value();
/// Adds the parts that `mirror` and `pattern` make.
void add_part_images(Deck& deck, Reading& reading);
MapValue<PlaceDeck> place_value();
/// Parts and walls that `place` names, and what would not follow the parts.
void check_places(const Deck& deck, Reading& reading);
MapValue<ImperfectionDeck> imperfection_value();
MapValue<AddedMassDeck> added_mass_value();
NamedMapValue<RigidSetDeck, MapValue<RigidSetDeck>> rigid_sets_value();
NamedMapValue<JointDeck, MapValue<JointDeck>> joints_value();
NamedMapValue<TurnSpringDeck, MapValue<TurnSpringDeck>> turn_springs_value();

/// `contact`: a deck that has the section means all surfaces unless it says otherwise.
struct ContactValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ContactDeck& out) const;
  Form form() const;
  std::string takes() const { return "a map"; }
};

/// `join`: true for all parts, or a list of maps.
struct JoinValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<JoinDeck>& out) const;
  Form form() const;
  std::string takes() const { return "true | false or a list of maps"; }
};

/// `rigid` of a part: true, or a map.
struct RigidValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::optional<RigidDeck>& out) const;
  Form form() const;
  std::string takes() const { return "true | false or a map"; }
};

/// What rigid parts and sets must have in common, and what they exclude.
void check_rigid(const Deck& deck, const Node& root, Reading& reading);

/// Joints between bodies that exist.
void check_joints(const Deck& deck, const Node& root, Reading& reading);
void check_turn_springs(const Deck& deck, const Node& root, Reading& reading);

/// Loads and conditions of bodies that exist.
void check_body_names(const Deck& deck, Reading& reading);

MapValue<TimeDeck> time_value();
MapValue<MassScalingDeck> mass_scaling_value();
MapValue<ElementDeck> element_value();
/// Those of a part among the keys of `elements`.
Keys<PartElementDeck> part_element_keys();
/// What has no effect beside the other settings that hold there.
void check_element_settings(const Deck& deck, const Node& root, Reading& reading);
MapValue<OutputDeck> output_value();

/// Preloads of parts that can have them.
void check_start(const Deck& deck, const Node& root, Reading& reading);

MapValue<AuditDeck> audit_value();

const Keys<Selector>& selector_keys();

/// The deck itself.
const Keys<Deck>& deck_keys();

/// A key that a deck may hold, from the tables that the reader works by.
struct DeckKey {
  std::string path;   // "time.end"; NAME stands for a name that the user gives, N for a place in a list
  std::string takes;  // "a number, positive"
  bool required = false;
};

/// Every key, in the order of the tables.
std::vector<DeckKey> list_deck_keys();

/// The keys of a part of which it has exactly one.
const Keys<PartDeck>& shape_keys();

/// What must hold between sections: names that exist, a size that can be run, curves that stay finite.
void check_deck(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
