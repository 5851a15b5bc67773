#include "src/step/rigid/build_rigid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/rigid/inertia.hpp"

namespace percuss {
namespace {

/// Place of the first part or set of a body.
std::string find_place(const Deck& deck, const RigidNames& names, int body) {
  return deck.where(find_body_place(deck, names, body));
}

/// Mass, centre and second moments of mass about the centre.
struct MassSum {
  double mass = 0;
  Vector3<double> center{};
  Symmetric3<double> second{};
};

/// Of the nodes of a body that this rank owns, with weights that the caller chooses. Collective.
template <class Weight>
MassSum sum_masses(const ChunkedMesh& chunked, const Model& model, const std::vector<int>& nodes,
                   const Weight& weight) {
  std::array<ExactSum, 4> first{};
  for (const int n : nodes) {
    const double m = weight(n);
    first[3].add(m);
    for (std::size_t k = 0; k < 3; ++k) first[k].add(m * chunked.mesh.nodes[at(n)][k]);
  }
  sum_over_ranks(model.ranks, first);
  MassSum sum;
  sum.mass = first[3].round();
  if (!(sum.mass > 0)) return sum;
  sum.center = (1 / sum.mass) * Vector3<double>{first[0].round(), first[1].round(), first[2].round()};
  std::array<ExactSum, 6> second{};
  for (const int n : nodes) {
    const double m = weight(n);
    const Vector3<double> r = to_vector(chunked.mesh.nodes[at(n)]) - sum.center;
    const double values[6] = {r.x * r.x, r.y * r.y, r.z * r.z, r.x * r.y, r.y * r.z, r.z * r.x};
    for (std::size_t k = 0; k < 6; ++k) second[k].add(m * values[k]);
  }
  sum_over_ranks(model.ranks, second);
  double s[6];
  for (std::size_t k = 0; k < 6; ++k) s[k] = second[k].round();
  sum.second = {s[0], s[1], s[2], s[3], s[4], s[5]};
  return sum;
}

/// Both together; inertia without mass counts as it is.
MassSum combine(const MassSum& a, const MassSum& b) {
  if (!(b.mass > 0)) return {a.mass, a.center, a.second + b.second};
  MassSum sum{a.mass + b.mass, {}, a.second + b.second};
  sum.center = (1 / sum.mass) * (a.mass * a.center + b.mass * b.center);
  for (const MassSum* of : {&a, &b}) {
    const Vector3<double> r = of->center - sum.center;
    sum.second =
        sum.second + of->mass * Symmetric3<double>{r.x * r.x, r.y * r.y, r.z * r.z, r.x * r.y, r.y * r.z, r.z * r.x};
  }
  return sum;
}

/// A body, the nodes of it that this rank owns, and the lumped masses of all nodes.
struct SetMasses {
  int body = 0;
  const std::vector<int>& owned;
  const std::vector<double>& mass;
};

/// Second moments that make up the rotary inertia of the nodes of sets, of shells and beams: the same about any axis.
Symmetric3<double> sum_rotary(const RigidMap& map, const SetMasses& of, const Model& model) {
  if (!model.has_rotations) return {};
  const auto inertia = to_host(model.inertia);
  std::array<ExactSum, 1> sum{};
  for (const int n : of.owned)
    if (map.is_in_set[at(n)] != 0 && map.counts[at(n)] != 0) sum[0].add(inertia(n));
  sum_over_ranks(model.ranks, sum);
  const double half = 0.5 * sum[0].round();
  return {half, half, half, 0, 0, 0};
}

/// What the sets of a body add to the masses of its nodes. Collective.
MassSum sum_of_sets(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map, const SetMasses& of,
                    const Model& model) {
  MassSum added;
  const RigidNames names = name_rigid_bodies(deck);
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s) {
    const RigidSetDeck& set = deck.rigid_sets[s];
    if (names.body_of_set[s] != of.body || (set.mass == 0 && !set.inertia)) continue;
    MassSum more;
    more.mass = set.mass;
    if (set.inertia) more.second = to_second_moments(*set.inertia);
    if (set.center) {
      more.center = to_vector(*set.center);
    } else {
      std::vector<int> nodes;
      for (const int n : select_nodes(chunked.mesh, deck, set.where))
        if (owns_node(chunked, n)) nodes.push_back(n);
      more.center = sum_masses(chunked, model, nodes, [&](int n) { return of.mass[at(n)]; }).center;
    }
    added = combine(added, more);
  }
  added.second = added.second + sum_rotary(map, of, model);
  return added;
}

/// What the parts of a body give instead of their elements' masses.
struct GivenMasses {
  std::optional<double> mass;
  std::optional<Vec3> center;
  std::optional<std::array<double, 6>> inertia;
  bool any() const { return mass || center || inertia; }
};

GivenMasses find_given(const Deck& deck, const RigidNames& names, int body) {
  GivenMasses given;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    if (names.body_of_part[p] != body) continue;
    const RigidDeck& rigid = *deck.parts[p].rigid;
    if (rigid.mass) given.mass = rigid.mass;
    if (rigid.center) given.center = rigid.center;
    if (rigid.inertia) given.inertia = rigid.inertia;
  }
  return given;
}

