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
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/rigid/inertia.hpp"
#include "src/step/rigid/mass_sum.hpp"

namespace percuss {
namespace {

/// Place of the first part or set of a body.
std::string find_place(const Deck& deck, const RigidNames& names, int body) {
  return deck.where(find_body_place(deck, names, body));
}

/// Nodes as points, with rotary inertia of shells and beams, the same about any axis.
std::vector<MassSum> list_points(const ChunkedMesh& chunked, const std::vector<int>& nodes,
                                 const std::vector<double>& mass, const std::vector<double>& inertia) {
  std::vector<MassSum> points;
  for (const int n : nodes) {
    const double half = inertia.empty() ? 0 : 0.5 * inertia[at(n)];
    if (mass[at(n)] == 0 && half == 0) continue;
    points.push_back({mass[at(n)], to_vector(chunked.mesh.nodes[at(n)]), {half, half, half, 0, 0, 0}});
  }
  return points;
}

/// Masses that the sets of a body add to its nodes. mass: [nodes] lumped, of everything. Collective.
MassSum sum_of_sets(const Deck& deck, const ChunkedMesh& chunked, int body, const std::vector<double>& mass,
                    const Model& model) {
  MassSum added;
  const RigidNames names = name_rigid_bodies(deck);
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s) {
    const RigidSetDeck& set = deck.rigid_sets[s];
    if (names.body_of_set[s] != body || (set.mass == 0 && !set.inertia)) continue;
    MassSum more;
    more.mass = set.mass;
    if (set.inertia) more.second = to_second_moments(*set.inertia);
    if (set.center) {
      more.center = to_vector(*set.center);
    } else {
      std::vector<int> nodes;
      for (const int n : select_nodes(chunked.mesh, deck, set.where))
        if (owns_node(chunked, n)) nodes.push_back(n);
      more.center = sum_pieces(model.ranks, list_points(chunked, nodes, mass, {})).center;
    }
    added = combine(added, more);
  }
  return added;
}

/// Masses that the deck gives for the parts of a body, instead of their elements' masses.
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

/// A body and the nodes of it that this rank owns.
struct RigidNodeList {
  int body = 0;
  const std::vector<int>& owned;
};

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

/// Total mass and mass centre, with those of the bodies.
void find_total(const ChunkedMesh& chunked, const RigidMap& map, const std::vector<double>& mass, Model& model) {
  std::vector<int> loose;
  for (std::size_t n = 0; n < mass.size(); ++n)
    if (map.body[n] < 0 && owns_node(chunked, static_cast<int>(n))) loose.push_back(static_cast<int>(n));
  MassSum total = sum_pieces(model.ranks, list_points(chunked, loose, mass, {}));
  for (const RigidBody& body : model.rigid.bodies) total = combine({body.mass, body.center, {}}, total);
  model.total_mass = total.mass;
  model.mass_center = {total.center.x, total.center.y, total.center.z};
}

/// Chunks of rigid parts, each with what its elements have by their exact integrals.
std::vector<RigidChunk> list_rigid_chunks(const Deck& deck, const ChunkedMesh& chunked, const RigidNames& names,
                                          const Model& model) {
  std::vector<RigidChunk> chunks;
  const auto mass = to_host(model.element_mass);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    const int body = names.body_of_part[at(chunk.part)];
    if (body < 0) continue;
    MassSum sum;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
      sum = combine(sum, find_element_masses(deck, chunked.mesh, model, at(e), mass(at(e))));
    chunks.push_back({static_cast<int>(c), body, sum.mass, sum.center, sum.second});
  }
  return chunks;
}

/// Mass of a body: of its elements, or given; with that of others on its nodes, which given values do not include.
MassSum sum_of_body(const ChunkedMesh& chunked, const Model& model, const GivenMasses& given, const RigidMasses& masses,
                    const RigidNodeList& of) {
  std::vector<MassSum> pieces;
  for (const RigidChunk& chunk : model.rigid.chunks)
    if (chunk.body == of.body) pieces.push_back({chunk.mass, chunk.center, chunk.second});
  MassSum sum = sum_pieces(model.ranks, pieces);
  if (given.any()) apply(given, sum);
  return combine(sum,
                 sum_pieces(model.ranks, list_points(chunked, of.owned, masses.of_others, masses.inertia_of_others)));
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

/// A product of inertia for people: round-off is 0.
double clean(double product, const Symmetric3<double>& inertia) {
  constexpr double round_off = 1e-12;
  return std::abs(product) > round_off * trace(inertia) ? product : 0;
}

std::string describe(const RigidBody& body) {
  const std::string parts = body.parts > 1 ? fmt::format(" of {} parts", body.parts) : "";
  const std::string shared =
      body.shared_nodes > 0 ? fmt::format(", {} shared with elements that deform", body.shared_nodes) : "";
  const Symmetric3<double>& i = body.inertia;
  return fmt::format(
      "rigid body '{}'{}: mass {:.6g}, centre ({:.6g}, {:.6g}, {:.6g}), inertia xx {:.6g}, yy {:.6g}, zz {:.6g}, "
      "xy {:.6g}, yz {:.6g}, zx {:.6g} about it, {} nodes{}",
      body.name, parts, body.mass, body.center.x, body.center.y, body.center.z, i.xx, i.yy, i.zz, clean(i.xy, i),
      clean(i.yz, i), clean(i.zx, i), body.nodes, shared);
}

}  // namespace

void build_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map, const RigidMasses& masses,
                        Model& model) {
  if (!has_rigid_bodies(deck)) return;
  const RigidNames names = name_rigid_bodies(deck);
  RigidModel& rigid = model.rigid;
  const auto owned = list_owned_nodes(chunked, map, names.bodies.size());
  rigid.chunks = list_rigid_chunks(deck, chunked, names, model);
  for (std::size_t b = 0; b < names.bodies.size(); ++b) {
    const int index = static_cast<int>(b);
    const GivenMasses given = find_given(deck, names, index);
    const std::vector<int> counted = list_counted(map, owned[b]);
    const MassSum sum = combine(sum_of_body(chunked, model, given, masses, {index, counted}),
                                sum_of_sets(deck, chunked, index, masses.all, model));
    RigidBody body;
    body.name = names.bodies[b];
    body.mass = sum.mass;
    body.center = sum.center;
    body.inertia = to_inertia(sum.second);
    body.has_given_masses = given.any();
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
  rigid.is_all = true;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) rigid.is_all = rigid.is_all && is_uncomputed(deck, p);
  if (rigid.is_all)
    model.mass_notes.emplace_back(
        "nothing deforms: the step follows from the speeds of the rigid bodies, time.end and "
        "time.max_step");
  rigid.least_edge = find_least_edge(deck, chunked, model);
  if (has_rigid_parts(deck) || adds_rigid_masses(deck)) find_total(chunked, map, masses.all, model);
}

}  // namespace percuss
