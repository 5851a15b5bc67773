#pragma once
// What a deck wants written besides the summary: frames, history, checkpoints.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/deck/functions/selector.hpp"

namespace percuss {

struct HistoryPoint {
  std::string name;  // heading in history.csv
  bool is_element = false;
  bool is_inside = false;    // a material point inside the element that holds `near` at time 0, no node
  std::optional<int> layer;  // of an element: one of the points across the thickness of shells, from 1, the lowest
  std::optional<Vec3> near;  // closest node or element centre at time 0
  std::optional<long> id;    // or the id of an Exodus mesh (1-based)
  std::string part;          // searched part; empty: the whole mesh
  Place place;
};

/// Fields of one point across the thickness of shells are called by one of these and its number, from 1, the lowest.
inline constexpr std::string_view stress_points = "stress_point_",
                                  plastic_strain_points = "equivalent_plastic_strain_point_",
                                  fibre_damage_points = "fibre_damage_point_",
                                  matrix_damage_points = "matrix_damage_point_";
inline constexpr std::string_view point_quantities[] = {stress_points, plastic_strain_points, fibre_damage_points,
                                                        matrix_damage_points};

/// Fields of a law's state variables are called by this and a number, from 1.
inline constexpr std::string_view state_variables = "state_variable_";
inline constexpr int most_state_variables = 72;

/// The number at the end of such a name; empty: the field is another.
std::optional<int> find_field_number(std::string_view field, std::string_view quantity);

/// Most forces of contact and of walls in a history.
inline constexpr std::size_t most_forces_of_contact = 32;

/// A force in the history; exactly one of the kinds.
struct ForceDeck {
  enum class Kind {
    contact,  // on parts or surfaces, from others or from all that they touch
    wall,     // on all bodies, from a rigid wall
    support,  // on nodes, from the conditions that hold them
    section,  // on the material behind a plane, from that ahead of it; or on nodes, from elements
  };
  std::string name;  // heading in history.csv
  Kind kind = Kind::contact;
  std::vector<Selector> on, from;  // contact: parts and surfaces; no `from`: all that is not of `on`, and the walls
  std::string wall;                // its name
  Selector where;                  // support
  std::string part;                // section; empty: every part
  Vec3 point{}, normal{1, 0, 0};   // section: a unit normal
  std::optional<Selector> nodes;   // section: those on which `elements` act; none: a plane cuts it
  std::vector<Selector> elements;  // section by nodes: parts and element sets
  // Point of the moments; default: that of a section, of one by nodes their centre at time 0, else the origin.
  std::optional<Vec3> about;
  Place place;

  /// Whether it is a sum over contacts, walls among them.
  bool is_of_contact() const { return kind == Kind::contact || kind == Kind::wall; }
};

/// An accelerometer in the history: what a node feels, along axes that move with three nodes.
struct AccelerometerDeck {
  enum class Weight { keep, remove };  // whether the acceleration of gravity counts
  std::string name;                    // heading in history.csv
  std::vector<std::string> nodes;      // names of history nodes: the origin, one along x, one in the plane of x and y
  Weight gravity = Weight::keep;
  Place place;
};

/// A text that says what the force is of, its name included: the same of forces that are the same.
std::string identify(const ForceDeck& force);

/// Formats of fields: fields.vtkhdf with its indexes, fields.exo. Each with its word in decks.
enum class FieldsFormat { vtkhdf, exodus };
inline constexpr std::array fields_formats{std::pair{"vtkhdf", FieldsFormat::vtkhdf},
                                           std::pair{"exodus", FieldsFormat::exodus}};

/// Frames of fields, in files of their own.
struct FieldsDeck {
  std::string name;  // of the entry of output.field_outputs; empty: it is output.fields
  // Entries of output.field_outputs have one of these at most; without any they cover the whole mesh.
  std::vector<Selector> elements;      // parts and element sets
  std::vector<Selector> faces;         // parts and surfaces, whose faces are written as surface elements
  std::optional<double> every;         // [time]; the first and last state are always written; none: nothing is written
  std::optional<long> before_failure;  // steps between the frames kept in memory for a run that fails
  std::vector<FieldsFormat> formats = {FieldsFormat::vtkhdf};  // each once, at least one
  std::vector<std::string> write;  // names as listed in docs/output.md; displacement is always written
  Place place;

  bool has_format(FieldsFormat format) const {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  }
  bool is_of_region() const { return !elements.empty() || !faces.empty(); }
  /// Where it stands in the deck.
  std::string key() const { return name.empty() ? "output.fields" : "output.field_outputs." + name; }
};

struct OutputDeck {
  FieldsDeck fields;
  std::vector<FieldsDeck> field_outputs;
  std::optional<double> history_every;  // s; 0: every step
  std::vector<HistoryPoint> points;
  std::vector<Selector> blocks;      // element blocks and element sets, each with columns of its own
  std::vector<std::string> motions;  // parts with columns of their mean motion
  std::vector<ForceDeck> forces;
  std::vector<AccelerometerDeck> accelerometers;
  std::optional<double> checkpoint_every;  // simulated time [time]
  std::optional<double> checkpoint_wall;   // of the clock [s]
  bool checkpoint_at_end = true;           // whether one is left at the end

  /// Outputs that are written, output.fields first.
  std::vector<const FieldsDeck*> list_fields() const {
    std::vector<const FieldsDeck*> list;
    if (fields.every) list.push_back(&fields);
    for (const FieldsDeck& more : field_outputs)
      if (more.every) list.push_back(&more);
    return list;
  }
  /// Whether some of them keep frames in memory.
  bool keeps_frames() const {
    const std::vector<const FieldsDeck*> list = list_fields();
    return std::any_of(list.begin(), list.end(), [](const FieldsDeck* of) { return of->before_failure.has_value(); });
  }
  /// Whether one of them has the field.
  bool writes(const std::string& field) const {
    const auto has = [&](const FieldsDeck* of) {
      return std::find(of->write.begin(), of->write.end(), field) != of->write.end();
    };
    const std::vector<const FieldsDeck*> list = list_fields();
    return std::any_of(list.begin(), list.end(), has);
  }
};

}  // namespace percuss
