// Wrong decks: sensors that see nothing, what they cannot switch, pressures of blasts, relaxations and preloads.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

/// A deck with a history of a node, and a sensor.
std::string sense(const std::string& sensor, const std::string& more = "") {
  return append("output: {history: {nodes: [{name: tip, near: [0, 0, 0]}]}}\nsensors: {go: {" + sensor + "}}\n" + more);
}

std::vector<WrongDeck> wrong_sensors() {
  return {
      {"PressureWithoutValue", append("loads: {pressure: [{faces: rod}]}"), "6:20",
       "'loads.pressure.0' has no pressure (must have exactly one of value, blast)"},
      {"BlastWithoutUnits", append("loads: {pressure: [{faces: rod, blast: {charge: 1, center: [9, 0, 0]}}]}"), "6:33",
       "a blast needs the units of the deck"},
      {"BlastAlongADirection",
       append(
           "units: m, kg, s\nloads: {pressure: [{faces: rod, direction: x, blast: {charge: 1, center: [9, 0, 0]}}]}"),
       "7:33", "loads.pressure.0.direction has no effect (a blast acts against the normal)"},
      {"FieldsOfNoFile", append("start: {fields: [{file: none.csv}]}"), "6:25", "there is no file"},
      {"SensorWithoutEvent", sense("delay: 1"), "7:15",
       "sensor 'go' has no event (must have exactly one of time, value, distance)"},
      {"SensorWithTwoEvents", sense("time: 1, value: tip_x, rises_above: 1"), "7:15", "has time and value"},
      {"SensorWithoutLevel", sense("value: tip_x"), "7:15",
       "has no event (must have exactly one of rises_above, falls_below)"},
      {"SensorOfATimeWithALevel", sense("time: 1, rises_above: 1"), "7:25",
       "rises_above has no effect in sensor 'go' (its event is a time)"},
      {"SensorOfThreeNodes", sense("distance: [tip, tip, tip], rises_above: 1"), "7:26",
       "must be two names of output.history.nodes"},
      {"SensorOfAnUnknownNode", sense("distance: [tip, tap], rises_above: 1"), "7:11",
       "sensor 'go' has the distance of 'tap' (must be a name of output.history.nodes) (did you mean 'tip'?)"},
      {"SensorWithoutHistory", append("sensors: {go: {value: kinetic, rises_above: 1}}"), "6:11",
       "sensor 'go' looks at the history (the deck has none): give output.history.every"},
      {"UnknownSensorOfALoad", sense("time: 1", "loads: {nodal: [{nodes: rod, force: {x: 1}, from: goo}]}"), "8:51",
       "unknown sensor 'goo'"},
      {"LoadBetweenOneEvent", sense("time: 1", "loads: {nodal: [{nodes: rod, force: {x: 1}, from: go, until: go}]}"),
       "8:17", "from and until are both 'go' (the entry would never act)"},
      {"DisplacementFromAnEvent", sense("time: 1", "conditions: [{nodes: rod, displacement: {x: 0}, from: go}]"),
       "8:49", "a displacement cannot have from (the nodes would jump to it)"},
      {"SwitchedConditionWithTheGlobalStep",
       change("step_scale: 0.9", "step_estimate: global") +
           "sensors: {go: {time: 1}}\nconditions: [{nodes: rod, fixed: [x], until: go}]\n",
       "7:39", "cannot be used with time.step_estimate: global"},
  };
}

/// `start` with a preload of the part rod.
std::string start(const std::string& more) {
  return "start: {relaxation: {}, preload: {b: {point: [0.5, 0.5, 0.3], normal: z, " + more + "}}}\n";
}

/// `rod` of a fluid with this equation of state, which begins at rest.
std::string fill(const std::string& state, const std::string& more, const std::string& parts = "rod") {
  return change("model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3",
                "model: fluid, density: 1, equation_of_state: {" + state + "}") +
         more + "start: {hydrostatic: [{parts: [" + parts + "], surface: [0, 0, 1]}]}\n";
}

constexpr const char* linear = "kind: linear, bulk_modulus: 1e5";
constexpr const char* falls = "loads: {gravity: [0, 0, -9.81]}\n";

std::vector<WrongDeck> wrong_starts() {
  return {
      {"PreloadWithoutRelaxation",
       append("start: {preload: {b: {part: rod, point: [0, 0, 0.3], normal: z, force: 1}}}"), "6:9",
       "start.preload has no effect (it acts during a relaxation): give the key relaxation as well"},
      {"PreloadWithoutForce", append(start("part: rod, force: 0")), "6:35",
       "preload 'b' has force 0 (must pull or push): leave it out"},
      {"PreloadOfAllParts", append(start("part: all, force: 1")), "6:35",
       "preload 'b' is of part all (must be of one part): name the part"},
      {"PreloadOfARigidPart",
       change("material: steel}", "material: steel, rigid: true}") + start("part: rod, force: 1"), "6:35",
       "preload 'b' is of part 'rod' (which is rigid and has no stresses)"},
      {"PreloadOfRubber", change("model: elastic", "model: neo_hookean") + start("part: rod, force: 1"), "6:35",
       "preload 'b' is of part 'rod' of material 'steel' (whose stress does not grow in increments)"},
      {"PreloadThatLacksItsForce", append(start("part: rod")), "6:35", "force is missing"},
      {"FluidAtRestWithoutGravity", fill(linear, ""), "6:9",
       "start.hydrostatic has no effect (loads.gravity is 0 at time 0): give gravity, or leave it out"},
      {"SolidAtRest", append(falls + std::string("start: {hydrostatic: [{parts: [rod], surface: [0, 0, 1]}]}")), "7:23",
       "start.hydrostatic: part 'rod' of material 'steel' is no fluid"},
      {"AllPartsAtRest", fill(linear, falls, "all"), "7:23", "all is given (must be parts by their names)"},
      {"FluidAtRestTwice", fill(linear, falls, "rod, rod"), "7:23", "part 'rod' is named twice"},
      {"GasAtRestWithoutPressure", fill("kind: ideal_gas, gamma: 1.4, start_energy: 2.5e5", falls), "7:23",
       "cannot rest with the pressure 0 (its equation of state does not reach it without heat)"},
      {"RelaxationToNothing", append("start: {relaxation: {tolerance: 0}}"), "6:33", "must be above 0 and below 1"},
  };
}

}  // namespace

std::vector<WrongDeck> wrong_load_decks() {
  std::vector<WrongDeck> all = wrong_sensors();
  for (const WrongDeck& deck : wrong_starts()) all.push_back(deck);
  return all;
}

}  // namespace percuss
