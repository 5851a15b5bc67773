// Velocities, conditions and loads.

#include "tests/src/checks/suspicious_decks.hpp"

namespace percuss {
namespace {

const std::string last_condition = "  - {nodes: sheet/x_min, fixed: [x, y, z, rx, ry, rz]}\n";
const std::string velocity = "{part: block, velocity: [0, 0, -20]}";
const std::pair<std::string, std::string> no_walls{"walls: [{point: [0, 0, -0.01], normal: z, friction: 0.2}]\n", ""};
const std::pair<std::string, std::string> no_holding{
    "conditions:\n  - {nodes: plate/x_min, fixed: [x, y, z]}\n  - {nodes: sheet/x_min, fixed: [x, y, z, rx, ry, rz]}\n",
    ""};
const std::pair<std::string, std::string> upper{"  sheet: {",
                                                "  upper: {box: {size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}, at: "
                                                "[0.04, 0.04, 0.05], material: steel}\n  sheet: {"};
const std::pair<std::string, std::string> rubber{
    "j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 120e6, hardening_modulus: "
    "400e6",
    "elastic, density: 1100, youngs_modulus: 1.5e6, poissons_ratio: 0.4999"};
const std::string gravity = "loads: {gravity: [0, 0, -9.81]}\n";

std::pair<std::string, std::string> add_condition(const std::string& condition) {
  return {last_condition, last_condition + "  - " + condition + "\n"};
}

const std::string spring =
    "springs: {s: {between: [{near: [0.05, 0.05, 0.03], part: block}, {near: [0.05, 0.05, 0], part: plate}], "
    "stiffness: 1e3, rest_length: ";

std::pair<std::string, std::string> add_load(const std::string& load) {
  return {gravity, "loads: {gravity: [0, 0, -9.81], nodal: [" + load + "]}\n"};
}

std::pair<std::string, std::string> add_pressure(const std::string& value) {
  return {gravity, "loads: {gravity: [0, 0, -9.81], pressure: [{faces: plate/z_max, value: " + value + "}]}\n"};
}

std::vector<SuspiciousDeck> velocity_decks() {
  return {
      {"FixedBodyWithAVelocity",
       "stopped_velocity",
       velocity,
       {add_condition("{nodes: block, fixed: [x, y, z]}")},
       {add_condition("{nodes: block, fixed: [x, y]}")}},
      {"FixedSideWithAVelocity",
       "stopped_velocity",
       "{nodes: plate/x_min, velocity: [5",
       {{velocity, velocity + ", {nodes: plate/x_min, velocity: [5, 0, 0]}"}},
       {{velocity, velocity + ", {nodes: plate, velocity: [0, 0, 5]}"}}},
      {"VelocityAcrossASymmetryPlane",
       "stopped_velocity",
       velocity,
       {add_condition("{nodes: block, symmetry: z}")},
       {add_condition("{nodes: block/x_min, symmetry: x}")}},
      {"VelocityOfNodesThatAreDriven",
       "stopped_velocity",
       velocity,
       {add_condition("{nodes: block, velocity: {z: -5}}")},
       {add_condition("{nodes: block, velocity: {z: -20}}")}},
      {"VelocityThatAnotherEntryReplaces",
       "unused_velocity",
       velocity,
       {{velocity, velocity + ", {velocity: [0, 0, -5]}"}},
       {{velocity, velocity + ", {nodes: plate, velocity: [0, 0, -5]}"}}},
      {"VelocityInMillimetresPerSecond",
       "fast_velocity",
       "{part: block, velocity: [0, 0, -20000]",
       {{"-20]", "-20000]"}},
       {{"-20]", "-2000]"}}},
      {"SpinInTurnsPerMinute",
       "fast_velocity",
       "{part: block, angular_velocity",
       {{"velocity: [0, 0, -20]", "angular_velocity: [0, 0, 1e6]"}},
       {{"velocity: [0, 0, -20]", "angular_velocity: [0, 0, 1e4]"}}},
      {"VelocityOfOneOfTwoBodies",
       "fast_velocity",
       "{part: block, velocity: [0, 0, -20000]",
       {{"-20]", "-20000]"}, no_walls, no_holding},
       {{"-20]", "-20000]"}, no_walls, no_holding, {"{part: block, velo", "{velo"}}},
      {"UpwardVelocity", "unreached_body", "block: {", {{"-20]", "20]"}}, {{"-20]", "-10]"}}},
      {"RunThatEndsBeforeTheImpact", "unreached_body", "block: {", {{"2.0e-4", "4.0e-6"}}, {{"2.0e-4", "6.0e-5"}}},
      {"BlockThatStartsFarAway", "unreached_body", "block: {", {{"0.0111", "1.0"}}, {{"0.0111", "0.0135"}}},
      {"BlockThatAStoppedOneWouldReach", "unreached_body", "upper: {", {{"0.0111", "1.0"}, upper}, {upper}},
      {"BlockThatFliesPast",
       "unreached_body",
       "block: {",
       {{"at: [0.04,", "at: [0.2,"}, {"point: [0, 0, -0.01], normal: z, friction: 0.2", "normal: z, nodes: plate"}},
       {{"at: [0.04,", "at: [0.09,"}}},
      {"NoVelocityAtAll",
       "still_scene",
       "end: 2.0e-4",
       {{"initial: [" + velocity + "]\n", ""}, {gravity, ""}},
       {{"initial: [" + velocity + "]\n", ""}}},
      {"WallWithAMassAtRest",
       "still_scene",
       "end: 2.0e-4",
       {{"initial: [" + velocity + "]\n", ""}, {gravity, ""}, {"friction: 0.2}]\ncontact", "mass: 1}]\ncontact"}},
       {{"initial: [" + velocity + "]\n", ""}, {gravity, ""}, {"friction: 0.2}]\ncontact", "speed: 5}]\ncontact"}}},
      {"WallWithoutASpeed",
       "still_scene",
       "end: 2.0e-4",
       {{"initial: [" + velocity + "]\n", ""}, {gravity, ""}, {"friction: 0.2}]\ncontact", "speed: 0}]\ncontact"}},
       {{"initial: [" + velocity + "]\n", ""},
        {gravity, ""},
        {"friction: 0.2}]\ncontact", "mass: 1, start_speed: 5}]\ncontact"}}},
      {"BlockThatAMovingWallWouldReach",
       "unreached_body",
       "block: {",
       {{"-20]", "20]"}, {"z, friction: 0.2}]", "z}, {point: [0, 0, 1], normal: -z}]"}},
       {{"-20]", "20]"}, {"z, friction: 0.2}]", "z}, {point: [0, 0, 1], normal: -z, speed: 9000}]"}}},
      {"SheetThatNothingTouches",
       "idle_part",
       "sheet: {",
       {{last_condition, ""},
        {gravity, ""},
        {"walls: [{point: [0, 0, -0.01], normal: z, friction: 0.2}]\n", ""},
        {"surfaces: all", "surfaces: [[block, plate]]"}},
       {{gravity, ""}, {"surfaces: all", "surfaces: [[block, plate]]"}}},
      {"SheetThatNoWallMeets",
       "idle_part",
       "sheet: {",
       {{last_condition, ""}, {gravity, ""}, {"surfaces: all", "surfaces: [[block, plate]]"}},
       {{last_condition, ""},
        {gravity, ""},
        {"z, friction: 0.2}]", "z, speed: 5}]"},
        {"surfaces: all", "surfaces: [[block, plate]]"}}},
  };
}

std::vector<SuspiciousDeck> load_decks() {
  return {
      {"PrescribedVelocityInMillimetres",
       "prescribed_speed",
       "z: -15000",
       {add_condition("{nodes: block/z_max, velocity: {z: -15000}}")},
       {add_condition("{nodes: block/z_max, velocity: {z: -1500}}")}},
      {"PrescribedDisplacementInMillimetres",
       "prescribed_speed",
       "z: {table: [[0, 0], [1e-4, -5]]}",
       {add_condition("{nodes: block/z_max, displacement: {z: {table: [[0, 0], [1e-4, -5]]}}}")},
       {add_condition("{nodes: block/z_max, displacement: {z: {table: [[0, 0], [1e-4, -0.05]]}}}")}},
      {"PressureThatIsCutOff",
       "curve_end",
       "value: {table",
       {add_pressure("{table: [[0, 0], [1e-5, 2e6], [2e-5, 1e6]]}")},
       {add_pressure("{table: [[0, 0], [1e-5, 2e6], [2e-5, 0]]}")}},
      {"PressureThatIsCutOffAfterItsPeak",
       "curve_end",
       "value: {table",
       {add_pressure("{table: [[0, 0], [1e-5, 2e6], [2e-5, 1e6]]}")},
       {add_pressure("{table: [[0, 0], [1e-5, 5e5], [2e-5, 2e6]]}")}},
      {"VelocityThatIsCutOff",
       "curve_end",
       "x: {table",
       {add_condition("{nodes: plate/x_max, velocity: {x: {table: [[0, 0], [1e-5, 3], [2e-5, 1]]}}}")},
       {add_condition("{nodes: plate/x_max, velocity: {x: {table: [[0, 0], [1e-5, 3]]}}}")}},
      {"GravityThatIsCutOff",
       "curve_end",
       "{table: [[0, 0], [1e-5, -9]",
       {{"0, 0, -9.81", "0, 0, {table: [[0, 0], [1e-5, -9], [2e-5, -4]]}"}},
       {{"0, 0, -9.81", "0, 0, {table: [[0, 0], [1e-5, -9], [2e-5, 0]]}"}}},
      {"WallWhoseSpeedIsCutOff",
       "curve_end",
       "speed: {table",
       {{"z, friction: 0.2}]", "z, speed: {table: [[0, 0], [1e-5, 3], [2e-5, 1]]}}]"}},
       {{"z, friction: 0.2}]", "z, speed: {table: [[0, 0], [1e-5, 3], [2e-5, 3]]}}]"}}},
      {"PressureOverMilliseconds",
       "curve_time",
       "value: {table",
       {add_pressure("{table: [[0, 0], [0.1, 2e6], [0.2, 0]]}")},
       {add_pressure("{table: [[0, 0], [1e-4, 2e6], [0.002, 0]]}")}},
      {"PressureOverMillisecondsInTwoRows",
       "curve_time",
       "value: {table",
       {add_pressure("{table: [[0, 0], [0.1, 2e6]]}")},
       {add_condition("{nodes: block/z_max, displacement: {z: {table: [[0, 0], [1, -10]]}}}")}},
      {"PressureThatIsOverAtOnce",
       "short_pulse",
       "value: {table",
       {add_pressure("{table: [[0, 0], [1e-10, 2e6], [2e-10, 0]]}")},
       {add_pressure("{table: [[0, 0], [1e-10, 2e6], [2e-10, 3e6]]}")}},
      {"PressureThatLastsAFewSteps",
       "short_pulse",
       "value: {table",
       {add_pressure("{table: [[0, 0], [1e-8, 2e6], [2e-8, 0]]}")},
       {add_pressure("{table: [[0, 0], [1e-6, 2e6], [2e-6, 0]]}")}},
      {"ForceOnHeldNodes",
       "idle_load",
       "force: {z: -1e3",
       {add_load("{nodes: plate/x_min, force: {z: -1e3}}")},
       {add_load("{nodes: plate/y_min, force: {z: -1e3}}")}},
      {"MomentOnASolid",
       "idle_load",
       "moment: {y: 100",
       {add_load("{nodes: plate/x_max, moment: {y: 100}}")},
       {add_load("{nodes: sheet/x_max, moment: {y: 100}}")}},
      {"SymmetryWithAnotherNormal",
       "symmetry_plane",
       "symmetry: x",
       {add_condition("{nodes: plate/y_min, symmetry: x}")},
       {add_condition("{nodes: plate/y_min, symmetry: y}"), add_condition("{nodes: sheet/y_min, symmetry: x}")}},
      {"DampingThatStopsTheBlock",
       "damping_size",
       "coefficient: 1e6",
       {{"conditions:", "damping: [{nodes: block, coefficient: 1e6}]\nconditions:"}},
       {{"conditions:", "damping: [{nodes: block, coefficient: 1e3}]\nconditions:"}}},
      {"DampingThatLetsNothingBend",
       "damping_size",
       "coefficient: 1e9",
       {{"conditions:", "damping: [{nodes: plate, coefficient: 1e9}]\nconditions:"}},
       {{"conditions:", "damping: [{nodes: plate, coefficient: 1e5}]\nconditions:"}}},
      {"WallInMillimetres",
       "wall_place",
       "point: [0, 0, -10]",
       {{"0, 0, -0.01]", "0, 0, -10]"}},
       {{"0, 0, -0.01]", "0, 0, -1]"}}},
      {"RectangleBesideTheScene",
       "wall_place",
       "point: [10, 0",
       {{"[0, 0, -0.01], normal: z", "[10, 0, -0.01], normal: z, rectangle: {along: x, size: [0.1, 0.1]}"}},
       {{"[0, 0, -0.01], normal: z", "[1, 0, -0.01], normal: z, rectangle: {along: x, size: [0.1, 0.1]}"}}},
      {"BallInMillimetres",
       "wall_place",
       "point: [0, 0, -10]",
       {{"[0, 0, -0.01], normal: z", "[0, 0, -10], sphere: {radius: 0.01}"}},
       {{"[0, 0, -0.01], normal: z", "[0, 0, -10], sphere: {radius: 9.99}"}}},
      {"PoleBesideTheScene",
       "wall_place",
       "point: [10, 0",
       {{"[0, 0, -0.01], normal: z", "[10, 0, -0.01], cylinder: {axis: z, radius: 0.01}"}},
       {{"[0, 0, -0.01], normal: z", "[10, 0, -0.02], cylinder: {axis: x, radius: 0.01}"}}},
      {"WallFasterThanWaves",
       "prescribed_speed",
       "speed: 20000",
       {{"z, friction: 0.2}]", "z, speed: 20000}]"}},
       {{"z, friction: 0.2}]", "z, speed: 200}]"}}},
      {"RestLengthInMillimetres",
       "spring_length",
       "rest_length: 21",
       {{"conditions:", spring + "21}}\nconditions:"}},
       {{"conditions:", spring + "0.5}}\nconditions:"}}},
      {"PressureInWrongUnits", "pressure_size", "value: 200e9", {add_pressure("200e9")}, {add_pressure("2e9")}},
      {"PressureOnRubber",
       "pressure_size",
       "value: 10e9",
       {rubber, add_pressure("10e9")},
       {rubber, add_pressure("1e6")}},
      {"GravityUpwards",
       "gravity_direction",
       "gravity: [0, 0, 9.81]",
       {{"-9.81", "9.81"}},
       {{"0, 0, -9.81", "9.81, 0, 0"}}},
  };
}

}  // namespace

std::vector<SuspiciousDeck> suspicious_conditions() {
  std::vector<SuspiciousDeck> all = velocity_decks();
  for (const SuspiciousDeck& deck : load_decks()) all.push_back(deck);
  return all;
}

}  // namespace percuss
