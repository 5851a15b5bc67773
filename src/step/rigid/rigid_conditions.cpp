// Conditions of rigid bodies, and how they move at time 0.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/rigid/build_rigid.hpp"
#include "src/step/rigid/inertia.hpp"

namespace percuss {
namespace {

/// Holds a direction of a body. Rest is rest, whoever requests it. switched_by: condition that sensors switch, or free.
void hold(RigidBody& body, int direction, int motion, const std::string& place, int switched_by = RigidBody::free) {
  int& held = body.motion[at(direction)];
  const bool is_switched = switched_by != RigidBody::free || body.switched_by[at(direction)] != RigidBody::free;
  if (held == RigidBody::free || (held == 0 && motion == 0 && !is_switched)) {
    held = motion;
    body.switched_by[at(direction)] = switched_by;
    return;
  }
  throw InputError(
      fmt::format("{}: error: rigid body '{}' has two conditions on direction {} (they prescribe different motions, or "
                  "a sensor switches one): "
                  "leave it out of one of them",
                  place, body.name, direction_names[at(direction)]));
}

/// [bodies] nodes of each that a condition selects, on all ranks.
std::vector<std::int64_t> count_selected(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map,
                                         const ConditionDeck& condition, const Model& model) {
  std::vector<std::int64_t> counts(model.rigid.bodies.size(), 0);
  for (const int n : select_nodes(chunked.mesh, deck, condition.where))
    if (map.body[at(n)] >= 0 && owns_node(chunked, n)) ++counts[at(map.body[at(n)])];
  all_reduce(model.ranks, Reduce::sum, counts);
  return counts;
}

void refuse_some_nodes(const Deck& deck, const ConditionDeck& condition, const RigidBody& body, std::int64_t count) {
  if (count == body.nodes || condition.kind == ConditionDeck::Kind::symmetry) return;
  throw InputError(
      fmt::format("{}: error: the condition names {} of the {} nodes of rigid body '{}' (a condition must apply to the "
                  "whole body): name its parts, or use rigid.fixed",
                  deck.where(condition.where.place), count, body.nodes, body.name));
}

/// All nodes move alike in a direction only if the body does not turn about the two others.
void hold_turns_about_others(RigidBody& body, int direction) {
  for (int k = 0; k < 3; ++k) {
    int& held = body.motion[at(3 + k)];
    if (k != direction && held == RigidBody::free) held = 0;
  }
}

}  // namespace

void hold_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map,
                       const std::vector<HeldByCondition>& held, Model& model) {
  if (!has_rigid_bodies(deck)) return;
  std::vector<RigidBody>& bodies = model.rigid.bodies;
  const RigidNames names = name_rigid_bodies(deck);
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    if (names.body_of_part[p] < 0) continue;
    const RigidDeck& rigid = *deck.parts[p].rigid;
    for (int k = 0; k < 6; ++k)
      if (rigid.fixed[at(k)]) hold(bodies[at(names.body_of_part[p])], k, 0, deck.where(rigid.place));
  }
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s)
    for (int k = 0; k < 6; ++k)
      if (deck.rigid_sets[s].fixed[at(k)])
        hold(bodies[at(names.body_of_set[s])], k, 0, deck.where(deck.rigid_sets[s].place));
  std::vector<std::int64_t> counts;
  std::size_t counted = deck.conditions.size();
  for (const HeldByCondition& motion : held) {
    const ConditionDeck& condition = deck.conditions[motion.condition];
    if (counted != motion.condition) counts = count_selected(deck, chunked, map, condition, model);
    counted = motion.condition;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (counts[b] == 0) continue;
      refuse_some_nodes(deck, condition, bodies[b], counts[b]);
      hold(bodies[b], motion.direction, motion.motion, deck.where(condition.where.place),
           condition.when.any() ? static_cast<int>(motion.condition) : RigidBody::free);
    }
  }
  for (const HeldByCondition& motion : held) {
    if (motion.direction > 2 || !find_body(deck.conditions[motion.condition].where).empty()) continue;
    counts = count_selected(deck, chunked, map, deck.conditions[motion.condition], model);
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (counts[b] > 0) hold_turns_about_others(bodies[b], motion.direction);
  }
}

// --- time 0