void apply(const GivenMasses& given, MassSum& sum) {
  if (given.mass) {
    sum.second = (*given.mass / sum.mass) * sum.second;
    sum.mass = *given.mass;
  }
  if (given.center) sum.center = to_vector(*given.center);
  if (given.inertia) sum.second = to_second_moments(*given.inertia);
}

bool adds_rigid_masses(const Deck& deck) {
  return std::any_of(deck.rigid_sets.begin(), deck.rigid_sets.end(),
                     [](const auto& set) { return set.mass > 0 || !set.counts_nodes; });
}

/// Whether a body has inertia about every axis, but for round-off.
bool has_inertia(const Symmetric3<double>& i) {
  constexpr double round_off = 1e-12;
  const double size = trace(i) / 3;
  return size > 0 && find_adjugate(i).determinant > round_off * size * size * size;
}

/// Nodes of this rank's share by body; owned ones alone.
std::vector<std::vector<int>> list_owned_nodes(const ChunkedMesh& chunked, const RigidMap& map, std::size_t bodies) {
  std::vector<std::vector<int>> nodes(bodies);
  for (std::size_t n = 0; n < map.body.size(); ++n)
    if (map.body[n] >= 0 && owns_node(chunked, static_cast<int>(n)))
      nodes[at(map.body[n])].push_back(static_cast<int>(n));
  return nodes;
}

// --- what acts on bodies

/// Owned nodes with a slot that is not of a rigid chunk of this rank.
RigidLoads list_loads(const ChunkedMesh& chunked, const Deck& deck, const std::vector<std::vector<int>>& owned,
                      const Model& model) {
  std::vector<char> is_idle(at(model.slot_count), 0);
  const auto first_slot = to_host(model.chunks.first_slot);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c)
    for (int s = first_slot(c); s < first_slot(c + 1); ++s)
      is_idle[at(s)] = deck.parts[at(chunked.chunks[c].part)].rigid ? 1 : 0;
  const auto first = to_host(model.nodes_to_slots.first), slots = to_host(model.nodes_to_slots.slots);
  RigidLoads loads;
  std::vector<int> nodes;
  loads.first.push_back(0);
  for (const std::vector<int>& of_body : owned) {
    for (const int n : of_body) {
      bool acts = false;
      for (int i = first(n); i < first(n + 1); ++i) acts = acts || is_idle[at(slots(i))] == 0;
      if (acts) nodes.push_back(n);
    }
    loads.first.push_back(static_cast<int>(nodes.size()));
  }
  loads.node = to_view("percuss::rigid_load_nodes", nodes);
  return loads;
}

