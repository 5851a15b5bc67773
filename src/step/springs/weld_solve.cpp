#include "src/step/springs/weld_solve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/index.hpp"
#include "src/step/joints/least_norm.hpp"

namespace percuss {
namespace {

/// Below this share of the coordinates two places are one.
constexpr double same_place = 1e-12;
/// Below this share of what a node answers across, two nodes without rotations cannot follow along the weld.
constexpr double stiff_axis = 1e-6;

/// Levers of the impulse from each node: from the middle where both turn, else from the node that does not.
std::array<Vector3<double>, 2> find_levers(const std::array<WeldNode, 2>& nodes, const Vector3<double>& across) {
  if (nodes[0].turns && nodes[1].turns) return {0.5 * across, -0.5 * across};
  if (nodes[0].turns) return {across, Vector3<double>{0, 0, 0}};
  if (nodes[1].turns) return {Vector3<double>{0, 0, 0}, -1.0 * across};
  return {Vector3<double>{0, 0, 0}, Vector3<double>{0, 0, 0}};
}

Vector3<double> multiply_each(const Vector3<double>& a, const Vector3<double>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

using Change = PatchResponse::Column;

/// Change of a node by an impulse and a moment at itself; for a patch, at its centre.
Change respond(const WeldNode& node, const Vector3<double>& p, const Vector3<double>& moment) {
  if (!node.is_patch)
    return {multiply_each(node.inverse_mass, p),
            node.turns ? multiply_each(node.inverse_inertia, moment) : Vector3<double>{0, 0, 0}};
  const auto& column = node.response.column;
  const double by[6] = {p.x, p.y, p.z, moment.x, moment.y, moment.z};
  Change change;
  for (std::size_t k = 0; k < 6; ++k) {
    change.velocity = change.velocity + by[k] * column[k].velocity;
    change.spin = change.spin + by[k] * column[k].spin;
  }
  return change;
}

/// Change by an impulse at the common point and a moment, of the velocity of that point and of the spin of a node.
Change respond_at(const WeldNode& node, const Vector3<double>& lever, const Vector3<double>& p,
                  const Vector3<double>& q) {
  Change change = respond(node, p, q + cross(lever, p));
  change.velocity = change.velocity + cross(change.spin, lever);
  return change;
}

Vector3<double> unit_vector(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

double pick(const Vector3<double>& a, int k) { return k == 0 ? a.x : k == 1 ? a.y : a.z; }

/// Answers of the common point, and of the relative spin where both nodes turn, to unit impulses and moments. An axis
/// along which neither node moves is left to what holds them: a spin could only bring the points together there by an
/// impulse as large as the lever is short.
std::vector<double> fill_matrix(const std::array<WeldNode, 2>& nodes, const std::array<Vector3<double>, 2>& lever,
                                int size) {
  std::vector<double> matrix(at(size * size));
  const Vector3<double> inverse = nodes[0].inverse_mass + nodes[1].inverse_mass;
  const auto is_left_out = [&](int k) { return k < 3 && pick(inverse, k) == 0; };
  for (int column = 0; column < size; ++column) {
    if (is_left_out(column)) continue;
    const Vector3<double> p = column < 3 ? unit_vector(column) : Vector3<double>{0, 0, 0},
                          q = column < 3 ? Vector3<double>{0, 0, 0} : unit_vector(column - 3);
    const Change a = respond_at(nodes[0], lever[0], p, q), b = respond_at(nodes[1], lever[1], p, q);
    const Vector3<double> velocity = a.velocity + b.velocity, spin = a.spin + b.spin;
    for (int row = 0; row < size; ++row) {
      if (!is_left_out(row)) matrix[at(row * size + column)] = row < 3 ? pick(velocity, row) : pick(spin, row - 3);
    }
  }
  return matrix;
}

/// Two nodes without rotations keep their distance, or their place where they have one.
WeldImpulse keep_distance(const std::array<WeldNode, 2>& nodes, const Vector3<double>& across, double approach) {
  const Vector3<double> axis = (1 / norm(across)) * across;
  const Vector3<double> inverse = nodes[0].inverse_mass + nodes[1].inverse_mass;
  const double response = dot(multiply_each(inverse, axis), axis);
  if (!(response > stiff_axis * std::max({inverse.x, inverse.y, inverse.z}))) return {};
  const double parting = dot(nodes[1].velocity - nodes[0].velocity, axis);
  return {((approach - parting) / response) * axis, {}};
}

void add(const WeldImpulse& impulse, std::array<WeldNode, 2>& nodes) {
  for (std::size_t i = 0; i < 2; ++i) {
    WeldNode& node = nodes[i];
    const Change change = respond(node, (i == 0 ? -1.0 : 1.0) * impulse.impulse, impulse.moment[i]);
    node.velocity = node.velocity + change.velocity;
    node.spin = node.spin + change.spin;
  }
}

/// Impulse of a weld between bodies whose points do not coincide.
WeldImpulse join_bodies(const std::array<WeldNode, 2>& nodes, const Vector3<double>& across,
                        const Vector3<double>& correction) {
  std::array<Vector3<double>, 2> lever = find_levers(nodes, across);
  for (std::size_t i = 0; i < 2; ++i)
    if (nodes[i].is_patch) lever[i] = lever[i] + nodes[i].arm;
  const bool both = nodes[0].turns && nodes[1].turns;
  const int size = both ? 6 : 3;
  const auto point = [&](std::size_t i) {
    return nodes[i].turns ? nodes[i].velocity + cross(nodes[i].spin, lever[i]) : nodes[i].velocity;
  };
  const Vector3<double> parting = point(1) - point(0) - correction, turning = nodes[1].spin - nodes[0].spin;
  std::vector<double> wanted{-parting.x, -parting.y, -parting.z};
  if (both) wanted.insert(wanted.end(), {-turning.x, -turning.y, -turning.z});
  LeastNormSolver solver;
  solver.factorise(fill_matrix(nodes, lever, size), size);
  const std::vector<double> found = solver.solve(wanted);
  const Vector3<double> p{found[0], found[1], found[2]};
  const Vector3<double> q = both ? Vector3<double>{found[3], found[4], found[5]} : Vector3<double>{0, 0, 0};
  const Vector3<double> zero{0, 0, 0};
  return {p, {nodes[0].turns ? -1.0 * (q + cross(lever[0], p)) : zero, nodes[1].turns ? q + cross(lever[1], p) : zero}};
}

/// Twice the energy of a velocity in directions that are not held.
double find_energy(const Vector3<double>& velocity, const Vector3<double>& inverse_mass) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double v = pick(velocity, k), inverse = pick(inverse_mass, k);
    if (inverse > 0) sum += v * v / inverse;
  }
  return sum;
}

}  // namespace

double find_impulse_size(const WeldImpulse& impulse, const std::array<WeldNode, 2>& nodes) {
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3<double> p = (i == 0 ? -1.0 : 1.0) * impulse.impulse;
    const Change change = respond(nodes[i], p, impulse.moment[i]);
    sum += dot(change.velocity, p) + dot(change.spin, impulse.moment[i]);
  }
  return std::sqrt(sum);
}

