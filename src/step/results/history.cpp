#include "src/step/results/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/history_parts.hpp"
#include "src/deck/make_material.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/results/element_fields.hpp"

namespace percuss {

namespace {

/// Columns of a followed element that only some materials fill.
struct ThermalColumn {
  HistoryScalar name;
  const char* suffix;
};

/// Those that a material of the scene fills.
std::vector<ThermalColumn> find_thermal_columns(const Deck& deck) {
  std::vector<ThermalColumn> columns;
  for (const ThermalColumn& column : {ThermalColumn{HistoryScalar::temperature, "temperature"},
                                      ThermalColumn{HistoryScalar::internal_energy, "energy"}}) {
    if (std::any_of(deck.materials.begin(), deck.materials.end(),
                    [&](const MaterialDeck& material) { return has_scalar(material, column.name); })) {
      columns.push_back(column);
    }
  }
  return columns;
}

std::vector<HistoryScalar> name_thermal_columns(const Deck& deck) {
  std::vector<HistoryScalar> names;
  for (const ThermalColumn& column : find_thermal_columns(deck)) names.push_back(column.name);
  return names;
}

bool can_fail(const Deck& deck) {
  return std::any_of(deck.materials.begin(), deck.materials.end(),
                     [](const MaterialDeck& material) { return material.failure.has_value(); });
}

bool removes_nodes(const Deck& deck) {
  return can_fail(deck) && deck.erosion.free_nodes == ErosionDeck::FreeNodes::remove;
}

std::vector<std::string> make_columns(const std::vector<FollowedPoint>& points, const Deck& deck) {
  std::vector<std::string> columns{"time",       "step",       "dt",         "dt_element", "kinetic",   "internal",
                                   "hourglass",  "viscous",    "contact",    "friction",   "external",  "energy_error",
                                   "momentum_x", "momentum_y", "momentum_z", "angular_x",  "angular_y", "angular_z",
                                   "contacts",   "candidates", "iterations", "residual"};
  using Enforcement = ContactDeck::Enforcement;
  if (deck.contact.enforcement == Enforcement::lagrange) columns.emplace_back("complementarity");
  if (deck.contact.enforcement == Enforcement::penalty) columns.emplace_back("contact_stored");
  if (can_fail(deck)) columns.insert(columns.end(), {"eroded_elements", "eroded_mass", "eroded_energy"});
  if (removes_nodes(deck)) columns.emplace_back("vanished_mass");
  for (const std::string& pair : name_contact_pairs(deck))
    columns.insert(columns.end(), {"contact:" + pair, "friction:" + pair});
  if (!deck.walls.empty()) columns.insert(columns.end(), {"wall_force_x", "wall_force_y", "wall_force_z"});
  const std::vector<std::string> of_parts = name_columns(find_booked_parts(deck));
  columns.insert(columns.end(), of_parts.begin(), of_parts.end());
  for (const FollowedPoint& p : points) {
    const std::vector<const char*> suffixes =
        p.is_element ? std::vector<const char*>{"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz",
                                                "stress_zx", "pressure",  "von_mises", "eps"}
                     : std::vector<const char*>{"x", "y", "z", "vx", "vy", "vz"};
    for (const char* suffix : suffixes) columns.push_back(p.name + "_" + suffix);
    if (!p.is_element) continue;
    for (const ThermalColumn& column : find_thermal_columns(deck)) columns.push_back(p.name + "_" + column.suffix);
  }
  return columns;
}

}  // namespace

History::History(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked)
    : ranks_(find_ranks(chunked.mesh)),
      has_walls_(!deck.walls.empty()),
      removes_nodes_(removes_nodes(deck)),
      enforcement_(deck.contact.enforcement),
      points_(find_history_points(deck, chunked)),
      parts_(deck, chunked),
      thermal_(name_thermal_columns(deck)) {
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0) file_.emplace(directory + "/history.csv", make_columns(points_, deck));
  });
}

History::History(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, std::int64_t bytes)
    : ranks_(find_ranks(chunked.mesh)),
      has_walls_(!deck.walls.empty()),
      removes_nodes_(removes_nodes(deck)),
      enforcement_(deck.contact.enforcement),
      points_(find_history_points(deck, chunked)),
      parts_(deck, chunked),
      thermal_(name_thermal_columns(deck)) {
  fail_together(ranks_, [&] {
    if (ranks_.rank() == 0) file_.emplace(directory + "/history.csv", make_columns(points_, deck), bytes);
  });
}

void History::check(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, std::int64_t bytes) {
  const std::vector<FollowedPoint> points = find_history_points(deck, chunked);
  const Communicator ranks = find_ranks(chunked.mesh);
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) check_history_file(directory + "/history.csv", make_columns(points, deck), bytes);
  });
}

