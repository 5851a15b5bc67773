#include "src/step/results/fields/schedule.hpp"

namespace percuss {

void Schedule::archive(CheckpointArchive& archive, const std::string& name, double time) {
  double period = period_.value_or(-1), next = next_;
  if (archive.has_number(name + "/period")) {
    archive.number(name + "/period", period);
    archive.number(name + "/next", next);
  } else {
    period = -1;  // a run that did not have it
  }
  if (!archive.is_loading()) return;
  is_thinned_ = period_ && period >= 0 && *period_ > period;
  if (period_ && *period_ == period) {
    next_ = next;
  } else {
    advance(time);
  }
}

}  // namespace percuss
