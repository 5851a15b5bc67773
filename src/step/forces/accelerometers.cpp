#include "src/step/forces/accelerometers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/followed_points.hpp"

namespace percuss {
namespace {

constexpr Dimension acceleration{1, 0, -2};
constexpr double least_sine = 1e-9;  // between two axes; below it round-off would turn them

Vec3 find_normal(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double find_length(const Vec3& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

Vec3 divide(const Vec3& a, double by) { return {a[0] / by, a[1] / by, a[2] / by}; }

/// Time of the velocities of a state.
double find_velocity_time(const State& state) { return state.time - 0.5 * state.dt; }

const FollowedPoint& find_node(const std::vector<FollowedPoint>& points, const std::string& name) {
  return *std::find_if(points.begin(), points.end(), [&](const FollowedPoint& point) { return point.name == name; });
}

}  // namespace

FoundAxes find_local_axes(const Vec3& origin, const Vec3& along_x, const Vec3& in_plane) {
  const Vec3 a = subtract(along_x, origin), b = subtract(in_plane, origin);
  const Vec3 normal = find_normal(a, b);
  const double long_a = find_length(a), area = find_length(normal);
  if (!(area > least_sine * long_a * find_length(b))) return {};
  const Vec3 x = divide(a, long_a), z = divide(normal, area);
  return {{x, find_normal(z, x), z}, true};
}

Accelerometers::Accelerometers(const Deck& deck, const ChunkedMesh& chunked, const Model& model)
    : deck_(deck), ranks_(model.ranks) {
  if (deck.output.accelerometers.empty()) return;
  const std::vector<FollowedPoint> points = find_history_points(deck, chunked);
  for (const AccelerometerDeck& one : deck.output.accelerometers) {
    Nodes of;
    for (std::size_t i = 0; i < 3; ++i) of.nodes[i] = find_node(points, one.nodes[i]).index;
    of.removes_gravity = one.gravity == AccelerometerDeck::Weight::remove;
    nodes_.push_back(of);
  }
  sums_.resize(nodes_.size());
  note_places(model.start);
  share_values();
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const FoundAxes found = find_local_axes(value(i, 0), value(i, 1), value(i, 2));
    if (!found.is_given)
      throw InputError(
          fmt::format("{}: error: the nodes of accelerometer '{}' are on a line (they give no axes): name "
                      "three that span a plane",
                      deck.where(deck.output.accelerometers[i].place), deck.output.accelerometers[i].name));
    sums_[i].axes = found.axes;
  }
}

/// Places in their columns, zeros in the others.
void Accelerometers::note_places(const Rows3<double>& x) {
  values_.assign(values_each * nodes_.size(), 0.0);
  const auto places = to_host(x);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (std::size_t node = 0; node < 3; ++node)
      for (std::size_t k = 0; nodes_[i].nodes[node] >= 0 && k < 3; ++k)
        values_[values_each * i + 3 * node + k] = places(static_cast<std::size_t>(nodes_[i].nodes[node]), k);
}

/// Each value is known to one rank; the others have zeros, and their bits are put together.
void Accelerometers::share_values() {
  if (ranks_.size() == 1) return;
  wait_mpi(
      [&] {
        return MPI_Allreduce(MPI_IN_PLACE, values_.data(), static_cast<int>(values_.size()), MPI_UINT64_T, MPI_BOR,
                             ranks_.handle());
      },
      "MPI_Allreduce");
}

/// which: a place, 3: the velocity.
Vec3 Accelerometers::value(std::size_t accelerometer, std::size_t which) const {
  const double* const at = &values_[values_each * accelerometer + 3 * which];
  return {at[0], at[1], at[2]};
}

void Accelerometers::begin_step(const State& state, const StepTimes& /*times*/) {
  if (nodes_.empty()) return;
  note_places(state.x);
  const auto v = to_host(state.v);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (std::size_t k = 0; nodes_[i].nodes[0] >= 0 && k < 3; ++k)
      values_[values_each * i + 9 + k] = v(static_cast<std::size_t>(nodes_[i].nodes[0]), k);
}

void Accelerometers::move(State& state, const StepTimes& times) {
  if (nodes_.empty()) return;
  const auto v = to_host(state.v);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (std::size_t k = 0; nodes_[i].nodes[0] >= 0 && k < 3; ++k) {
      double& change = values_[values_each * i + 9 + k];
      change = v(static_cast<std::size_t>(nodes_[i].nodes[0]), k) - change;
      if (nodes_[i].removes_gravity) change -= times.dt_mean * state.gravity.g[k];
    }
  }
  share_values();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const FoundAxes found = find_local_axes(value(i, 0), value(i, 1), value(i, 2));
    if (found.is_given) sums_[i].axes = found.axes;
    const Vec3 change = value(i, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& axis = sums_[i].axes[k];
      sums_[i].change[k] += axis[0] * change[0] + axis[1] * change[1] + axis[2] * change[2];
    }
  }
}

void Accelerometers::archive(CheckpointArchive& archive, State& /*state*/) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const AccelerometerDeck& one = deck_.output.accelerometers[i];
    const std::string name = fmt::format("accelerometers/{}:{}:{}", one.name, fmt::join(one.nodes, ","),
                                         one.gravity == AccelerometerDeck::Weight::remove ? "remove" : "keep");
    Sums& sums = sums_[i];
    if (!archive.has_number(name + "/last_row")) {
      sums.is_new = true;
      continue;
    }
    archive.number(name + "/last_row", sums.last_row);
    archive.numbers(name + "/change", sums.change);
    archive.numbers(name + "/at_last_row", sums.at_last_row);
    for (std::size_t k = 0; k < 3; ++k) archive.numbers(fmt::format("{}/axis{}", name, k), sums.axes[k]);
  }
}

void Accelerometers::resume(const State& state) {
  for (Sums& sums : sums_)
    if (sums.is_new) sums.last_row = find_velocity_time(state);
}

std::vector<HistoryColumn> Accelerometers::list_columns() const {
  std::vector<HistoryColumn> columns;
  for (const AccelerometerDeck& one : deck_.output.accelerometers) {
    for (const char axis : {'x', 'y', 'z'})
      columns.push_back({fmt::format("local_a{}:{}", axis, one.name), acceleration,
                         fmt::format("acceleration along {} of accelerometer '{}', in its moving axes, mean since the "
                                     "row before",
                                     axis, one.name)});
    for (const char axis : {'x', 'y', 'z'})
      columns.push_back({fmt::format("local_dv{}:{}", axis, one.name), dimensions::velocity,
                         fmt::format("velocity change along {} of accelerometer '{}', in its moving axes, since the "
                                     "start",
                                     axis, one.name)});
  }
  return columns;
}

void Accelerometers::append_values(const State& state, std::vector<double>& row) {
  const double time = find_velocity_time(state);
  for (Sums& sums : sums_) {
    const double interval = time - sums.last_row;
    for (std::size_t k = 0; k < 3; ++k)
      row.push_back(interval > 0 ? (sums.change[k] - sums.at_last_row[k]) / interval : 0);
    row.insert(row.end(), sums.change.begin(), sums.change.end());
    sums.at_last_row = sums.change;
    sums.last_row = time;
  }
}

}  // namespace percuss