/// Appends the values of the followed points on rank 0. Each is known to one rank; the others give zeros, and their
/// bits are put together.
void History::gather_points(const Model& model, const State& state, std::vector<double>& row) const {
  if (points_.empty()) return;
  std::vector<int> elements;
  for (const FollowedPoint& p : points_) {
    if (p.is_element && p.index >= 0) elements.push_back(p.index);
  }
  const std::vector<double> stresses = find_stresses(model, state, elements);
  const std::vector<double> strains = find_plastic_strains(model, state, elements);
  std::vector<std::vector<double>> thermal;
  for (const HistoryScalar name : thermal_) thermal.push_back(find_history(model, state, name, elements));
  const std::vector<double> pressures = find_pressures(stresses), von_mises = find_von_mises(stresses);
  const auto x = to_host(state.x), v = to_host(state.v);
  std::vector<double> values;
  std::size_t e = 0;  // of the elements of this rank
  for (const FollowedPoint& p : points_) {
    if (p.index < 0) {
      values.insert(values.end(), p.is_element ? 9 + thermal.size() : 6, 0.0);
    } else if (p.is_element) {
      values.insert(values.end(), &stresses[6 * e], &stresses[6 * e] + 6);
      values.insert(values.end(), {pressures[e], von_mises[e], strains[e]});
      for (const std::vector<double>& column : thermal) values.push_back(column[e]);
      ++e;
    } else {
      const auto n = static_cast<std::size_t>(p.index);
      values.insert(values.end(), {x(n, 0), x(n, 1), x(n, 2), v(n, 0), v(n, 1), v(n, 2)});
    }
  }
  const bool is_root = ranks_.rank() == 0;
  wait_mpi(
      [&] {
        return MPI_Reduce(is_root ? MPI_IN_PLACE : values.data(), values.data(), static_cast<int>(values.size()),
                          MPI_UINT64_T, MPI_BOR, 0, ranks_.handle());
      },
      "MPI_Reduce");
  row.insert(row.end(), values.begin(), values.end());
}

void History::write(const Model& model, const State& state, const AuditResult& audit, const ContactReport& contact,
                    const Vec3& wall_force, const std::vector<double>& pair_work) {
  const EnergySummary& e = audit.energy;
  const MomentumSummary& m = audit.momentum;
  std::vector<double> row{state.time,
                          static_cast<double>(state.step),
                          state.dt,
                          static_cast<double>(state.bound.element_id),
                          e.kinetic,
                          e.internal,
                          e.hourglass,
                          e.viscous,
                          e.contact,
                          e.friction,
                          e.external,
                          e.error,
                          m.linear[0],
                          m.linear[1],
                          m.linear[2],
                          m.angular[0],
                          m.angular[1],
                          m.angular[2],
                          static_cast<double>(contact.interactions),
                          static_cast<double>(contact.candidates),
                          static_cast<double>(contact.iterations),
                          contact.residual};
  if (enforcement_ == ContactDeck::Enforcement::lagrange) row.push_back(contact.complementarity);
  if (enforcement_ == ContactDeck::Enforcement::penalty) row.push_back(contact.stored);
  if (model.can_erode) {
    row.insert(row.end(), {static_cast<double>(audit.eroded.elements), audit.eroded.mass, audit.eroded.energy});
  }
  if (removes_nodes_) row.push_back(audit.eroded.vanished_mass);
  row.insert(row.end(), pair_work.begin(), pair_work.end());
  if (has_walls_) row.insert(row.end(), wall_force.begin(), wall_force.end());
  parts_.append(model, state, row);
  gather_points(model, state, row);
  fail_together(ranks_, [&] {
    if (file_) file_->write_row(row);
  });
}

void History::sync() {
  fail_together(ranks_, [&] {
    if (file_) file_->sync();
  });
}

std::int64_t History::find_length() {
  std::int64_t bytes = 0;
  fail_together(ranks_, [&] {
    if (!file_) return;
    file_->flush();
    bytes = file_->length();
  });
  wait_mpi([&] { return MPI_Bcast(&bytes, 1, MPI_INT64_T, 0, ranks_.handle()); }, "MPI_Bcast");
  return bytes;
}

void History::flush() {
  fail_together(ranks_, [&] {
    if (file_) file_->flush();
  });
}

void History::close() {
  fail_together(ranks_, [&] {
    if (file_) file_->close();
  });
}

bool History::is_in_place() const {
  int in_place = !file_ || file_->is_in_place() ? 1 : 0;
  wait_mpi([&] { return MPI_Bcast(&in_place, 1, MPI_INT, 0, ranks_.handle()); }, "MPI_Bcast");
  return in_place != 0;
}

}  // namespace percuss
