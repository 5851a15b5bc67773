#pragma once
// What both sides of the comparison do: points come, and go to their owners.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"

namespace percuss::perf {

struct HeldPoint {
  double x[3] = {0, 0, 0};
  std::int64_t id = 0;
};

/// A bisection by Zoltan (LB_METHOD RCB with KEEP_CUTS and RCB_REUSE).
class ZoltanBisection {
 public:
  /// Collective.
  explicit ZoltanBisection(const Communicator& ranks);
  ~ZoltanBisection();
  ZoltanBisection(const ZoltanBisection&) = delete;
  ZoltanBisection& operator=(const ZoltanBisection&) = delete;

  /// The owner of each of this rank's points. The first call is cold, later ones begin at the previous cuts.
  /// Collective. Throws std::runtime_error.
  std::vector<int> find_owners(const std::vector<HeldPoint>& points);

 private:
  void* zoltan_ = nullptr;
  int rank_ = 0;
};

}  // namespace percuss::perf