namespace {

/// Velocity of a body's centre of `center`, and its spin.
struct RigidVelocity {
  Vector3<double> center{}, velocity{}, spin{};
  bool is_known = false;
};

/// Motion of a body from the velocities of nodes, by their momentum. may_be_line: nodes on a line do not spin about it.
/// Collective.
template <class Velocities>
RigidVelocity find_velocity(const ChunkedMesh& chunked, const Model& model, const std::vector<int>& nodes,
                            const std::vector<double>& mass, const Velocities& v, bool may_be_line) {
  const auto place = [&](int n) { return to_vector(chunked.mesh.nodes[at(n)]); };
  std::array<ExactSum, 7> linear{};
  for (const int n : nodes) {
    const double m = mass[at(n)],
                 values[7] = {m, m * place(n).x, m * place(n).y, m * place(n).z, m * v(n, 0), m * v(n, 1), m * v(n, 2)};
    for (std::size_t k = 0; k < 7; ++k) linear[k].add(values[k]);
  }
  sum_over_ranks(model.ranks, linear);
  const double total = linear[0].round();
  RigidVelocity found;
  if (!(total > 0)) return found;
  found.center = (1 / total) * Vector3<double>{linear[1].round(), linear[2].round(), linear[3].round()};
  found.velocity = (1 / total) * Vector3<double>{linear[4].round(), linear[5].round(), linear[6].round()};
  std::array<ExactSum, 9> angular{};
  for (const int n : nodes) {
    const double m = mass[at(n)];
    const Vector3<double> r = place(n) - found.center;
    const Vector3<double> l = cross(r, m * (Vector3<double>{v(n, 0), v(n, 1), v(n, 2)} - found.velocity));
    const double values[9] = {m * (r.y * r.y + r.z * r.z),
                              m * (r.z * r.z + r.x * r.x),
                              m * (r.x * r.x + r.y * r.y),
                              -m * r.x * r.y,
                              -m * r.y * r.z,
                              -m * r.z * r.x,
                              l.x,
                              l.y,
                              l.z};
    for (std::size_t k = 0; k < 9; ++k) angular[k].add(values[k]);
  }
  sum_over_ranks(model.ranks, angular);
  double a[9];
  for (std::size_t k = 0; k < 9; ++k) a[k] = angular[k].round();
  Symmetric3<double> inertia{a[0], a[1], a[2], a[3], a[4], a[5]};
  if (may_be_line) inertia = to_inertia_of_line(to_second_moments({a[0], a[1], a[2], a[3], a[4], a[5]}));
  const double size = trace(inertia) / 3;
  found.is_known = size > 0 && find_adjugate(inertia).determinant > 1e-9 * size * size * size;
  if (found.is_known && (a[6] != 0 || a[7] != 0 || a[8] != 0))
    found.spin = solve(inertia, Vector3<double>{a[6], a[7], a[8]});
  return found;
}

/// Whether all nodes have the very same velocity; then that. Collective.
template <class Velocities>
bool move_alike(const Model& model, const std::vector<int>& nodes, const Velocities& v, Vector3<double>& alike) {
  constexpr double most = std::numeric_limits<double>::infinity();
  double least[3] = {most, most, most}, largest[3] = {-most, -most, -most};
  for (const int n : nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], v(n, k));
      largest[k] = std::max(largest[k], v(n, k));
    }
  }
  all_reduce(model.ranks, Reduce::least, least);
  all_reduce(model.ranks, Reduce::largest, largest);
  alike = {least[0], least[1], least[2]};
  return std::equal(least, least + 3, largest);
}

/// How a body moves at the start, and the nodes that say it.
struct RigidStart {
  RigidVelocity moves;
  std::vector<int> nodes;
};

/// Start of a body: by nodes that only rigid elements have, unless these alone do not say how it turns.
template <class Velocities>
RigidStart find_start(const ChunkedMesh& chunked, const RigidMap& map, int body, const std::vector<double>& mass,
                      const Model& model, const Velocities& v) {
  std::vector<int> all, used;
  for (std::size_t n = 0; n < map.body.size(); ++n) {
    if (map.body[n] != body || !owns_node(chunked, static_cast<int>(n))) continue;
    all.push_back(static_cast<int>(n));
    if (map.is_shared[n] == 0) used.push_back(static_cast<int>(n));
  }
  const RigidVelocity found = find_velocity(chunked, model, used, mass, v, false);
  if (found.is_known) return {found, used};
  return {find_velocity(chunked, model, all, mass, v, model.rigid.bodies[at(body)].parts == 0), all};
}

