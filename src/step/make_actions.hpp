#pragma once
// The list of what acts in a step besides elements and contact. A new kind of action is a class and its line there.

#include <memory>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/step/forces/force_books.hpp"
#include "src/step/model/action.hpp"
#include "src/step/rigid/rigid_stage.hpp"
#include "src/step/sensors/sensors.hpp"

namespace percuss {

struct Actions {
  std::vector<std::unique_ptr<Action>> all;  // in their order
  // Actions that others ask.
  const RigidStage* rigid = nullptr;  // null: no body is rigid
  Sensors* sensors = nullptr;
  ForceBooks* forces = nullptr;
};

/// The actions of the scene. All arguments outlive the actions. Collective; throws InputError as the constructors do.
Actions make_actions(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact);

}  // namespace percuss
