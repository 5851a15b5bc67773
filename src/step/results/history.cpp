#include "src/step/results/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/results/fields/element_fields.hpp"

namespace percuss {

namespace {

/// A column of a followed node or element.
struct PointColumn {
  const char* suffix;
  Dimension dimension;
  const char* meaning;  // {}: the name of the point
};

constexpr PointColumn node_columns[] = {
    {"x", dimensions::length, "position in x of {}"},    {"y", dimensions::length, "position in y of {}"},
    {"z", dimensions::length, "position in z of {}"},    {"vx", dimensions::velocity, "velocity in x of {}"},
    {"vy", dimensions::velocity, "velocity in y of {}"}, {"vz", dimensions::velocity, "velocity in z of {}"}};
constexpr PointColumn element_columns[] = {{"stress_xx", dimensions::stress, "stress xx of {}"},
                                           {"stress_yy", dimensions::stress, "stress yy of {}"},
                                           {"stress_zz", dimensions::stress, "stress zz of {}"},
                                           {"stress_xy", dimensions::stress, "stress xy of {}"},
                                           {"stress_yz", dimensions::stress, "stress yz of {}"},
                                           {"stress_zx", dimensions::stress, "stress zx of {}"},
                                           {"pressure", dimensions::stress, "pressure of {}, positive in compression"},
                                           {"von_mises", dimensions::stress, "von Mises stress of {}"},
                                           {"eps", {}, "equivalent plastic strain of {}"}};

/// Columns of a followed element in a scene with beams.
constexpr PointColumn beam_columns[] = {
    {"axial_force", dimensions::force, "axial force of {}, positive in tension"},
    {"shear_y", dimensions::force, "shear force along y of {}, in the axes of the section"},
    {"shear_z", dimensions::force, "shear force along z of {}, in the axes of the section"},
    {"torque", dimensions::energy, "torque of {}"},
    {"moment_y", dimensions::energy, "bending moment about y of {}, in the axes of the section"},
    {"moment_z", dimensions::energy, "bending moment about z of {}, in the axes of the section"}};

/// Whether some part may have beams.
bool has_sections(const Deck& deck) {
  return std::any_of(deck.parts.begin(), deck.parts.end(),
                     [](const PartDeck& part) { return part.section.has_value(); });
}

/// Columns of a followed element that only some materials fill.
struct ScalarColumn {
  HistoryScalar name;
  const char* suffix;
  Dimension dimension;
  const char* meaning;
  HistoryColumn::Kind kind = HistoryColumn::Kind::by_dimension;
};

const ScalarColumn scalar_columns[] = {
    {HistoryScalar::temperature, "temperature", {}, "temperature of {}", HistoryColumn::Kind::temperature},
    {HistoryScalar::internal_energy, "energy", dimensions::stress, "internal energy of {}, per initial volume"},
    {HistoryScalar::void_fraction, "void_fraction", {}, "void fraction of {}"},
};

/// Columns that a material of the scene fills.
std::vector<ScalarColumn> find_scalar_columns(const Deck& deck) {
  std::vector<ScalarColumn> columns;
  for (const ScalarColumn& column : scalar_columns) {
    if (std::any_of(deck.materials.begin(), deck.materials.end(),
                    [&](const MaterialDeck& material) { return has_scalar(material, column.name); })) {
      columns.push_back(column);
    }
  }
  return columns;
}

std::vector<HistoryScalar> name_scalar_columns(const Deck& deck) {
  std::vector<HistoryScalar> names;
  for (const ScalarColumn& column : find_scalar_columns(deck)) names.push_back(column.name);
  return names;
}

int count_state_variables(const Deck& deck) {
  int most = 0;
  for (const MaterialDeck& material : deck.materials) most = std::max(most, count_state_variables(material));
  return most;
}

std::string describe_point(const char* meaning, const FollowedPoint& point) {
  return fmt::format(fmt::runtime(meaning), "'" + point.name + "'");
}

void add_point_columns(const FollowedPoint& point, const Deck& deck, std::vector<HistoryColumn>& columns) {
  const auto add = [&](std::span<const PointColumn> of_point) {
    for (const PointColumn& c : of_point)
      columns.push_back(
          {point.name + "_" + c.suffix, c.dimension, describe_point(c.meaning, point),
           c.dimension == dimensions::energy ? HistoryColumn::Kind::moment : HistoryColumn::Kind::by_dimension});
  };
  if (!point.is_element) return add(node_columns);
  add(element_columns);
  if (has_sections(deck)) add(beam_columns);
  for (const ScalarColumn& c : find_scalar_columns(deck))
    columns.push_back({point.name + "_" + c.suffix, c.dimension, describe_point(c.meaning, point), c.kind});
  for (int i = 1; i <= count_state_variables(deck); ++i)
    columns.push_back({fmt::format("{}_state_{}", point.name, i), Dimension{},
                       fmt::format("state variable {} of '{}'", i, point.name), HistoryColumn::Kind::by_dimension});
}

std::vector<HistoryColumn> list_all_columns(const HistoryScene& scene, const std::vector<FollowedPoint>& points) {
  const Deck& deck = scene.deck;
  std::vector<HistoryColumn> columns = HistoryTable(deck).columns();
  const auto add = [&](const std::vector<HistoryColumn>& more) {
    columns.insert(columns.end(), more.begin(), more.end());
  };
  add(list_part_columns(find_booked_parts(deck)));
  add(list_motion_columns(deck));
  add(list_block_columns(deck));
  add(scene.stepper.list_columns());
  for (const FollowedPoint& point : points) add_point_columns(point, deck, columns);
  return columns;
}

}  // namespace

History::History(const std::string& directory, const HistoryScene& scene, std::optional<std::int64_t> bytes)
    : ranks_(find_ranks(scene.chunked.mesh)),
      table_(scene.deck),
      points_(find_history_points(scene.deck, scene.chunked)),
      parts_(scene.deck, scene.chunked),
      motions_(scene.deck, scene.chunked),
      blocks_(scene.deck, scene.chunked),
      has_sections_(has_sections(scene.deck)),
      scalars_(name_scalar_columns(scene.deck)),
      states_(count_state_variables(scene.deck)) {
  fail_together(ranks_, [&] {
    if (ranks_.rank() != 0 || directory.empty()) return;
    const std::vector<HistoryColumn> columns = list_all_columns(scene, points_);
    const std::string path = directory + "/history.csv";
    if (bytes)
      file_.emplace(path, name_columns(columns), *bytes);
    else
      file_.emplace(path, name_columns(columns));
    write_file_atomically(directory + "/columns.json", format_columns(columns, scene.deck.units), Durability::system);
  });
}

std::vector<HistoryColumn> History::list_columns(const HistoryScene& scene) {
  return list_all_columns(scene, find_history_points(scene.deck, scene.chunked));
}

void History::check_points(const Deck& deck, const ChunkedMesh& chunked, const Model& model) {
  for (const FollowedPoint& point : find_history_points(deck, chunked)) {
    if (point.layer < 0) continue;
    int points = point.index < 0 ? 0 : count_points(model, point.index);
    all_reduce(find_ranks(chunked.mesh), Reduce::largest, points);
    if (point.layer < points) continue;
    const auto entry = std::find_if(deck.output.points.begin(), deck.output.points.end(),
                                    [&](const HistoryPoint& p) { return p.name == point.name; });
    throw InputError(
        fmt::format("{}: error: history point '{}' is point {} of an element that has {} (of shells it "
                    "counts across the thickness)",
                    deck.where(entry->place), point.name, point.layer + 1, points));
  }
}

void History::check(const std::string& directory, const HistoryScene& scene, std::int64_t bytes) {
  const std::vector<HistoryColumn> columns = list_columns(scene);
  const Communicator ranks = find_ranks(scene.chunked.mesh);
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) check_history_file(directory + "/history.csv", name_columns(columns), bytes);
  });
}