double find_motion_size(const std::array<WeldNode, 2>& nodes) {
  double sum = 0;
  for (const WeldNode& node : nodes) {
    sum += node.is_patch ? node.twice_energy : find_energy(node.velocity, node.inverse_mass);
    if (node.turns && !node.is_patch) sum += find_energy(node.spin, node.inverse_inertia);
  }
  return std::sqrt(sum);
}

WeldImpulse join_nodes(std::array<WeldNode, 2>& nodes, double length, double dt) {
  const Vector3<double> across = nodes[1].place - nodes[0].place;
  const double now = norm(across);
  const double size = std::max(norm(nodes[0].place), norm(nodes[1].place));
  const bool is_long = now > same_place * size && length > 0;
  // Speed that brings the length back. A node moves within its patch, which cannot follow it.
  const double growth = is_long && dt > 0 && !nodes[0].is_patch ? (length - now) / dt : 0;
  const bool turns = nodes[0].turns || nodes[1].turns;
  WeldImpulse impulse;
  if (!turns && is_long)
    impulse = keep_distance(nodes, across, growth);
  else
    impulse = join_bodies(nodes, across, is_long ? (growth / now) * across : Vector3<double>{0, 0, 0});
  add(impulse, nodes);
  return impulse;
}

}  // namespace percuss
