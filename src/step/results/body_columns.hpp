#pragma once
// The columns of history.csv of rigid bodies.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/output/history_columns.hpp"
#include "src/step/rigid/rigid_forces.hpp"

namespace percuss {

/// "body_x:ram" and so on, body after body.
std::vector<HistoryColumn> list_body_columns(const Deck& deck);

/// Values of those columns. Holds the memory of sums.
class BodyColumns {
 public:
  /// Appends them to a row. Collective.
  void append(const Model& model, const State& state, std::vector<double>& row);

 private:
  RigidForces find_forces_;
};

}  // namespace percuss
