#pragma once
// Clocks of the phases of a step.

#include "comm/phase.hpp"
#include "src/output/summary.hpp"

namespace percuss {

struct PhaseClocks {
  PhaseClock internal_force, halo, integrate, contact_rcb, contact_search, contact_check, contact_enforce, reduce,
      estimate, output;

  PhaseSeconds wall() const { return pick(&PhaseClock::wall); }
  PhaseSeconds compute() const { return pick(&PhaseClock::compute); }

 private:
  PhaseSeconds pick(double PhaseClock::*of) const {
    return {internal_force.*of,  halo.*of,   integrate.*of, contact_rcb.*of, contact_search.*of, contact_check.*of,
            contact_enforce.*of, reduce.*of, estimate.*of,  output.*of};
  }
};

}  // namespace percuss
