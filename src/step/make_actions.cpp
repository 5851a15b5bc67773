#include "src/step/make_actions.hpp"

#include "src/step/constraints/constraint_stage.hpp"
#include "src/step/damping/damping_stage.hpp"
#include "src/step/embedded/embedded_stage.hpp"
#include "src/step/fluids/fluid_stage.hpp"
#include "src/step/forces/accelerometers.hpp"
#include "src/step/forces/wall_motions.hpp"
#include "src/step/glue/glue_stage.hpp"
#include "src/step/loads/condition_stage.hpp"
#include "src/step/loads/load_stage.hpp"
#include "src/step/mass/mass_scaler.hpp"
#include "src/step/springs/spring_stage.hpp"
#include "src/step/springs/weld_stage.hpp"
#include "src/step/turn_springs/turn_spring_stage.hpp"

namespace percuss {
namespace {

const std::vector<double> no_damping;
const std::vector<Wrench> no_reactions;

}  // namespace

// The order counts where two act at the same moment: conditions hold what damping has slowed down; rigid bodies have
// their velocities before welds and constraints join their nodes, and bars in solids come last. The columns of the
// history have this order, too.
Actions make_actions(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact) {
  Actions actions;
  const auto add = [&](auto action) {
    auto* const of = action.get();
    actions.all.push_back(std::move(action));
    return of;
  };
  const std::vector<double>* damping = &no_damping;
  if (!model.dampings.empty()) damping = &add(std::make_unique<DampingStage>(model))->coefficients();
  add(std::make_unique<ConditionStage>(model));
  const std::vector<Wrench>* reactions = &no_reactions;
  if (model.rigid.any()) {
    actions.rigid = add(std::make_unique<RigidStage>(model, *damping, deck.time.end));
    reactions = &actions.rigid->reactions();
  }
  if (model.springs.any()) add(std::make_unique<SpringStage>(model));
  if (!model.turn_springs.empty()) add(std::make_unique<TurnSpringStage>(model));
  if (model.glue.any()) add(std::make_unique<GlueStage>(deck, model, contact));
  if (model.welds.any()) add(std::make_unique<WeldStage>(model));
  if (model.constraints.any()) add(std::make_unique<ConstraintStage>(model));
  if (model.embedded.any()) add(std::make_unique<EmbeddedStage>(chunked, model));
  if (model.has_fluids) add(std::make_unique<FluidStage>(chunked, model));
  add(std::make_unique<LoadStage>(deck, model));
  if (model.scales_in_run) add(std::make_unique<MassScaler>(deck, chunked, model));
  add(std::make_unique<WallMotions>(deck, contact));
  actions.sensors = add(std::make_unique<Sensors>(deck, model.ranks));
  actions.forces = add(std::make_unique<ForceBooks>(deck, chunked, model, contact, *reactions));
  add(std::make_unique<Accelerometers>(deck, chunked, model));
  return actions;
}

}  // namespace percuss
