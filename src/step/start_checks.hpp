#pragma once
// The rules on suspicious input (src/checks) over a scene that is about to run.

#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model.hpp"
#include "src/warning.hpp"

namespace percuss {

/// What the rules find. contact: prepared where it is active; first_step: [time], 0 if it is not known. The same on all
/// ranks, what the deck silences included. Collective. Throws MpiError.
std::vector<Warning> check_start(const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                                 const ContactStage& contact, double first_step);

}  // namespace percuss
