#include <fmt/format.h>

#include "src/app/commands.hpp"
#include "src/app/process/compute_session.hpp"
#include "src/app/read_together.hpp"
#include "src/app/reports/plan_report.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/output/files/safe_text.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/step.hpp"

namespace percuss {
namespace {

/// The scene at time 0, with its first time step, as `check` finds it.
State start_scene(const Deck& deck, const ChunkedMesh& whole, const Communicator& self) {
  const Model model = build_model(deck, whole);
  ContactStage contact(whole, deck, self);
  State state = make_initial_state(model);
  Stepper(deck, whole, model, contact).start(state);
  return state;
}

std::string make_plan(const Command& command) {
  const Communicator self(MPI_COMM_SELF);
  const Deck deck = read_deck_together(command, self);
  const ComputeSession session(self, deck);
  const DecompositionPlanner mesh(deck);
  const ChunkedMesh whole = load_mesh(deck, self);
  const State start = start_scene(deck, whole, self);
  const PlanFigures& figures = command.figures;
  const ContactPlanner contact(whole, deck,
                               {{start.x, start.v, start.next_dt},
                                figures.steps_per_search,
                                figures.all_touch ? PlannedTouches::near : PlannedTouches::start});
  std::vector<RanksPlan> plans;
  for (const int ranks : command.rank_counts) {
    DecompositionPlan divided = mesh.plan(ranks);
    ContactPlan surfaces = contact.plan(divided.partition.parts, ranks);
    plans.push_back({ranks, std::move(divided), std::move(surfaces)});
  }
  const Numbering& numbering = whole.numbering;
  const PlannedScene scene{deck,
                           numbering.element_count(),
                           numbering.node_count(),
                           numbering.chunk_count(),
                           contact.nodes(),
                           contact.faces(),
                           contact.contacts(),
                           start.next_dt,
                           find_step_pattern(deck, contact)};
  const std::string& threads = session.note();
  return format_plan(scene, figures, plans) + (threads.empty() ? "" : "\n" + threads + "\n");
}

}  // namespace

ExitCode plan_command(const Command& command, const Communicator& ranks) {
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) print_text(stdout, make_plan(command));
  });
  return ExitCode::done;
}

}  // namespace percuss
