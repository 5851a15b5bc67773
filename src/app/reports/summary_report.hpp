#pragma once
// What a summary says, in words.

#include <string>

#include "src/output/summary.hpp"

namespace percuss {

/// Several lines: how the run ended, its size, time and steps, where the time went, energies, the hash of the state,
/// warnings.
std::string format_summary(const Summary& summary);

/// "mass scaling added 0.2, 1.3 % of what was there ..."; only where some was.
std::string format_added_mass(const Summary& s);

/// "normal contact took 3.4, 12 % of the largest energy (...): ..."; empty below 5 %.
std::string format_contact_loss(const Summary& summary);

/// "12 of 2448 elements failed and left, mass ..., energy ..."; empty where none has.
std::string format_eroded(const Summary& summary);

}  // namespace percuss
