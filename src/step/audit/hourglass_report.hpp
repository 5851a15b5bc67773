#pragma once
// Which parts hold much of their energy in hourglass modes, and where: for the end of a run, not for its steps.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// A part with its energies [energy]; those of dead elements are not in them.
struct PartHourglass {
  std::string part;
  double internal = 0, hourglass = 0;
  std::string element;  // "element 7 of part 'bar' at (1, 2, 3)": where most of it is
};

/// The parts whose hourglass energy is more than `share` of their internal energy and more than `least`, in the order
/// of the deck; the same on every rank. The element is the one whose hourglass displacement is largest in the chunk
/// that has most of the part's hourglass energy: the energy itself is summed by chunks only. Collective.
std::vector<PartHourglass> find_hourglassed_parts(const ChunkedMesh& chunked, const Model& model, const State& state,
                                                  double share, double least);

}  // namespace percuss
