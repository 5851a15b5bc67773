#include "src/step/results/history_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/deck/asked_for.hpp"
#include "src/deck/contact_springs.hpp"

namespace percuss {
namespace {

using From = HistorySources;

bool always(const Deck&) { return true; }
bool has_walls(const Deck& deck) { return !deck.walls.empty(); }
bool scales_in_run(const Deck& deck) { return deck.scales_mass_in_run(); }
bool removes_nodes(const Deck& deck) {
  return can_fail(deck) && deck.erosion.free_nodes == ErosionDeck::FreeNodes::remove;
}
bool resists_folding(const Deck& deck) { return deck.elements.resist_folding; }
bool is_damped(const Deck& deck) { return !deck.dampings.empty(); }
bool ties_can_fail(const Deck& deck) { return deck.contact.has_failing_ties(); }
bool is_lagrange(const Deck& deck) { return deck.contact.enforcement == ContactDeck::Enforcement::lagrange; }

struct HistoryEntry {
  const char* name;
  Dimension dimension;
  const char* meaning;
  bool (*has)(const Deck&);
  double (*value)(const HistorySources&);
};

constexpr Dimension no_dimension{};
constexpr Dimension angular_momentum{2, 1, -1};
namespace dim = dimensions;

constexpr HistoryEntry before_pairs[] = {
    {"time", dim::time, "time", always, [](const From& s) { return s.state.time; }},
    {"step", no_dimension, "time steps so far", always,
     [](const From& s) { return static_cast<double>(s.state.step); }},
    {"dt", dim::time, "time step, the one that ended at this row", always, [](const From& s) { return s.state.dt; }},
    {"dt_element", no_dimension,
     "id of the element that limits the next step; 0 if approaching bodies or a wall limit it", always,
     [](const From& s) { return s.is_approach_limiting ? 0.0 : static_cast<double>(s.state.bound.element_id); }},
    {"kinetic", dim::energy, "kinetic energy, that of rigid walls with a mass included", always,
     [](const From& s) { return s.audit.energy.kinetic; }},
    {"internal", dim::energy, "internal energy, the work of the stresses", always,
     [](const From& s) { return s.audit.energy.work[WorkKind::internal]; }},
    {"hourglass", dim::energy, "hourglass energy, the work of hourglass control and of drilling stiffness", always,
     [](const From& s) { return s.audit.energy.work[WorkKind::hourglass]; }},
    {"viscous", dim::energy, "viscous energy, the work of bulk viscosity and of dampers", always,
     [](const From& s) { return s.audit.energy.work[WorkKind::viscous]; }},
    {"folding", dim::energy, "folding energy, the work of the resistance to folding", resists_folding,
     [](const From& s) { return s.audit.energy.work[WorkKind::folding]; }},
    {"contact", dim::energy, "work of normal contact, rigid walls included", always,
     [](const From& s) { return s.audit.energy.contact; }},
    {"friction", dim::energy, "work of friction, negative where it dissipates", always,
     [](const From& s) { return s.audit.energy.friction; }},
    {"damping", dim::energy, "work of damping in proportion to mass", is_damped,
     [](const From& s) { return s.audit.energy.damping; }},
    {"external", dim::energy, "external work, by loads, gravity, prescribed motion and walls with a prescribed speed",
     always, [](const From& s) { return s.audit.energy.external; }},
    {"energy_error", no_dimension, "energy error, over the largest energy so far", always,
     [](const From& s) { return s.audit.energy.error; }},
    {"momentum_x", dim::momentum, "linear momentum in x", always,
     [](const From& s) { return s.audit.momentum.linear[0]; }},
    {"momentum_y", dim::momentum, "linear momentum in y", always,
     [](const From& s) { return s.audit.momentum.linear[1]; }},
    {"momentum_z", dim::momentum, "linear momentum in z", always,
     [](const From& s) { return s.audit.momentum.linear[2]; }},
    {"angular_x", angular_momentum, "angular momentum about x, at the centre of mass of time 0", always,
     [](const From& s) { return s.audit.momentum.angular[0]; }},
    {"angular_y", angular_momentum, "angular momentum about y, at the centre of mass of time 0", always,
     [](const From& s) { return s.audit.momentum.angular[1]; }},
    {"angular_z", angular_momentum, "angular momentum about z, at the centre of mass of time 0", always,
     [](const From& s) { return s.audit.momentum.angular[2]; }},
    {"contacts", no_dimension, "active contacts, tied nodes included", always,
     [](const From& s) { return static_cast<double>(s.contact.interactions); }},
    {"candidates", no_dimension, "candidate pairs of the contact search", always,
     [](const From& s) { return static_cast<double>(s.contact.candidates); }},
    {"iterations", no_dimension, "contact iterations, in this step", always,
     [](const From& s) { return static_cast<double>(s.contact.iterations); }},
    {"residual", no_dimension, "largest remaining penetration, divided by the edge length of its face", always,
     [](const From& s) { return s.contact.residual; }},
    {"complementarity", no_dimension, "violation of the contact conditions, over the largest closing velocity",
     is_lagrange, [](const From& s) { return s.contact.complementarity; }},
    {"contact_stored", dim::energy, "energy in contact springs", may_have_contact_springs,
     [](const From& s) { return s.contact.stored; }},
    {"failed_ties", no_dimension, "tied nodes that have failed", ties_can_fail,
     [](const From& s) { return static_cast<double>(s.contact.failed_ties); }},
    {"eroded_elements", no_dimension, "eroded elements", can_fail,
     [](const From& s) { return static_cast<double>(s.audit.eroded.elements); }},
    {"eroded_mass", dim::mass, "eroded mass", can_fail, [](const From& s) { return s.audit.eroded.mass; }},
    {"eroded_energy", dim::energy, "eroded energy, of elements and removed nodes", can_fail,
     [](const From& s) { return s.audit.eroded.energy; }},
    {"vanished_mass", dim::mass, "mass of removed nodes, part of eroded_mass", removes_nodes,
     [](const From& s) { return s.audit.eroded.vanished_mass; }},
    {"added_mass", dim::mass, "mass added by mass scaling, during the run", scales_in_run,
     [](const From& s) { return s.state.books.added_mass; }},
    {"added_energy", dim::energy, "kinetic energy of the added mass, part of external", scales_in_run,
     [](const From& s) { return s.state.books.added_energy; }},
};

constexpr HistoryEntry after_pairs[] = {
    {"wall_force_x", dim::force, "force of the rigid walls in x, on the bodies over the last step", has_walls,
     [](const From& s) { return s.wall_force[0]; }},
    {"wall_force_y", dim::force, "force of the rigid walls in y, on the bodies over the last step", has_walls,
     [](const From& s) { return s.wall_force[1]; }},
    {"wall_force_z", dim::force, "force of the rigid walls in z, on the bodies over the last step", has_walls,
     [](const From& s) { return s.wall_force[2]; }},
};

}  // namespace

HistoryTable::HistoryTable(const Deck& deck) {
  const auto take = [&](const HistoryEntry& entry, std::vector<Value>& values) {
    if (!entry.has(deck)) return;
    columns_.push_back({entry.name, entry.dimension, entry.meaning});
    values.push_back(entry.value);
  };
  for (const HistoryEntry& entry : before_pairs) take(entry, before_pairs_);
  for (const std::string& pair : name_contact_pairs(deck)) {
    columns_.push_back({"contact:" + pair, dim::energy, fmt::format("work of normal contact of pair '{}'", pair)});
    columns_.push_back({"friction:" + pair, dim::energy, fmt::format("work of friction of pair '{}'", pair)});
  }
  for (const HistoryEntry& entry : after_pairs) take(entry, after_pairs_);
}

void HistoryTable::append(const HistorySources& sources, std::vector<double>& row) const {
  for (const Value value : before_pairs_) row.push_back(value(sources));
  row.insert(row.end(), sources.pair_work.begin(), sources.pair_work.end());
  for (const Value value : after_pairs_) row.push_back(value(sources));
}

}  // namespace percuss
