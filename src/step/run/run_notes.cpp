#include "src/step/run/run_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/contact/geometry/contact_limits.hpp"
#include "src/deck/units.hpp"
#include "src/step/audit/coordinate_precision.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/run/run_totals.hpp"

namespace percuss {

namespace {

/// Share of the largest energy: more that elements give is reported.
constexpr double noted_element_share = 0.01;

/// Share of what a part stores besides: more in its hourglass modes is reported ...
constexpr double noted_hourglass_share = 0.1;
/// All of it where a control bends elements that is not the stiffness of the material: of three layers a ninth of the
/// energy of bending is there, of two a quarter.
constexpr double noted_whole_share = 0.2;
/// Share of the largest strain energy of the scene, all parts together: what still rings after an impact means nothing,
/// nor does a small body that rings beside one that bends.
constexpr double noted_scene_share = 0.02;
/// ... unless it is so small beside the largest energy of the scene that it means nothing.
constexpr double noted_energy_share = 1e-3;

/// Share of the largest energy: contact gives back what its springs hold and what was requested of it, and no more.
constexpr double noted_contact_share = 0.01;

/// Share of the largest energy: a balance that is off by more is reported, long before audit.max_energy_error ends the
/// run.
constexpr double noted_energy_error = 0.01;

/// Share of a face edge, beyond what was accepted at the start: the contact of a node is lost at a quarter.
constexpr double noted_depth = 0.1;

/// Motions of up to this many depth tolerances of contact in a step are round-off of contact, too.
constexpr double motions_in_tolerance = 10;

Warning describe_hourglass(const PartHourglass& part, double time) {
  const std::string share =
      part.hourglass > part.stored ? "more than" : fmt::format("{:.0f} % of", 100 * part.hourglass / part.stored);
  if (part.is_fluid)
    return {
        "hourglass_energy",
        fmt::format("hourglass modes hold {} the strain energy of a fluid, most of it near {} (its pressure does not "
                    "resist them, and what its control holds resists the flow): check elements.hourglass of this "
                    "part, or refine the mesh there",
                    share, part.element),
        "part '" + part.part + "'", time, 1};
  return {"hourglass_energy",
          fmt::format("hourglass modes hold {} the strain energy, most of it near {} (not that of smooth "
                      "bending: single nodes carry the load, or the mesh is too coarse there): refine the mesh there, "
                      "spread the load, or with hexahedra use elements: {{integration: full}}",
                      share, part.element),
          "part '" + part.part + "'", time, 1};
}

}  // namespace

std::vector<Warning> find_start_warnings(const Deck& deck, const ChunkedMesh& chunked) {
  std::vector<Warning> warnings = chunked.mesh.warnings;
  for (const Warning& warning : check_coordinate_precision(deck, chunked)) warnings.push_back(warning);
  const int ranks = find_ranks(chunked.mesh).size();
  if (const int idle = count_idle_ranks(chunked.numbering, ranks); idle > 0) {
    warnings.push_back(
        {"idle_ranks",
         fmt::format(
             "{} of {} ranks have no elements (the mesh has {} chunks, and a chunk is never split): use fewer ranks",
             idle, ranks, chunked.numbering.chunk_count()),
         "", 0, 1});
  }
  return warnings;
}

std::vector<Warning> warn_of_residual(const ContactReport& contact, double time) {
  if (contact.converged) return {};
  return {{"unconverged_contact",
           "the contact enforcement did not converge in a step (some penetration remains): see the column residual of "
           "history.csv",
           "", time, 1}};
}

bool is_deep(const ContactReport& contact, double accepted_depth) {
  return contact.deepest > accepted_depth + noted_depth;
}

Warning warn_of_depth(double time, const std::string& deepest) {
  return {deep_penetration,
          fmt::format(
              "a contact node penetrates deeper than {:g} of a face edge{}{} (contact is lost at {:g}): use a finer "
              "mesh there, a smaller time.step_scale, or with penalty a larger contact.penalty_scale",
              noted_depth, deepest.empty() ? "" : ", first ", deepest, contact_limits::history_depth),
          "", time, 1};
}

double find_resolved_energy(const ChunkedMesh& chunked, const Model& model, double dt) {
  if (!(dt > 0)) return 0;
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    farthest = std::max({farthest, std::abs(chunked.mesh.low[k]), std::abs(chunked.mesh.high[k])});
  const double speed = motions_in_tolerance * contact_limits::depth_tolerance * farthest / dt;
  return 0.5 * model.total_mass * speed * speed;
}

HourglassLimits find_hourglass_limits(const EnergyScales& scales) {
  return {noted_hourglass_share, std::max(scales.resolved, noted_energy_share * scales.largest), noted_whole_share,
          noted_scene_share * scales.largest_strain};
}

double find_given(double work, double friction, const EnergyScales& scales) {
  return std::max(work + scales.stored - scales.stored_slip, friction + scales.stored_slip) - scales.granted;
}

double find_taken(double work, double stored_at_start, const EnergyScales& scales) {
  const double taken = stored_at_start - work - (scales.stored - scales.stored_slip);
  return taken > scales.resolved ? taken : 0;
}

bool is_gain(double given, double share, const EnergyScales& scales) {
  return given > std::max(share * scales.largest, scales.resolved);
}

double find_tolerated_gain(const AuditDeck& audit) { return audit.max_contact_gain.value_or(noted_contact_share); }

std::string describe_gain(double given, const EnergyScales& scales, const GainPlace& where, const std::string& units) {
  const std::string share =
      scales.largest > 0 ? fmt::format(", {:.3g} % of the largest,", 100 * given / scales.largest) : "";
  std::string text = fmt::format("{:.3g}{} of energy{} first above the limit in step {}", given,
                                 unit_suffix(units, dimensions::energy), share, where.step);
  if (where.node >= 0)
    text += fmt::format(", most of it then at node {} at ({:.6g}, {:.6g}, {:.6g})", where.node, where.place[0],
                        where.place[1], where.place[2]);
  return text;
}

Warning warn_of_gain(double given, const EnergyScales& scales, const GainPlace& where, const std::string& units) {
  return {"contact_energy",
          fmt::format("contact has added {} (contact may only dissipate or store energy): check jumps of the "
                      "columns contact and friction in history.csv, sliver elements and overlapping parts",
                      describe_gain(given, scales, where, units)),
          "", where.time, 1};
}

double find_given_by_elements(const EnergySummary& energy, bool starts_empty) {
  const double hourglass = -energy.hourglass();
  return starts_empty ? std::max({hourglass, -energy.internal(), -energy.internal() - energy.hourglass()}) : hourglass;
}

std::vector<Warning> warn_of_elements(double given, const EnergyScales& scales, double time, const std::string& units) {
  if (!is_gain(given, noted_element_share, scales)) return {};
  return {
      {"element_energy",
       fmt::format("elements have given {:.3g}{} of energy more than they took, {:.3g} % of the largest (strains of "
                   "order one, or a long vibration without damping): keep the default bulk viscosity, and look at "
                   "the columns internal and hourglass of history.csv",
                   given, unit_suffix(units, dimensions::energy), 100 * given / scales.largest),
       "", time, 1}};
}

std::vector<Warning> find_end_warnings(const Summary& summary, const EnergyScales& scales,
                                       const std::vector<PartHourglass>& parts) {
  std::vector<Warning> warnings;
  const EnergySummary& energy = summary.energy;
  if (std::abs(energy.error) > noted_energy_error && scales.largest > scales.resolved) {
    warnings.push_back({"energy_error",
                        fmt::format("the energy balance is off by {:.2g} % of the largest energy (a stable run closes "
                                    "it far better): use a smaller time.step_scale and check history.csv",
                                    100 * energy.error),
                        "", summary.time, 1});
  }
  for (const PartHourglass& part : parts) warnings.push_back(describe_hourglass(part, summary.time));
  return warnings;
}

}  // namespace percuss
