#pragma once
// What a run warns of besides its results: before the loop what its input and its ranks ask attention for, in a step
// what contact did not do, after the loop what the results must be read with. Who tells it is the run's business
// (run.cpp).

#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/output/summary.hpp"
#include "src/step/audit/hourglass_report.hpp"
#include "src/step/model/model.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Doubts about the mesh, elements that coordinates hardly resolve, ranks without elements. Collective. Throws
/// InputError, the same on all ranks, where coordinates do not resolve the elements.
std::vector<Warning> find_start_warnings(const Deck& deck, const ChunkedMesh& chunked);

/// Contact of a step that was not enforced to its tolerance.
std::vector<Warning> warn_of_residual(const ContactReport& contact, double time);

constexpr const char* deep_penetration = "deep_penetration";  // the rule of warn_of_depth()

/// Whether contact is so deep that a run warns of it. accepted_depth: the deepest at the start / face edge.
bool is_deep(const ContactReport& contact, double accepted_depth);

/// The warning of it. deepest: names the node that is deepest.
Warning warn_of_depth(double time, const std::string& deepest);

/// Scales by which the energies of a run are judged at its end [energy].
struct EnergyScales {
  double largest = 0;         // that was held in any state
  double resolved = 0;        // below this it is of motions that positions or steps do not resolve: round-off
  double stored = 0;          // in the springs of contact
  double stored_slip = 0;     // of that, in the tangential ones
  double largest_strain = 0;  // that elements held in any state
  double granted =
      0;  // that contact may have given: to push out overlap as asked, to hold what was loaded at the start
};

/// Energy of a velocity that moves the scene in a step by no more than what contact takes for round-off.
double find_resolved_energy(const ChunkedMesh& chunked, const Model& model, double dt);

/// Limits above which hourglass modes are reported: a tenth of what a part stores besides, and energy that is not
/// round-off.
HourglassLimits find_hourglass_limits(const EnergyScales& scales);

/// Energy that contact has given by its own books: by its pushes or by friction, whichever is more. work, friction: of
/// its normal and tangential impulses so far.
double find_given(double work, double friction, const EnergyScales& scales);

/// Energy that normal contact has taken and does not give back; 0: round-off. stored_at_start: in its springs at time
/// 0.
double find_taken(double work, double stored_at_start, const EnergyScales& scales);

/// Whether that is more than a share of the largest energy, and than round-off.
bool is_gain(double given, double share, const EnergyScales& scales);

/// The share of the largest energy from which on a run warns, or that the deck lets contact give at most.
double find_tolerated_gain(const AuditDeck& audit);

/// Energy that elements have given beyond what they took: that of hourglass modes, or of stresses and these. Stresses
/// may give what an equation of state had at the start: `starts_empty` tells that there is none.
double find_given_by_elements(const EnergySummary& energy, bool starts_empty);

/// The warning of it, if it is more than a share of the largest energy, and than round-off.
std::vector<Warning> warn_of_elements(double given, const EnergyScales& scales, double time, const std::string& units);

/// Where contact was first found to have given too much.
struct GainPlace {
  std::int64_t step = 0;
  std::int64_t node = -1;  // the user's id of the node whose push gave most in that step; -1: none was found
  Vec3 place{};            // where it was
  double time = 0;
};

/// "19 J, 16 % of the largest, by step 201 (most at node 5 at (0, 0, 1))".
std::string describe_gain(double given, const EnergyScales& scales, const GainPlace& where, const std::string& units);

/// The warning of it.
Warning warn_of_gain(double given, const EnergyScales& scales, const GainPlace& where, const std::string& units);

/// A balance that is off, hourglass modes. `summary` is that of the run's end.
std::vector<Warning> find_end_warnings(const Summary& summary, const EnergyScales& scales,
                                       const std::vector<PartHourglass>& parts);

}  // namespace percuss
