#pragma once
// Whether a run may continue after a step, and what is said if not: what is worst, where, and what to do about it.

#include "src/step/audit/audit.hpp"
#include "src/step/run/run_notes.hpp"
#include "src/step/step.hpp"

namespace percuss {

/// Data of the checks; all of it outlives them.
struct CheckedRun {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const Model& model;
  const State& state;
  const Stepper& stepper;
};

/// Throws RunError, on all ranks, if an element has inverted, or anything of the state or its work is not finite, in
/// the step just made. Collective.
void check_elements(const CheckedRun& run);

/// Throws RunError, on all ranks, if the step has collapsed. first_dt: the first step of the run. Collective.
void check_step(const CheckedRun& run, double first_dt);

/// Throws RunError, on all ranks, if the balance of energy or of momentum is off. Collective.
void check_balance(const CheckedRun& run, const AuditResult& audit);

/// "node 17 at (1, 2, 3), 0.2 of a face edge": the deepest contact node of the step just made; empty if none is deep.
/// Collective.
std::string name_deepest_node(const CheckedRun& run);

/// Where contact gave most energy in the step just made. Collective.
GainPlace find_gain_place(const CheckedRun& run);

/// Throws RunError, on all ranks: contact has given more energy than the deck allows. gain: of describe_gain().
[[noreturn]] void refuse_gain(const CheckedRun& run, const std::string& gain);

/// Whether every position is a number. Collective.
bool has_finite_positions(const Model& model, const State& state);

}  // namespace percuss
