#include <fmt/format.h>

#include <functional>

#include "src/app/commands.hpp"
#include "src/app/memory_check.hpp"
#include "src/app/scene_report.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/deck/read_deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/history.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"
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

// Every selector of the deck, so that all wrong ones are told at once.
void check_selectors(const Mesh& mesh, const Deck& deck, Findings& findings) {
  const auto nodes = [&](const Selector& where) { findings.gather([&] { select_nodes(mesh, deck, where); }); };
  const auto faces = [&](const Selector& where) { findings.gather([&] { select_faces(mesh, deck, where); }); };
  for (const InitialDeck& initial : deck.initial) nodes(initial.where);
  for (const ConditionDeck& condition : deck.conditions) nodes(condition.where);
  for (const PressureDeck& pressure : deck.pressures) faces(pressure.where);
  for (const WallDeck& wall : deck.walls) {
    for (const Selector& where : wall.nodes) nodes(where);
  }
  for (const SurfacePairDeck& pair : deck.contact.pairs) {
    faces(pair.a);
    faces(pair.b);
  }
  findings.gather([&] { find_history_points(deck, mesh); });
}

}  // namespace

ExitCode check_command(const Command& command) {
  const Deck deck = read_deck(command.file, command.settings);
  check_memory(deck);
  const ChunkedMesh chunked = order_chunks(build_mesh(deck));
  Findings findings;
  check_selectors(chunked.mesh, deck, findings);
  findings.throw_if_any();

  const Model model = build_model(deck, chunked);
  ContactStage contact(chunked, deck, Communicator::world());
  State state = make_initial_state(model);
  const std::string overlap = contact.is_active() ? contact.prepare(state.x, state.v, model.inverse_mass) : "";
  Stepper stepper(deck, model, contact);
  stepper.start(state);

  SceneReport scene{deck, chunked.mesh};
  scene.first_step = state.next_dt;
  scene.controlling_element = state.bound.element;
  scene.contact_nodes = contact.contact_nodes();
  scene.contact_faces = contact.contact_faces();
  scene.overlap = overlap;
  fmt::print("{}", format_scene(scene));
  return ExitCode::done;
}

}  // namespace percuss
