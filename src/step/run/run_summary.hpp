#pragma once
// From what a run holds at its end to its summary and to the row of each rank in ranks.csv.

#include "src/output/ranks_file.hpp"
#include "src/output/summary.hpp"
#include "src/step/audit/audit.hpp"
#include "src/step/step.hpp"

namespace percuss {

/// Sources of a summary; all of it outlives the call.
struct SummedRun {
  const ChunkedMesh& chunked;
  const Model& model;
  const State& state;
  const Stepper& stepper;
  const ContactStage& contact;
  const AuditResult& audited;  // of this state
  long steps = 0;              // of this run, without those before its checkpoint
  double compute_s = 0;        // CPU seconds of this rank's work since the loop began
};

/// Fills in the program, the size of the scene, and step and time of the state. Collective.
void fill_scene(const SummedRun& run, Summary& summary);

/// Fills in all but status, error, set-up time and what the loop notes as it goes: steps' lengths, loop_s, which must
/// be there. Collective.
void fill_summary(const SummedRun& run, Summary& summary);

/// Elements, times and messages of this rank. Not collective.
RankRow make_rank_row(const SummedRun& run);

}  // namespace percuss
