#include "src/step/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/step/element_fields.hpp"

namespace percuss {

namespace {

Vec3 find_center(const Mesh& mesh, const std::array<int, 8>& corners) {
  Vec3 center{};
  for (const int n : corners) {
    for (std::size_t k = 0; k < 3; ++k) center[k] += mesh.nodes[static_cast<std::size_t>(n)][k] / 8;
  }
  return center;
}

double find_square_distance(const Vec3& a, const Vec3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// Whether an element belongs to the point's part; every element if it names none.
std::vector<bool> find_searched_elements(const Mesh& mesh, const Deck& deck, const HistoryPoint& point) {
  std::vector<bool> searched(mesh.elements.size(), point.part.empty());
  if (point.part.empty()) return searched;
  const auto part =
      std::find_if(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& p) { return p.name == point.part; });
  if (part == mesh.parts.end()) {
    throw InputError(fmt::format("{}: error: no part is called '{}' (history point '{}')", deck.where(point.place),
                                 point.part, point.name));
  }
  for (std::size_t e = 0; e < searched.size(); ++e) searched[e] = mesh.element_part[e] == part - mesh.parts.begin();
  return searched;
}

/// Index of the item (of those searched) with the least score, -1 if none is searched.
template <class Score>
int find_least(const std::vector<bool>& searched, const Score& score) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < searched.size(); ++i) {
    if (!searched[i]) continue;
    const double s = score(i);
    if (s < least) {
      least = s;
      best = static_cast<int>(i);
    }
  }
  return best;
}

int find_point(const Mesh& mesh, const Deck& deck, const HistoryPoint& point) {
  const std::vector<bool> elements = find_searched_elements(mesh, deck, point);
  std::vector<bool> nodes(mesh.nodes.size(), false);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (!elements[e]) continue;
    for (const int n : mesh.elements[e]) nodes[static_cast<std::size_t>(n)] = true;
  }
  const auto score = [&](std::size_t i) {
    if (point.near) {
      return find_square_distance(*point.near, point.is_element ? find_center(mesh, mesh.elements[i]) : mesh.nodes[i]);
    }
    const auto id = point.is_element ? mesh.element_ids[i] : mesh.node_ids[i];
    return id == *point.id ? 0.0 : std::numeric_limits<double>::infinity();
  };
  const int found = find_least(point.is_element ? elements : nodes, score);
  if (found < 0) {
    throw InputError(fmt::format("{}: error: no {} has the id {} (history point '{}')", deck.where(point.place),
                                 point.is_element ? "element" : "node", point.id.value_or(0), point.name));
  }
  return found;
}

std::vector<std::string> make_columns(const std::vector<FollowedPoint>& points, bool has_walls) {
  std::vector<std::string> columns{"time",       "step",       "dt",         "dt_element", "kinetic",   "internal",
                                   "hourglass",  "viscous",    "contact",    "friction",   "external",  "energy_error",
                                   "momentum_x", "momentum_y", "momentum_z", "angular_x",  "angular_y", "angular_z",
                                   "contacts",   "candidates", "iterations", "residual"};
  if (has_walls) columns.insert(columns.end(), {"wall_force_x", "wall_force_y", "wall_force_z"});
  for (const FollowedPoint& p : points) {
    const std::vector<const char*> suffixes =
        p.is_element ? std::vector<const char*>{"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz",
                                                "stress_zx", "pressure",  "von_mises", "eps"}
                     : std::vector<const char*>{"x", "y", "z", "vx", "vy", "vz"};
    for (const char* suffix : suffixes) columns.push_back(p.name + "_" + suffix);
  }
  return columns;
}

}  // namespace

std::vector<FollowedPoint> find_history_points(const Deck& deck, const Mesh& mesh) {
  std::vector<FollowedPoint> points;
  for (const HistoryPoint& p : deck.output.points) points.push_back({p.name, p.is_element, find_point(mesh, deck, p)});
  return points;
}

History::History(const std::string& directory, const Deck& deck, const Mesh& mesh)
    : mesh_(mesh),
      has_walls_(!deck.walls.empty()),
      points_(find_history_points(deck, mesh)),
      file_(directory + "/history.csv", make_columns(points_, has_walls_)) {}

void History::write(const Model& model, const State& state, const AuditResult& audit, const ContactReport& contact,
                    const Vec3& wall_force) {
  const EnergySummary& e = audit.energy;
  const MomentumSummary& m = audit.momentum;
  const auto controlling = static_cast<double>(mesh_.element_ids[static_cast<std::size_t>(state.bound.element)]);
  std::vector<double> row{state.time,
                          static_cast<double>(state.step),
                          state.dt,
                          controlling,
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
  if (has_walls_) row.insert(row.end(), wall_force.begin(), wall_force.end());
  std::vector<double> stresses, strains, pressures, von_mises;
  if (std::any_of(points_.begin(), points_.end(), [](const FollowedPoint& p) { return p.is_element; })) {
    stresses = find_stresses(model, state);
    strains = find_plastic_strains(model, state);
    pressures = find_pressures(stresses);
    von_mises = find_von_mises(stresses);
  }
  const auto x = to_host(state.x);
  const auto v = to_host(state.v);
  for (const FollowedPoint& p : points_) {
    const auto i = static_cast<std::size_t>(p.index);
    if (p.is_element) {
      row.insert(row.end(), &stresses[6 * i], &stresses[6 * i] + 6);
      row.insert(row.end(), {pressures[i], von_mises[i], strains[i]});
    } else {
      row.insert(row.end(), {x(i, 0), x(i, 1), x(i, 2), v(i, 0), v(i, 1), v(i, 2)});
    }
  }
  file_.write_row(row);
}

}  // namespace percuss
