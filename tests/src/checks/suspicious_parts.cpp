// Sizes and places of parts, and contact.

#include "tests/src/checks/suspicious_decks.hpp"

namespace percuss {
namespace {

const std::string plate = "plate: {box: {size: [0.1, 0.1, 0.01], cells: [6, 6, 3]}, material: aluminium}";

/// Another part after the plate.
std::pair<std::string, std::string> add_part(const std::string& part) { return {plate, plate + "\n  " + part}; }

std::vector<SuspiciousDeck> size_decks() {
  return {
      {"BlockInMillimetres",
       "part_size",
       "box: {size: [200, 200, 200]",
       {{"0.02, 0.02, 0.02", "200, 200, 200"}},
       {{"0.02, 0.02, 0.02", "20, 20, 20"}}},
      {"BlockInKilometres",
       "part_size",
       "box: {size: [2e-5",
       {{"0.02, 0.02, 0.02", "2e-5, 2e-5, 2e-5"}},
       {{"0.02, 0.02, 0.02", "2e-4, 2e-4, 2e-4"}}},
      {"ThicknessInMillimetres",
       "shell_thickness",
       "thickness: 2,",
       {{"thickness: 0.002", "thickness: 2"}},
       {{"thickness: 0.002", "thickness: 0.04"}}},
      {"ThicknessInKilometres",
       "shell_thickness",
       "thickness: 5e-7",
       {{"thickness: 0.002", "thickness: 5e-7"}},
       {{"thickness: 0.002", "thickness: 2e-6"}}},
      {"PlateOfOneLayer",
       "single_layer",
       "box: {size: [0.1, 0.1, 0.004]",
       {{"0.01], cells: [6, 6, 3]", "0.004], cells: [6, 6, 1]"}},
       {{"0.01], cells: [6, 6, 3]", "0.004], cells: [6, 6, 2]"}}},
      {"TubeOfOneLayer",
       "single_layer",
       "tube: {inner_radius",
       {add_part("pipe: {tube: {inner_radius: 0.048, outer_radius: 0.05, length: 0.1, cells: [1, 16, 4]}, at: [0.3, 0, "
                 "0], material: steel}")},
       {add_part("pipe: {tube: {inner_radius: 0.02, outer_radius: 0.05, length: 0.1, cells: [1, 16, 4]}, at: [0.3, 0, "
                 "0], material: steel}")}},
      {"CopyThatWasNotMoved",
       "duplicate_part",
       "copy: {",
       {add_part("copy: {box: {size: [0.1, 0.1, 0.01], cells: [6, 6, 3]}, material: aluminium}")},
       {add_part("copy: {box: {size: [0.1, 0.1, 0.01], cells: [6, 6, 3]}, at: [0.101, 0, 0], material: aluminium}")}},
      {"HalfTubeThatWasNotMoved",
       "duplicate_part",
       "right: {",
       {add_part("left: {tube: {inner_radius: 0.04, outer_radius: 0.05, length: 0.1, arc: 200, cells: [2, 8, 4]}, at: "
                 "[0.3, 0, 0], material: steel}\n  right: {tube: {inner_radius: 0.04, outer_radius: 0.05, length: 0.1, "
                 "arc: 200, cells: [2, 8, 4]}, at: [0.3, 0, 0], material: steel}")},
       {add_part("left: {tube: {inner_radius: 0.04, outer_radius: 0.05, length: 0.1, arc: 300, cells: [2, 10, 4]}, at: "
                 "[0.3, 0, 0], material: steel}\n  right: {tube: {inner_radius: 0.04, outer_radius: 0.05, length: 0.1, "
                 "arc: 300, cells: [2, 10, 4]}, rotate: [{axis: z, angle: 60}], at: [0.3, 0, 0], material: steel}")}},
      {"BlockInsideABlock",
       "enclosed_part",
       "pea: {",
       {add_part("pea: {sphere: {radius: 0.002, cells: 3}, at: [0.05, 0.05, 0.0211], material: steel}")},
       {add_part("pea: {sphere: {radius: 0.002, cells: 3}, at: [0.05, 0.05, 0.034], material: steel}")}},
      {"AngleInRadians",
       "angle_in_radians",
       "angle: 1.5708",
       {{"at: [0.04, 0.04, 0.0111]", "rotate: [{axis: z, angle: 1.5708}], at: [0.04, 0.04, 0.0111]"}},
       {{"at: [0.04, 0.04, 0.0111]", "rotate: [{axis: z, angle: 1.6}], at: [0.04, 0.04, 0.0111]"}}},
      {"AngleInRadiansAfterAnAxis",
       "angle_in_radians",
       "angle: -0.7854",
       {{"at: [0.04, 0.04, 0.0111]", "axis: x, rotate: [{axis: z, angle: -0.7854}], at: [0.04, 0.04, 0.0211]"}},
       {{"at: [0.04, 0.04, 0.0111]", "axis: x, rotate: [{axis: z, angle: -45}], at: [0.04, 0.04, 0.0311]"}}},
      {"ArcInRadians",
       "angle_in_radians",
       "arc: 3.1416",
       {add_part("arch: {tube: {inner_radius: 0.04, outer_radius: 0.05, length: 0.1, arc: 3.1416, cells: [2, 8, 4]}, "
                 "at: [0.3, 0, 0], material: steel}")},
       {add_part("arch: {tube: {inner_radius: 0.04, outer_radius: 0.05, length: 0.1, arc: 180, cells: [2, 8, 4]}, at: "
                 "[0.3, 0, 0], material: steel}")}},
  };
}

std::vector<SuspiciousDeck> contact_decks() {
  const std::string surfaces = "contact: {surfaces: all, friction: 0.2}";
  return {
      {"BlockInsideThePlate", "deep_overlap", "block: {", {{"0.0111", "0.006"}}, {{"0.0111", "0.0095"}}},
      {"SheetThickerThanItsGap",
       "deep_overlap",
       "thickness: 0.02",
       {{"thickness: 0.002", "thickness: 0.02"}},
       {{"thickness: 0.002", "thickness: 0.0085"}}},
      {"ThicknessOfMetres",
       "deep_overlap",
       "thickness: 2,",
       {{"thickness: 0.002", "thickness: 2"}},
       {{"thickness: 0.002", "thickness: 0.0079"}}},
      {"OverlapThatIsPushedOut",
       "deep_overlap",
       "block: {",
       {{"0.0111", "0.0085"}, {surfaces, "contact: {surfaces: all, overlap: push_out}"}},
       {{"0.0111", "0.0095"}, {surfaces, "contact: {surfaces: all, overlap: push_out}"}}},
      {"WallAboveTheSheet",
       "behind_wall",
       "{point: [0, 0, 0.02]",
       {{"point: [0, 0, -0.01]", "point: [0, 0, 0.02]"}},
       {{"point: [0, 0, -0.01]", "point: [0, 0, -0.0041]"}}},
      {"WallThatLooksDown", "behind_wall", "{point: [0, 0, -0.01]", {{"normal: z", "normal: -z"}}, {}},
      {"SpringsForAFastBlock",
       "penalty_speed",
       "enforcement: penalty, penalty_scale: 1e-4",
       {{surfaces, "contact: {surfaces: all, enforcement: penalty, penalty_scale: 1e-4}"}},
       {{surfaces, "contact: {surfaces: all, enforcement: penalty, penalty_scale: 0.02}"}}},
      {"FrictionInPercent",
       "friction",
       "friction: 20}\noutput",
       {{surfaces, "contact: {surfaces: all, friction: 20}"}},
       {{surfaces, "contact: {surfaces: all, friction: 1.5}"}}},
      {"FrictionOfAWallInPercent",
       "friction",
       "friction: 20}]",
       {{"friction: 0.2}]", "friction: 20}]"}},
       {{"friction: 0.2}]", "friction: 2}]"}}},
      {"FrictionOfAPairInPercent",
       "friction",
       "friction: 30}",
       {{surfaces, "contact: {surfaces: [{a: block, b: plate, friction: 30}, [plate, sheet]]}"}},
       {{surfaces, "contact: {surfaces: [{a: block, b: plate, friction: 0.3}, [plate, sheet]]}"}}},
      {"TieThatReachesThroughThePlate",
       "tie_distance",
       "distance: 0.02",
       {{surfaces, "contact: {surfaces: all, ties: [{a: sheet, b: plate, distance: 0.02}]}"}},
       {{surfaces, "contact: {surfaces: all, ties: [{a: sheet, b: plate, distance: 0.016}]}"}}},
      {"BeamThatABodyHits",
       "beam_contact",
       "bar: {line",
       {add_part("bar: {line: {from: [0, 0.05, 0.0105], to: [0.1, 0.05, 0.0106], cells: 4}, section: {round: {radius: "
                 "0.0002}}, material: steel}")},
       {add_part("bar: {line: {from: [0, 0.05, 0.05], to: [0.1, 0.05, 0.06], cells: 4}, section: {round: {radius: "
                 "0.0002}}, material: steel}")}},
      {"NoContactSection",
       "no_contact",
       "parts:",
       {{surfaces, ""}},
       {{surfaces, ""}, {"velocity: [0, 0, -20]", "velocity: [0, 0, 20]"}}},
      {"PartsOfOneMotionWithoutContact",
       "no_contact",
       "parts:",
       {{surfaces, ""}},
       {{surfaces, ""},
        {"velocity: [0, 0, -20]", "velocity: [0, 0, 20]"},
        add_part(
            "rider: {box: {size: [0.01, 0.01, 0.01], cells: [2, 2, 2]}, at: [0.04, 0.04, 0.0312], material: steel}"),
        {"initial: [", "initial: [{part: rider, velocity: [0, 0, 20]}, "}}},
      {"PartsThatOverlapAtTheStartWithoutContact",
       "no_contact",
       "parts:",
       {{surfaces, ""}},
       {{surfaces, ""}, {"0.0111", "0.0095"}, {"velocity: [0, 0, -20]", "velocity: [0, 0, 20]"}}},
      {"ContactSwitchedOff",
       "no_contact",
       "contact: {",
       {{surfaces, "contact: {surfaces: none}"}},
       {{surfaces, "contact: {surfaces: none, ties: [{a: block/z_min, b: plate/z_max, distance: 0.0015}]}"}}},
      {"PartInNoPair",
       "no_contact",
       "surfaces: [[plate, sheet]]",
       {{surfaces, "contact: {surfaces: [[plate, sheet]]}"}},
       {{surfaces, "contact: {surfaces: [[plate, sheet], [block, plate]]}"}}},
      {"LayerInNoPairThatIsNotJoined",
       "no_contact",
       "surfaces: [[block, plate], [plate, sheet]]",
       {add_part("skin: {box: {size: [0.1, 0.1, 0.001], cells: [6, 6, 1]}, at: [0, 0, 0.01], material: aluminium}"),
        {surfaces, "contact: {surfaces: [[block, plate], [plate, sheet]]}"}},
       {add_part("skin: {box: {size: [0.1, 0.1, 0.001], cells: [6, 6, 1]}, at: [0, 0, 0.01], material: aluminium}"),
        {surfaces, "contact: {surfaces: [[block, plate], [plate, sheet]]}\njoin: [{parts: [plate, skin]}]"}}},
      {"PenaltyScaleOfAnotherEnforcement",
       "key_without_effect",
       "penalty_scale: 0.1",
       {{surfaces, "contact: {surfaces: all, penalty_scale: 0.1}"}},
       {{surfaces, "contact: {surfaces: all, enforcement: penalty, penalty_scale: 0.1}"}}},
  };
}

}  // namespace

std::vector<SuspiciousDeck> suspicious_parts() {
  std::vector<SuspiciousDeck> all = size_decks();
  for (const SuspiciousDeck& deck : contact_decks()) all.push_back(deck);
  return all;
}

}  // namespace percuss
