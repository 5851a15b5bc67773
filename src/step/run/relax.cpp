// The relaxation before a run: its steps, what is reported of them, and the books that begin with the state it leaves.

#include <fmt/format.h>

#include <cmath>

#include "src/error.hpp"
#include "src/step/relaxation/relaxation.hpp"
#include "src/step/run/run_scene.hpp"
#include "src/step/run/stop_request.hpp"

namespace percuss {
namespace {

constexpr long steps_between_stops = 50, steps_between_lines = 5000;

}  // namespace

/// Computes the state at time 0 from the mesh at rest, if the deck requests it. A stop ends the program as one before
/// the first step does.
void Run::relax() {
  if (!deck_.start.relaxation) return;
  Relaxation relaxation(deck_, chunked_, model_, contact_, state_);
  try {
    while (!relaxation.is_over()) {
      relaxation.advance();
      check_elements({relaxation.deck(), chunked_, relaxation.model(), state_, relaxation.stepper()});
      if (state_.step % steps_between_stops == 0) stop_if_requested(ranks_, "before the relaxation was at rest");
      if (state_.step % steps_between_lines == 0)
        say({fmt::format("relaxation, step {}: {}", state_.step, relaxation.describe())});
    }
  } catch (const RunError& error) {
    throw RunError(fmt::format("in the relaxation before time 0: {}", error.what()));
  }
  summary_.relaxation = relaxation.report();
  summary_.relaxation.contact_stored = relaxation.find_contact_stored();
  if (!relaxation.is_settled()) note_unsettled(relaxation.warn_unsettled());
  say({fmt::format("relaxation: {} after {} steps: {}", summary_.relaxation.state, summary_.relaxation.steps,
                   relaxation.describe())});
  stepper_.note_stored(summary_.relaxation.contact_stored);
  relaxation.finish();
}

void Run::note_unsettled(const Warning& warning) {
  if (deck_.start.relaxation->unsettled == RelaxationDeck::Unsettled::refuse)
    throw RunError(warning.place.empty() ? warning.text : fmt::format("{}: error: {}", warning.place, warning.text));
  warnings_.add({warning});
}

/// Begins the energy balance: what elements hold at time 0 is initial energy, also that of stresses from files and of
/// fluids at rest. The work of gravity counts from there on. Call after the start of the stepper.
void Run::begin_books() {
  if (!deck_.start.relaxation && deck_.start.fields.empty() && deck_.start.hydrostatic.empty()) return;
  const EnergySummary held = Audit(model_)(state_).energy;
  if (!deck_.start.relaxation) return audit_.note_scale(held.internal() + held.kinetic, model_.half_extent);
  if (ranks_.rank() == 0) {
    state_.books.external_work.add(-held.external);
    state_.books.external_work.normalize();
  }
  summary_.relaxation.energy = held.internal() + held.hourglass() + held.work[WorkKind::folding];
  audit_.note_scale(summary_.relaxation.scale, model_.half_extent);
}

void Run::archive_relaxation(CheckpointArchive& archive) {
  if (!deck_.start.relaxation) return;
  RelaxationSummary& report = summary_.relaxation;
  bool is_settled = report.state == "settled";
  archive.integer("relaxation/is_settled", is_settled);
  report.state = is_settled ? "settled" : "unsettled";
  archive.number("relaxation/steps", report.steps);
  archive.number("relaxation/kinetic_ratio", report.kinetic_ratio);
  archive.number("relaxation/scale", report.scale);
  archive.number("relaxation/frequency", report.frequency);
  archive.number("relaxation/energy", report.energy);
  archive.number("relaxation/preload_error", report.preload_error);
  archive.number("relaxation/contact_stored", report.contact_stored);
}

}  // namespace percuss
