#pragma once
// Parts that hold much of their energy in hourglass modes, and where: for the end of a run, not for its steps.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// A part with its energies [energy]; those of dead elements are not in them.
struct PartHourglass {
  std::string part;
  double stored = 0;  // of stresses, and of bending where the control resists it as the material does
  // Energy of motion that alternates from element to element; the rest is that of bending and twist. Or all of it,
  // where another control than the stiffness of the material bends the elements, and holds more than `whole_share`.
  double hourglass = 0;
  std::string element;    // "element 7 of part 'bar' at (1, 2, 3)": where most of it is
  bool is_fluid = false;  // it has no shear stiffness
};

/// Limits above which hourglass energy is reported: shares of what a part stores besides, and energies.
struct HourglassLimits {
  double share = 0, least = 0;
  double whole_share = 0;   // of all of it, where it is not the stiffness of the material
  double least_of_all = 0;  // of all these parts together
};

/// The parts whose hourglass energy is more than these shares of what they store besides and more than `least`, in the
/// order of the deck; the same on every rank. The element is the one whose hourglass displacement is largest in the
/// chunk that has most of the part's hourglass energy: the energy itself is summed by chunks only. Collective.
std::vector<PartHourglass> find_hourglassed_parts(const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                                                  const State& state, const HourglassLimits& limits);

}  // namespace percuss
