// Sensors that see nothing, what they cannot switch, pressures of blasts, and files of the start.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

/// A deck with a history of a node, and a sensor.
std::string sense(const std::string& sensor, const std::string& more = "") {
  return append("output: {history: {nodes: [{name: tip, near: [0, 0, 0]}]}}\nsensors: {go: {" + sensor + "}}\n" + more);
}

}  // namespace

std::vector<WrongDeck> wrong_sensor_decks() {
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

}  // namespace percuss
