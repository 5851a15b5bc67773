#include <cmath>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/assembly/build_conditions.hpp"
#include "src/step/initial/start_fields.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Share of the mesh's diagonal below which a distance from the centre is round-off, as of `inside` of a selector.
constexpr double center_margin = 1e-9;

/// Outward along the line from the centre or the axis; at the centre, where there is no direction, nothing.
Vec3 find_radial_velocity(const RadialVelocityDeck& radial, const Vec3& point, double least_radius) {
  Vec3 out = subtract(point, radial.center);
  if (radial.axis) {
    const double along = dot(*radial.axis, out);
    for (std::size_t k = 0; k < 3; ++k) out[k] -= along * (*radial.axis)[k];
  }
  const double radius = std::hypot(out[0], out[1], out[2]);
  if (radius <= least_radius) return {};
  for (double& component : out) component *= radial.speed / radius;
  return out;
}

/// Centre of mass of some nodes: rigid bodies of parts count whole, by their own masses, where all of their nodes are
/// among them.
Vec3 find_mass_center(const ChunkedMesh& chunked, const std::vector<int>& nodes, const RigidMap& rigid,
                      const std::vector<double>& mass, const Model& model) {
  const auto& bodies = model.rigid.bodies;
  std::vector<std::int64_t> counts(bodies.size(), 0);
  for (const int n : nodes)
    if (rigid.holds(n) && owns_node(chunked, n)) ++counts[at(rigid.body[at(n)])];
  if (!counts.empty()) all_reduce(model.ranks, Reduce::sum, counts);
  const auto is_whole = [&](std::size_t b) { return bodies[b].parts > 0 && counts[b] == bodies[b].nodes; };
  std::vector<int> points;
  for (const int n : nodes)
    if (!rigid.holds(n) || !is_whole(at(rigid.body[at(n)]))) points.push_back(n);
  const MassPoint of_points = find_mass_point(chunked, points, mass);
  double whole = of_points.mass;
  Vec3 center = whole > 0 ? of_points.center : Vec3{};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!is_whole(b)) continue;
    whole += bodies[b].mass;
    for (std::size_t k = 0; k < 3; ++k)
      center[k] += bodies[b].mass / whole * (get(bodies[b].center, static_cast<int>(k)) - center[k]);
  }
  return center;
}

}  // namespace

void build_initial_velocities(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid,
                              const std::vector<double>& mass, Model& model) {
  const Mesh& mesh = chunked.mesh;
  const Vec3 extent = subtract(mesh.high, mesh.low);
  const double least_radius = center_margin * std::hypot(extent[0], extent[1], extent[2]);
  std::vector<Vec3> velocity(mesh.nodes.size(), Vec3{});
  std::vector<Vec3> spin(model.has_rotations ? mesh.nodes.size() : 0, Vec3{});
  for (const InitialDeck& initial : deck.initial) {
    if (!find_body(initial.where).empty()) continue;  // start_rigid_bodies()
    const std::vector<int> nodes = select_nodes(mesh, deck, initial.where);
    const Vec3 center = initial.center ? *initial.center : find_mass_center(chunked, nodes, rigid, mass, model);
    for (const int node : nodes) {
      const auto n = static_cast<std::size_t>(node);
      const Vec3 turn = cross(initial.angular_velocity, subtract(mesh.nodes[n], center));
      for (std::size_t k = 0; k < 3; ++k) velocity[n][k] = initial.velocity[k] + turn[k];
      if (model.has_rotations) spin[n] = initial.angular_velocity;
      if (!initial.radial_velocity) continue;
      // No spin: the directors of shells that are concentric with the field keep their directions. Others would turn
      // with the fibres of a solid; theirs begin at rest, which is a transverse shear rate.
      const Vec3 out = find_radial_velocity(*initial.radial_velocity, mesh.nodes[n], least_radius);
      for (std::size_t k = 0; k < 3; ++k) velocity[n][k] += out[k];
    }
  }
  if (!deck.start.fields.empty()) {
    std::vector<char> is_rigid(mesh.nodes.size(), 0);
    for (std::size_t n = 0; n < is_rigid.size(); ++n) is_rigid[n] = rigid.holds(static_cast<int>(n)) ? 1 : 0;
    set_start_velocities(deck, chunked, is_rigid, velocity);
  }
  model.start_velocity = to_rows("percuss::start_velocity", velocity);
  model.start_spin = to_rows("percuss::start_spin", spin);
}

}  // namespace percuss
