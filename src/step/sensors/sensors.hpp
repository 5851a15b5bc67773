#pragma once
// The sensors of a deck: events that are decided from the time and from rows of the history, which have the same bits
// on any ranks. An event comes once and stays.

#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/deck/deck.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

/// An event that has come.
struct SensorEvent {
  std::string sensor;
  double time = 0;   // of the event
  double value = 0;  // that it saw; of a time, that
};

class Sensors : public Action {
 public:
  /// deck and ranks outlive this.
  Sensors(const Deck& deck, const Communicator& ranks) : deck_(deck), ranks_(ranks), states_(deck.sensors.size()) {}

  bool any() const { return !states_.empty(); }
  bool comes_between() const override { return false; }

  /// Finds what the sensors look at. Throws InputError with the deck's place for a column that the history does not
  /// have. columns: of the history; the same on all ranks.
  void find_columns(const std::vector<HistoryColumn>& columns);

  /// Looks at a row of the history. row: on rank 0. Collective.
  void look(double time, const std::vector<double>& row);

  /// Whether the event of each sensor has occurred by this time, delays included.
  std::vector<char> find_happened(double time) const;

  /// Whether the sensor that ends the run has happened.
  bool ends_run(double time) const;

  /// The events so far, in the order of the deck; one whose delay is not over yet among them.
  std::vector<SensorEvent> list_events(double time) const;

  /// Loading: what has happened, too.
  void archive(CheckpointArchive& archive, State& scene) override;

  /// Whether each has happened.
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;

 private:
  static constexpr double never = -1;
  struct SensorState {
    bool has_start = false, is_armed = false;  // whether a row was seen; whether one was on the other side of the level
    double start = 0;                          // value of the first row
    double event = never;                      // time of the event
    double value = 0;                          // at the event
  };
  double find_event(std::size_t sensor, double time) const;
  void see(const SensorDeck& sensor, double time, double value, SensorState& state) const;

  const Deck& deck_;
  const Communicator& ranks_;
  std::vector<SensorState> states_;
  std::vector<std::vector<std::size_t>> columns_;  // [sensors] places of its columns: of a distance, six
};

}  // namespace percuss