namespace {

/// Place and velocity of a material point; zeros where this rank does not have its element.
template <class HostRows>
std::array<double, 6> find_point_motion(const FollowedPoint& point, const HostRows& x, const HostRows& v) {
  std::array<double, 6> motion{};
  for (const auto& [node, weight] : point.shares) {
    for (std::size_t k = 0; k < 3; ++k) {
      motion[k] += weight * x(static_cast<std::size_t>(node), k);
      motion[3 + k] += weight * v(static_cast<std::size_t>(node), k);
    }
  }
  return motion;
}

/// The followed elements of this rank.
std::vector<int> list_elements(const std::vector<FollowedPoint>& points) {
  std::vector<int> elements;
  for (const FollowedPoint& p : points) {
    if (p.is_element && p.index >= 0) elements.push_back(p.index);
  }
  return elements;
}

/// Puts the values of one point in the place of the element's, where the deck requests it. stresses, strains: in and
/// out, of the followed elements of this rank.
void put_points(const Model& model, const State& state, const std::vector<FollowedPoint>& points,
                std::vector<double>& stresses, std::vector<double>& strains) {
  std::size_t e = 0;
  for (const FollowedPoint& p : points) {
    if (!p.is_element || p.index < 0) continue;
    if (p.layer >= 0) {
      const std::vector<double> stress = find_point_stress(model, state, {p.index, p.layer});
      std::copy(stress.begin(), stress.end(), stresses.begin() + static_cast<std::ptrdiff_t>(6 * e));
      strains[e] = find_point_plastic_strain(model, state, {p.index, p.layer});
    }
    ++e;
  }
}

}  // namespace

