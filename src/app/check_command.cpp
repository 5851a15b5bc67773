#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "src/app/commands.hpp"
#include "src/app/process/compute_session.hpp"
#include "src/app/read_together.hpp"
#include "src/app/reports/scene_json.hpp"
#include "src/app/reports/scene_report.hpp"
#include "src/app/reports/stage_line.hpp"
#include "src/checks/rules.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/output/files/safe_text.hpp"
#include "src/output/warning_log.hpp"
#include "src/step/initial/start_fields.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/relaxation/relaxation.hpp"
#include "src/step/results/fields/frame_scene.hpp"
#include "src/step/results/history.hpp"
#include "src/step/run/run_notes.hpp"
#include "src/step/springs/build_springs.hpp"
#include "src/step/step.hpp"

namespace percuss {
namespace {

/// Runs checks one after the other and throws what all of them found.
class Findings {
 public:
  void gather(const std::function<void()>& check) {
    try {
      check();
    } catch (const InputError& error) {
      const std::string message = error.what();
      if (text_.find(message) == std::string::npos) text_ += (text_.empty() ? "" : "\n") + message;
    }
  }
  void throw_if_any() const {
    if (!text_.empty()) throw InputError(text_);
  }

 private:
  std::string text_;
};

void select(const ChunkedMesh& chunked, const Deck& deck, const UsedSelector& used) {
  const Mesh& mesh = chunked.mesh;
  switch (used.chosen) {
    case Chosen::nodes:
      select_nodes(mesh, deck, used.where);
      break;
    case Chosen::faces:
      select_faces(mesh, deck, used.where);
      break;
    case Chosen::touching:
      select_touching_faces(mesh, deck, used.where, find_exterior_faces(mesh));
      break;
    case Chosen::surface_nodes:
      select_surface_nodes(mesh, deck, used.where);
      break;
    case Chosen::elements:
      mark_elements(mesh, deck, {used.where});
      break;
    case Chosen::some:
      break;
  }
}

// Every selector of the deck, so that all wrong ones are reported at once.
void check_selectors(const ChunkedMesh& chunked, const Deck& deck, Findings& findings) {
  for (const UsedSelector& used : deck.selectors) findings.gather([&] { select(chunked, deck, used); });
  for (const WeldDeck& weld : deck.welds) {
    if (!weld.is_between_faces()) continue;
    for (const SpringEndDeck& end : weld.between) findings.gather([&] { select_faces(chunked.mesh, deck, end.where); });
  }
  findings.gather([&] { find_history_points(deck, chunked); });
  findings.gather([&] { find_springs(deck, chunked); });
}

/// The state at time 0, and what is to be said of files that it takes.
struct StartState {
  State state;
  std::vector<Warning> warnings;
};

/// Warnings of a run of the scene at its start. Collective.
std::vector<Warning> list_warnings(const Deck& deck, const ChunkedMesh& chunked, const Model& model, Stepper& stepper,
                                   const ContactStage& contact, const StartState& start) {
  const SceneMeasures measures = measure_scene(deck, chunked, model.start_velocity);
  const double bound = model.rigid.is_all ? start.state.next_dt : start.state.bound.step;
  const TieMeasures ties = contact.measure_ties();
  const std::vector<double> part_steps = find_part_steps(chunked, start.state.results);
  const CheckedScene scene{deck, &measures, &contact.start_overlap(), bound, &ties, &part_steps};
  WarningLog log(deck.silenced);
  log.add(deck.warnings);
  log.add(find_start_warnings(deck, chunked));
  log.add(check_input(scene));
  log.add(stepper.list_start_warnings());
  log.add(start.warnings);
  log.add(stepper.take_warnings());
  log.add(check_start(scene));
  return log.list();
}

/// Throws what a relaxation cannot begin with: preloads that the mesh does not have. Contact is that of a scene that
/// relaxes from then on. Collective.
void check_relaxation(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact) {
  if (!deck.start.relaxation) return;
  State state = make_initial_state(model);
  set_start_states(deck, chunked, model, state);
  const Relaxation relaxation(deck, chunked, model, contact, state);
}

/// Name of what limits the first step.
std::string name_controller(const ChunkedMesh& chunked, const Model& model, const State& state,
                            const Stepper& stepper) {
  if (const Approach* const approach = stepper.find_limiting_approach(state))
    return describe_approach(*approach, chunked.mesh);
  const std::string spring = name_limiting_spring(model, state.bound.spring);
  return spring.empty() ? describe_element(chunked, state.bound.element) : spring;
}

/// The first step if nothing were damped in proportion to its stiffness; 0 where that makes no difference. Collective.
double find_undamped_step(const Deck& deck, const State& state, const Stepper& stepper) {
  const double bound = stepper.find_undamped_bound(state);
  if (stepper.find_limiting_approach(state) != nullptr || state.bound.spring != -1) return 0;
  const double step = std::min({deck.time.step_scale * bound, deck.time.max_step.value_or(HUGE_VAL), deck.time.end});
  return step > state.next_dt ? step : 0;
}

/// Adds the notes of the model.
void add_notes(const ChunkedMesh& chunked, const Model& model, const Stepper& stepper, SceneReport& scene) {
  scene.mesh_notes = chunked.mesh.notes;
  for (const std::string& note : model.mass_notes) scene.mesh_notes.push_back(note);
  scene.spring_notes = stepper.list_notes();
}

/// overlap: what contact says of it; empty: there is none.
void add_contact(const ContactStage& contact, const std::string& overlap, SceneReport& scene) {
  scene.contact_nodes = contact.contact_nodes();
  scene.contact_faces = contact.contact_faces();
  scene.contact_notes = contact.start_notes();
  if (!overlap.empty()) scene.contact_notes.insert(scene.contact_notes.begin(), overlap);
}

/// Throws what files of stresses and sensors have wrong. Collective.
StartState make_checked_state(const Deck& deck, const ChunkedMesh& chunked, const Model& model, Stepper& stepper) {
  StartState start{make_initial_state(model), {}};
  start.warnings = set_start_states(deck, chunked, model, start.state);
  if (!stepper.sensors().any()) return start;
  stepper.sensors().find_columns(History::list_columns({deck, chunked, stepper}));
  start.state.happened = stepper.sensors().find_happened(0);
  return start;
}

/// Sizes of each entry of output.field_outputs. Collective.
std::vector<FieldOutputSize> find_sizes(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks) {
  std::vector<FieldOutputSize> sizes;
  for (const FieldsDeck& fields : deck.output.field_outputs) {
    const auto region = find_field_region(deck, fields, chunked, ranks);
    const Numbering& shown = (region == nullptr ? chunked : region->chunked).numbering;
    sizes.push_back({fields.name, shown.element_count(), shown.node_count()});
  }
  return sizes;
}

/// Adds the files that a run would write. Collective.
void add_output(const HistoryScene& of, const Communicator& ranks, SceneReport& scene) {
  scene.field_outputs = find_sizes(of.deck, of.chunked, ranks);
  if (of.deck.output.history_every) scene.columns = History::list_columns(of);
}

}  // namespace

ExitCode check_command(const Command& command, const Communicator& ranks) {
  if (command.json && ranks.size() > 1) throw InputError("percuss check --json needs one rank: call it without mpirun");
  StageLine stage(stderr, ranks.rank() == 0 ? StageLine::Speaker::yes : StageLine::Speaker::no);
  stage.show("reading the deck");
  const Deck deck = read_deck_together(command, ranks);
  const ComputeSession session(ranks, deck);
  stage.show("making the mesh");
  const ChunkedMesh chunked = load_mesh(deck, ranks);
  stage.show("looking up names and history points");
  Findings findings;
  check_selectors(chunked, deck, findings);
  findings.throw_if_any();

  stage.show("building the model");
  const Model model = build_model(deck, chunked);
  stage.show("finding contact surfaces and overlap at the start");
  ContactStage contact(chunked, deck, ranks);
  Stepper stepper(deck, chunked, model, contact);
  StartState start = make_checked_state(deck, chunked, model, stepper);
  State& state = start.state;
  contact.set_switches(state.happened);
  const std::string overlap = contact.prepare(state.x, state.v);
  stage.show("finding the first step");
  stepper.start(state);

  SceneReport scene = describe_scene(deck, chunked);
  scene.first_step = state.next_dt;
  scene.controlling_element = name_controller(chunked, model, state, stepper);
  scene.undamped_step = find_undamped_step(deck, state, stepper);
  add_notes(chunked, model, stepper, scene);
  add_output({deck, chunked, stepper}, ranks, scene);
  add_contact(contact, overlap, scene);
  stage.show("looking for suspicious input");
  scene.warnings = list_warnings(deck, chunked, model, stepper, contact, start);
  check_relaxation(deck, chunked, model, contact);
  stage.clear();
  if (command.json)
    print_text(stdout, format_scene_json(scene, chunked, contact.start_overlap(), state.results));
  else if (ranks.rank() == 0)
    print_text(stdout, format_scene(scene));
  return ExitCode::done;
}

}  // namespace percuss