/// Largest deviation of nodes from a rigid motion, and their largest velocity; of all ranks.
template <class Velocities>
std::array<double, 2> compare(const ChunkedMesh& chunked, const Model& model, const std::vector<int>& nodes,
                              const RigidVelocity& rigid, const Velocities& v) {
  std::array<double, 2> largest{0, 0};
  for (const int n : nodes) {
    const Vec3& x = chunked.mesh.nodes[at(n)];
    const Vector3<double> given{v(n, 0), v(n, 1), v(n, 2)};
    const Vector3<double> r = Vector3<double>{x[0], x[1], x[2]} - rigid.center;
    largest[0] = std::max(largest[0], norm(given - (rigid.velocity + cross(rigid.spin, r))));
    largest[1] = std::max(largest[1], norm(given));
  }
  all_reduce(model.ranks, Reduce::largest, largest);
  return largest;
}

}  // namespace

namespace {

/// The last entry of the deck that gives the velocity of a body, which counts more than those of its nodes.
const InitialDeck* find_given_start(const Deck& deck, const RigidBody& body) {
  const auto found = std::find_if(deck.initial.rbegin(), deck.initial.rend(),
                                  [&](const InitialDeck& initial) { return find_body(initial.where) == body.name; });
  return found == deck.initial.rend() ? nullptr : &*found;
}

/// Nodes of shells and beams say by their spins how they turn, also about the line on which all nodes may lie. Whether
/// these are alike, not zero, and those of the velocities; then start has them. Collective.
template <class Velocities>
bool take_nodal_spin(const ChunkedMesh& chunked, const Model& model, const std::vector<int>& nodes, const Velocities& v,
                     RigidVelocity& start) {
  constexpr double round_off = 1e-9;
  if (!model.has_rotations) return false;
  Vector3<double> alike{};
  if (!move_alike(model, nodes, to_host(model.start_spin), alike) || norm(alike) == 0) return false;
  RigidVelocity turned = start;
  turned.spin = alike;
  const auto [deviation, size] = compare(chunked, model, nodes, turned, v);
  if (deviation > round_off * size) return false;
  start = turned;
  return true;
}

/// Sets the velocity and the spin of a body as its nodes move. Collective; throws InputError.
template <class Velocities>
void start_by_nodes(const Deck& deck, const ChunkedMesh& chunked, const RigidStart& by, int index, const Velocities& v,
                    Model& model) {
  constexpr double round_off = 1e-9;
  RigidBody& body = model.rigid.bodies[at(index)];
  auto [start, used] = by;
  const bool follows_spins = take_nodal_spin(chunked, model, used, v, start);
  const auto [deviation, size] = compare(chunked, model, used, start, v);
  if (deviation > round_off * size) {
    const Place place = find_body_place(deck, name_rigid_bodies(deck), index);
    throw InputError(
        fmt::format("{}: error: the initial velocities of rigid body '{}' are not a rigid motion (nodes deviate by "
                    "{:.3g} of {:.3g}): give all its nodes the same entry of initial, or an entry with its body",
                    deck.where(place), body.name, deviation, size));
  }
  if (!follows_spins && move_alike(model, used, v, body.velocity)) return;
  body.spin = start.spin;
  body.velocity = start.velocity + cross(start.spin, body.center - start.center);
}

}  // namespace

void start_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map,
                        const std::vector<double>& mass, Model& model) {
  if (!has_rigid_bodies(deck)) return;
  const auto v = to_host(model.start_velocity);
  const auto w = to_host(model.start_spin);
  for (std::size_t b = 0; b < model.rigid.bodies.size(); ++b) {
    RigidBody& body = model.rigid.bodies[b];
    if (const InitialDeck* given = find_given_start(deck, body)) {
      body.velocity = to_vector(given->velocity);
      body.spin = to_vector(given->angular_velocity);
    } else {
      const int index = static_cast<int>(b);
      start_by_nodes(deck, chunked, find_start(chunked, map, index, mass, model, v), index, v, model);
    }
  }
  for (std::size_t n = 0; n < map.body.size(); ++n) {
    if (map.body[n] < 0) continue;
    const RigidBody& body = model.rigid.bodies[at(map.body[n])];
    const Vec3& x = chunked.mesh.nodes[n];
    const Vector3<double> moved = body.velocity + cross(body.spin, Vector3<double>{x[0], x[1], x[2]} - body.center);
    for (std::size_t k = 0; k < 3; ++k) {
      v(n, k) = get(moved, static_cast<int>(k));
      if (model.has_rotations) w(n, k) = get(body.spin, static_cast<int>(k));
    }
  }
  copy_values(model.start_velocity, v);
  if (model.has_rotations) copy_values(model.start_spin, w);
}

}  // namespace percuss