/// Appends the values of the followed points on rank 0. Each is known to one rank; the others give zeros, and their
/// bits are put together.
void History::gather_points(const Model& model, const State& state, std::vector<double>& row) const {
  if (points_.empty()) return;
  const std::vector<int> elements = list_elements(points_);
  std::vector<double> stresses = find_stresses(model, state, elements);
  std::vector<double> strains = find_plastic_strains(model, state, elements);
  put_points(model, state, points_, stresses, strains);
  const std::vector<double> sections =
      has_sections_ ? find_section_results(model, state, elements) : std::vector<double>();
  std::vector<std::vector<double>> others;
  for (const HistoryScalar name : scalars_) others.push_back(find_history(model, state, name, elements));
  for (int i = 0; i < states_; ++i) others.push_back(find_state_variables(model, state, i, elements));
  const std::vector<double> pressures = find_pressures(stresses), von_mises = find_von_mises(stresses);
  const auto x = to_host(state.x), v = to_host(state.v);
  std::vector<double> values;
  std::size_t e = 0;  // of the elements of this rank
  for (const FollowedPoint& p : points_) {
    if (p.is_inside) {
      const std::array<double, 6> place = find_point_motion(p, x, v);
      values.insert(values.end(), place.begin(), place.end());
    } else if (p.index < 0) {
      values.insert(values.end(), p.is_element ? 9 + (has_sections_ ? 6U : 0U) + others.size() : 6, 0.0);
    } else if (p.is_element) {
      values.insert(values.end(), &stresses[6 * e], &stresses[6 * e] + 6);
      values.insert(values.end(), {pressures[e], von_mises[e], strains[e]});
      if (has_sections_) values.insert(values.end(), &sections[6 * e], &sections[6 * e] + 6);
      for (const std::vector<double>& column : others) values.push_back(column[e]);
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

void History::write(const Model& model, const HistorySources& sources) {
  const State& state = sources.state;
  std::vector<double> row;
  table_.append(sources, row);
  parts_.append(model, state, row);
  motions_.append(model, state, row);
  blocks_.append(model, state, row);
  sources.stepper.append_values(state, row);
  gather_points(model, state, row);
  fail_together(ranks_, [&] {
    if (file_) file_->write_row(row);
  });
  row_ = std::move(row);
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
