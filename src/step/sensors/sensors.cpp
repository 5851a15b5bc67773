#include "src/step/sensors/sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {
namespace {

std::size_t find_column(const Deck& deck, const SensorDeck& sensor, const std::string& name,
                        const std::vector<HistoryColumn>& columns) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const HistoryColumn& column) { return column.name == name; });
  if (found != columns.end()) return static_cast<std::size_t>(found - columns.begin());
  const std::string near = nearest_name(name, name_columns(columns));
  throw InputError(fmt::format("{}: error: sensor '{}' looks at '{}' (the history has no such column){}",
                               deck.where(sensor.place), sensor.name, name,
                               near.empty() ? ": columns.json of a run lists them" : "; did you mean '" + near + "'?"));
}

/// The value of one column, or the distance of two nodes.
double find_value(const std::vector<std::size_t>& columns, const std::vector<double>& row) {
  if (columns.size() == 1) return row[columns[0]];
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double gap = row[columns[3 + k]] - row[columns[k]];
    square += gap * gap;
  }
  return std::sqrt(square);
}

}  // namespace

void Sensors::find_columns(const std::vector<HistoryColumn>& columns) {
  columns_.assign(deck_.sensors.size(), {});
  for (std::size_t s = 0; s < deck_.sensors.size(); ++s) {
    const SensorDeck& sensor = deck_.sensors[s];
    if (!sensor.value.empty()) columns_[s].push_back(find_column(deck_, sensor, sensor.value, columns));
    for (const std::string& node : sensor.distance)
      for (const char* axis : {"_x", "_y", "_z"})
        columns_[s].push_back(find_column(deck_, sensor, node + axis, columns));
  }
}

void Sensors::look(double time, const std::vector<double>& row) {
  std::vector<double> values(states_.size(), 0.0);
  for (std::size_t s = 0; ranks_.rank() == 0 && s < states_.size(); ++s)
    if (!columns_[s].empty()) values[s] = find_value(columns_[s], row);
  wait_mpi([&] { return MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, 0, ranks_.handle()); },
           "MPI_Bcast");
  for (std::size_t s = 0; s < states_.size(); ++s)
    if (!deck_.sensors[s].time) see(deck_.sensors[s], time, values[s], states_[s]);
}

/// A level is crossed by a value that was on its other side before. What is not finite crosses nothing.
void Sensors::see(const SensorDeck& sensor, double time, double value, SensorState& state) const {
  if (!std::isfinite(value)) return;  // it says nothing
  if (!state.has_start) state.start = value;
  state.has_start = true;
  if (state.event != never) return;
  const double reading = sensor.from_start ? value - state.start : value;
  const bool is_beyond = sensor.rises_above ? reading > *sensor.rises_above : reading < *sensor.falls_below;
  if (is_beyond && state.is_armed) {
    state.event = time;
    state.value = reading;
  }
  state.is_armed = state.is_armed || !is_beyond;
}

/// When the event of a sensor came, if it has by this time.
double Sensors::find_event(std::size_t s, double time) const {
  const SensorDeck& sensor = deck_.sensors[s];
  if (!sensor.time) return states_[s].event;
  return time >= *sensor.time ? *sensor.time : never;
}

std::vector<char> Sensors::find_happened(double time) const {
  std::vector<char> happened(states_.size(), 0);
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const double event = find_event(s, time);
    happened[s] = event != never && time >= event + deck_.sensors[s].delay ? 1 : 0;
  }
  return happened;
}

bool Sensors::ends_run(double time) const {
  if (deck_.time.until.empty()) return false;
  const std::vector<char> happened = find_happened(time);
  for (std::size_t s = 0; s < states_.size(); ++s)
    if (deck_.sensors[s].name == deck_.time.until) return happened[s] != 0;
  return false;
}

std::vector<SensorEvent> Sensors::list_events(double time) const {
  std::vector<SensorEvent> events;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const double event = find_event(s, time);
    if (event != never)
      events.push_back({deck_.sensors[s].name, event, deck_.sensors[s].time.value_or(states_[s].value)});
  }
  return events;
}

void Sensors::archive(CheckpointArchive& archive, State& scene) {
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const std::string name = "sensors/" + deck_.sensors[s].name;
    SensorState& state = states_[s];
    archive.integer(name + "/has_start", state.has_start);
    archive.integer(name + "/is_armed", state.is_armed);
    archive.number(name + "/start", state.start);
    archive.number(name + "/event", state.event);
    archive.number(name + "/value", state.value);
  }
  if (archive.is_loading() && any()) scene.happened = find_happened(scene.time);
}

std::vector<HistoryColumn> Sensors::list_columns() const {
  std::vector<HistoryColumn> columns;
  for (const SensorDeck& sensor : deck_.sensors)
    columns.push_back(
        {"sensor:" + sensor.name, {}, fmt::format("state of sensor '{}', 1 once it has acted, else 0", sensor.name)});
  return columns;
}

void Sensors::append_values(const State& state, std::vector<double>& row) {
  row.insert(row.end(), state.happened.begin(), state.happened.end());
}

}  // namespace percuss