/// Loads of the deck on points of bodies.
void add_body_loads(const Deck& deck, const RigidNames& names, std::vector<RigidBody>& bodies) {
  for (std::size_t i = 0; i < deck.nodal_loads.size(); ++i) {
    const NodalLoadDeck& load = deck.nodal_loads[i];
    const std::string name = find_body(load.where);
    if (name.empty()) continue;
    RigidBody& body = bodies[at(names.find(name))];
    body.loads.push_back({i, load.at ? to_vector(*load.at) - body.center : Vector3<double>{0, 0, 0}});
  }
}

double find_least_edge(const Deck& deck, const ChunkedMesh& chunked, const Model& model) {
  const Mesh& mesh = chunked.mesh;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!deck.parts[at(mesh.part_of(e))].rigid) continue;
    const auto corners = mesh.corners(e);
    for (const auto& [a, b] : mesh.topology_of(e).edges())
      least =
          std::min(least, norm(to_vector(mesh.nodes[at(corners[at(a)])]) - to_vector(mesh.nodes[at(corners[at(b)])])));
  }
  all_reduce(model.ranks, Reduce::least, least);
  return least;
}

/// Counts and extent of a body.
void measure(const ChunkedMesh& chunked, const RigidMap& map, const std::vector<int>& owned, const Model& model,
             RigidBody& body) {
  std::int64_t counts[2] = {static_cast<std::int64_t>(owned.size()), 0};
  for (const int n : owned) {
    counts[1] += map.is_shared[at(n)];
    body.radius = std::max(body.radius, norm(to_vector(chunked.mesh.nodes[at(n)]) - body.center));
  }
  all_reduce(model.ranks, Reduce::sum, counts);
  all_reduce(model.ranks, Reduce::largest, body.radius);
  body.nodes = counts[0];
  body.shared_nodes = counts[1];
}

RigidNodes list_nodes(const ChunkedMesh& chunked, const RigidMap& map, const std::vector<RigidBody>& bodies) {
  std::vector<int> node, body;
  std::vector<Vec3> arm;
  for (std::size_t n = 0; n < map.body.size(); ++n) {
    if (map.body[n] < 0) continue;
    node.push_back(static_cast<int>(n));
    body.push_back(map.body[n]);
    const Vector3<double> r = to_vector(chunked.mesh.nodes[n]) - bodies[at(map.body[n])].center;
    arm.push_back({r.x, r.y, r.z});
  }
  return {static_cast<int>(node.size()), to_view("percuss::rigid_nodes", node), to_view("percuss::rigid_body", body),
          to_rows("percuss::rigid_arm", arm)};
}

/// Total mass and mass centre, which given masses change.
void find_total(const ChunkedMesh& chunked, const RigidMap& map, const std::vector<double>& mass, Model& model) {
  std::vector<int> loose;
  for (std::size_t n = 0; n < mass.size(); ++n)
    if (map.body[n] < 0 && owns_node(chunked, static_cast<int>(n))) loose.push_back(static_cast<int>(n));
  MassSum total = sum_masses(chunked, model, loose, [&](int n) { return mass[at(n)]; });
  for (const RigidBody& body : model.rigid.bodies) total = combine({body.mass, body.center, {}}, total);
  model.total_mass = total.mass;
  model.mass_center = {total.center.x, total.center.y, total.center.z};
}

/// Mass of a body with that of others on its nodes, which given values do not include. owned: nodes that count.
MassSum sum_of_body(const ChunkedMesh& chunked, const Model& model, const GivenMasses& given, const RigidMasses& masses,
                    const std::vector<int>& owned) {
  if (!given.any()) return sum_masses(chunked, model, owned, [&](int n) { return masses.all[at(n)]; });
  MassSum sum = sum_masses(chunked, model, owned, [&](int n) { return masses.all[at(n)] - masses.of_others[at(n)]; });
  apply(given, sum);
  return combine(sum, sum_masses(chunked, model, owned, [&](int n) { return masses.of_others[at(n)]; }));
}

std::vector<int> list_counted(const RigidMap& map, const std::vector<int>& nodes) {
  std::vector<int> counted;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(counted), [&](int n) { return map.counts[at(n)] != 0; });
  return counted;
}

