#pragma once
// What one thread of this machine can do at most, measured in the same run as what is compared with it.

namespace percuss {

struct Ceilings {
  double
      flops;  // operations a second in the elements' precision: packs, a multiplication beside each addition, not fused
  double stream;  // bytes a second: a triad of long arrays, reads and writes, no write-allocate counted
};

/// The best of some short tries of each, on the calling thread.
Ceilings measure_ceilings();

}  // namespace percuss
