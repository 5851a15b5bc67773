#include "src/step/run_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/step/run_totals.hpp"

namespace percuss {

namespace {

/// Of the internal energy: more in hourglass modes is told ...
constexpr double noted_hourglass_share = 0.1;
/// ... unless both are so small beside the energy that moves that they mean nothing.
constexpr double noted_energy_share = 1e-3;

/// Of the largest energy: contact gives back what its springs hold and what it recovers of penetration, and no more.
constexpr double noted_contact_share = 0.01;

double find_largest(const EnergySummary& energy) {
  return std::max({energy.initial, std::abs(energy.kinetic), std::abs(energy.external)});
}

bool is_hourglassed(const EnergySummary& energy) {
  return find_largest(energy) > 0 && energy.internal > 0 &&
         energy.hourglass > noted_hourglass_share * energy.internal &&
         energy.hourglass > noted_energy_share * find_largest(energy);
}

}  // namespace

std::vector<Warning> find_start_warnings(const ChunkedMesh& chunked, int rank_count) {
  std::vector<Warning> warnings = chunked.mesh.warnings;
  if (const int idle = count_idle_ranks(chunked.numbering, rank_count); idle > 0) {
    warnings.push_back(
        {"idle_ranks",
         fmt::format("{} of {} ranks have no elements (the mesh has {} chunks, and a chunk is never divided): "
                     "start it on fewer ranks",
                     idle, rank_count, chunked.numbering.chunk_count()),
         "", 0, 1});
  }
  return warnings;
}

Warning describe_unconverged(double time) {
  return {"unconverged_contact",
          "the contact enforcement did not converge in a step (some penetration is left over): judge it by the column "
          "residual of history.csv",
          "", time, 1};
}

std::vector<Warning> find_end_warnings(const Summary& summary) {
  std::vector<Warning> warnings;
  if (const double largest = find_largest(summary.energy); summary.energy.contact > noted_contact_share * largest) {
    const std::string share =
        largest > 0 ? fmt::format(", {:.0f} % of the largest", 100 * summary.energy.contact / largest) : "";
    warnings.push_back(
        {"contact_energy",
         fmt::format("contact has given {:.3g} of energy{}: look where the column contact of history.csv "
                     "jumps, at elements crushed to slivers and at overlaps that are pushed out",
                     summary.energy.contact, share),
         "", summary.time, 1});
  }
  if (is_hourglassed(summary.energy)) {
    warnings.push_back({"hourglass_energy",
                        fmt::format("hourglass modes hold {:.0f} % of the internal energy (bending finer than the "
                                    "elements): compare with a finer mesh",
                                    100 * summary.energy.hourglass / summary.energy.internal),
                        "", summary.time, 1});
  }
  return warnings;
}

}  // namespace percuss
