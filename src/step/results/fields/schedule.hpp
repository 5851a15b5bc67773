#pragma once
// When rows and frames are due.

#include <cmath>
#include <optional>
#include <string>

#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// Due at multiples of a period; never twice for one state.
class Schedule {
 public:
  explicit Schedule(std::optional<double> period) : period_(period) {}
  bool is_due(double time) const { return period_ && time >= next_ * (1 - 1e-12); }
  void advance(double time) {
    if (period_ && *period_ > 0) next_ = *period_ * (std::floor(time / *period_ * (1 + 1e-12)) + 1);
  }
  bool is_set() const { return period_.has_value(); }
  /// Whether, after archive() has loaded, less is due than in the run before.
  bool is_thinned() const { return is_thinned_; }

  /// Goes on with what another run of the same period has; `time` is where.
  void archive(CheckpointArchive& archive, const std::string& name, double time);

 private:
  std::optional<double> period_;
  double next_ = 0;
  bool is_thinned_ = false;
};

}  // namespace percuss