void refuse_scaled_nodes(const RigidBody& body, const std::string& place) {
  if (body.shared_nodes == 0) return;
  throw InputError(
      fmt::format("{}: error: rigid body '{}' shares {} nodes with elements that deform (mass_scaling.every adds mass "
                  "during the run, which rigid bodies do not support): leave `every` out",
                  place, body.name, body.shared_nodes));
}

[[noreturn]] void refuse_line(const RigidBody& body, const std::string& place) {
  if (body.parts == 0) {
    throw InputError(
        fmt::format("{}: error: rigid body '{}' has no inertia (its nodes are at one place): name more "
                    "nodes, or give inertia",
                    place, body.name));
  }
  throw InputError(fmt::format(
      "{}: error: rigid body '{}' has no inertia about some axis (its masses lie on a line): give rigid.inertia", place,
      body.name));
}

std::string describe(const RigidBody& body) {
  const std::string parts = body.parts > 1 ? fmt::format(" of {} parts", body.parts) : "";
  const std::string shared =
      body.shared_nodes > 0 ? fmt::format(", {} shared with elements that deform", body.shared_nodes) : "";
  return fmt::format("rigid body '{}'{}: mass {:.6g}, centre ({:.6g}, {:.6g}, {:.6g}), {} nodes{}", body.name, parts,
                     body.mass, body.center.x, body.center.y, body.center.z, body.nodes, shared);
}

}  // namespace

bool gives_rigid_masses(const Deck& deck) {
  return std::any_of(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) {
    return part.rigid && (part.rigid->mass || part.rigid->center || part.rigid->inertia);
  });
}

void build_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map, const RigidMasses& masses,
                        Model& model) {
  if (!has_rigid_bodies(deck)) return;
  const RigidNames names = name_rigid_bodies(deck);
  RigidModel& rigid = model.rigid;
  const auto owned = list_owned_nodes(chunked, map, names.bodies.size());
  for (std::size_t b = 0; b < names.bodies.size(); ++b) {
    const int index = static_cast<int>(b);
    const std::vector<int> counted = list_counted(map, owned[b]);
    const MassSum sum = combine(sum_of_body(chunked, model, find_given(deck, names, index), masses, counted),
                                sum_of_sets(deck, chunked, map, {index, owned[b], masses.all}, model));
    RigidBody body;
    body.name = names.bodies[b];
    body.mass = sum.mass;
    body.center = sum.center;
    body.inertia = to_inertia(sum.second);
    body.parts = std::count(names.body_of_part.begin(), names.body_of_part.end(), index);
    if (body.parts == 0) body.inertia = to_inertia_of_line(sum.second);
    if (!has_inertia(body.inertia)) refuse_line(body, find_place(deck, names, index));
    measure(chunked, map, owned[b], model, body);
    if (model.scales_in_run) refuse_scaled_nodes(body, find_place(deck, names, index));
    model.mass_notes.push_back(describe(body));
    rigid.bodies.push_back(body);
  }
  rigid.nodes = list_nodes(chunked, map, rigid.bodies);
  rigid.body_of_node = to_view("percuss::body_of_node", map.body);
  rigid.loads = list_loads(chunked, deck, owned, model);
  add_body_loads(deck, names, rigid.bodies);
  int some = rigid.loads.first.back() > 0 ? 1 : 0;
  all_reduce(model.ranks, Reduce::largest, some);
  rigid.is_loaded = some != 0;
  rigid.is_all =
      std::all_of(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) { return part.rigid.has_value(); });
  if (rigid.is_all)
    model.mass_notes.emplace_back(
        "nothing deforms: the step follows from the speeds of the rigid bodies, time.end and "
        "time.max_step");
  rigid.least_edge = find_least_edge(deck, chunked, model);
  if (gives_rigid_masses(deck) || adds_rigid_masses(deck)) find_total(chunked, map, masses.all, model);
}

}  // namespace percuss
