#include <fmt/format.h>

#include <functional>

#include "src/app/commands.hpp"
#include "src/app/read_together.hpp"
#include "src/app/scene_report.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/mesh/decompose.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/output/warning_log.hpp"
#include "src/step/history.hpp"
#include "src/step/model.hpp"
#include "src/step/run_notes.hpp"
#include "src/step/state.hpp"
#include "src/step/step.hpp"
#include "src/step/whole_mesh.hpp"

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

// Every selector of the deck, so that all wrong ones are told at once.
void check_selectors(const ChunkedMesh& chunked, const Deck& deck, Findings& findings) {
  const Mesh& mesh = chunked.mesh;
  const auto nodes = [&](const Selector& where) { findings.gather([&] { select_nodes(mesh, deck, where); }); };
  const auto faces = [&](const Selector& where) { findings.gather([&] { select_faces(mesh, deck, where); }); };
  for (const InitialDeck& initial : deck.initial) nodes(initial.where);
  for (const ConditionDeck& condition : deck.conditions) nodes(condition.where);
  for (const PressureDeck& pressure : deck.pressures) faces(pressure.where);
  for (const NodalLoadDeck& load : deck.nodal_loads) nodes(load.where);
  for (const WallDeck& wall : deck.walls) {
    for (const Selector& where : wall.nodes) nodes(where);
  }
  for (const SurfacePairDeck& pair : deck.contact.pairs) {
    faces(pair.a);
    faces(pair.b);
  }
  for (const TieDeck& tie : deck.contact.ties) {
    findings.gather([&] { select_surface_nodes(mesh, deck, tie.a); });
    faces(tie.b);
  }
  findings.gather([&] { find_history_points(deck, chunked); });
}

/// What a run of the scene would warn of at its start.
std::vector<Warning> list_warnings(const Deck& deck, const ChunkedMesh& chunked, const StartNotice& overlap) {
  WarningLog log(deck.silenced);
  log.add(deck.warnings);
  log.add(find_start_warnings(chunked, find_ranks(chunked.mesh).size()));
  if (overlap.is_warning()) log.add({overlap.rule, overlap.text, "", 0, 1});
  return log.list();
}

}  // namespace

ExitCode check_command(const Command& command, const Communicator& ranks) {
  const Deck deck = read_deck_together(command, ranks);
  const ChunkedMesh chunked = load_mesh(deck, ranks);
  Findings findings;
  check_selectors(chunked, deck, findings);
  findings.throw_if_any();

  const Model model = build_model(deck, chunked);
  ContactStage contact(chunked, deck, ranks);
  State state = make_initial_state(model);
  const StartNotice overlap = contact.is_active() ? contact.prepare(state.x, state.v) : StartNotice{};
  Stepper stepper(deck, chunked, model, contact);
  stepper.start(state);

  SceneReport scene = describe_scene(deck, chunked);
  scene.first_step = state.next_dt;
  scene.controlling_element = describe_element(chunked, state.bound.element);
  scene.contact_nodes = contact.contact_nodes();
  scene.contact_faces = contact.contact_faces();
  scene.contact_notes = contact.start_notes();
  if (!overlap.is_warning() && !overlap.text.empty())
    scene.contact_notes.insert(scene.contact_notes.begin(), overlap.text);
  scene.warnings = list_warnings(deck, chunked, overlap);
  if (ranks.rank() == 0) fmt::print("{}", format_scene(scene));
  return ExitCode::done;
}

}  // namespace percuss
