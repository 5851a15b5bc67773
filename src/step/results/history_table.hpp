#pragma once
// The columns of history.csv that any scene may have: each is one entry with its name, dimension, meaning and value,
// and the decks that have it.

#include <string>
#include <vector>

#include "src/output/history_columns.hpp"
#include "src/step/audit/audit.hpp"
#include "src/step/step.hpp"

namespace percuss {

/// Sources of the values of a row.
struct HistorySources {
  const State& state;
  const AuditResult& audit;
  const ContactReport& contact;
  const Vec3& wall_force;                // used only with walls
  const std::vector<double>& pair_work;  // ContactStage::sum_pair_work()
  Stepper& stepper;                      // whose actions have columns
  bool is_approach_limiting = false;     // Stepper::find_limiting_approach()
};

/// The columns of a deck, without those of actions, parts and followed points.
class HistoryTable {
 public:
  explicit HistoryTable(const Deck& deck);

  const std::vector<HistoryColumn>& columns() const { return columns_; }

  /// Appends the values of the columns to a row.
  void append(const HistorySources& sources, std::vector<double>& row) const;

 private:
  using Value = double (*)(const HistorySources&);

  std::vector<HistoryColumn> columns_;
  std::vector<Value> before_pairs_, after_pairs_;
};

}  // namespace percuss
