#include "src/step/start_checks.hpp"

#include "src/checks/rules.hpp"

namespace percuss {

std::vector<Warning> check_start(const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                                 const ContactStage& contact, double first_step) {
  const SceneMeasures measures = measure_scene(deck, chunked, model.start_velocity);
  return check_scene({deck, &measures, &contact.start_overlap(), first_step});
}

}  // namespace percuss
