#include "src/step/mass/fictitious_masses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/failure_criteria.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Masses of tetrahedra depend on those of their neighbours: they are found in so many rounds.
constexpr int most_rounds = 5;

/// Tolerated lack of the step of an element.
constexpr double tolerated_lack = 0.01;

/// The bound of a tetrahedron shares the mass of a node by stiffness (find_mixed_step()): it grows with the least of
/// what its nodes get.
bool has_bound_of_nodes(const Mesh& mesh, std::size_t element) {
  return mesh.topology_of(element).family == ElementFamily::tetrahedra;
}

Array<double> scale_each(const std::string& label, const Array<const double>& from, const std::vector<double>& by) {
  const Array<double> to(label, from.extent(0));
  const auto values = to_host(from);
  const auto host = Kokkos::create_mirror_view(to);
  for (std::size_t i = 0; i < by.size(); ++i) host(i) = by[i] * values(i);
  copy_values(to, host);
  return to;
}

/// 1 / mass in directions that are free.
Rows3<double> invert(const Rows3<double>& before, const Array<double>& mass) {
  const Rows3<double> inverse("percuss::inverse_of_relaxation", before.extent(0));
  parallel_for(
      "percuss::invert_masses", RangeOf(ExecSpace(), 0, static_cast<int>(before.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) inverse(n, k) = before(n, k) > 0 ? 1 / mass(n) : 0;
      });
  return inverse;
}

void scale_tensors(const SpinTensors& tensors, const Array<double>& ratios, bool back) {
  parallel_for(
      "percuss::scale_tensors", RangeOf(ExecSpace(), 0, static_cast<int>(tensors.node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 6; ++k) tensors.excess(i, k) *= back ? 1 / ratios(i) : ratios(i);
      });
}

}  // namespace

FictitiousMasses::FictitiousMasses(const ChunkedMesh& chunked, const Model& model)
    : chunked_(chunked),
      model_(model),
      summer_(model),
      bounds_(model),
      least_("percuss::relaxed_bounds", chunked.chunks.size()) {
  const auto bodies = to_host(model.rigid.body_of_node);
  bodies_of_nodes_.assign(bodies.data(), bodies.data() + bodies.extent(0));
}

/// growth: [elements] of their masses. Collective.
FictitiousMasses::NodeMasses FictitiousMasses::find_masses(const State& state, const std::vector<double>& growth) {
  const auto before = to_host(summer_.sum(state.element_mass));
  std::vector<std::array<double, 2>> own(before.extent(0));
  for (std::size_t n = 0; n < own.size(); ++n) own[n] = {before(n, 0), before(n, 1)};
  const auto after = to_host(summer_.sum(scale_each("percuss::relaxed_element_mass", state.element_mass, growth)));
  NodeMasses nodes;
  for (std::size_t n = 0; n < own.size(); ++n) {
    nodes.mass.push_back(after(n, 0));
    nodes.mass_ratio.push_back(own[n][0] > 0 ? after(n, 0) / own[n][0] : 1);
    nodes.inertia_ratio.push_back(own[n][1] > 0 ? after(n, 1) / own[n][1] : 1);
  }
  return nodes;
}

/// Growth of the square of the stable step of an element.
double FictitiousMasses::find_growth(std::size_t element, const std::vector<double>& growth,
                                     const NodeMasses& nodes) const {
  if (!has_bound_of_nodes(chunked_.mesh, element)) return growth[element];
  double least = std::numeric_limits<double>::infinity();
  for (const int n : chunked_.mesh.corners(element)) least = std::min(least, nodes.mass_ratio[at(n)]);
  return least;
}

/// Share of the masses that its nodes get which a rigid body has by itself, [bodies], at most 1. What elements give to
/// the nodes of a body moves with the whole body, which keeps its own mass: a light one is less inert than they count
/// on. Collective.
std::vector<double> FictitiousMasses::find_body_shares(const NodeMasses& nodes) const {
  const std::vector<RigidBody>& bodies = model_.rigid.bodies;
  std::vector<double> ratios(bodies.size(), 1);
  std::vector<ExactSum> sums(2 * bodies.size());  // mass, and its polar moment about the centre
  for (std::size_t n = 0; n < nodes.mass.size(); ++n) {
    const int b = bodies_of_nodes_.empty() ? -1 : bodies_of_nodes_[n];
    if (b < 0 || !(nodes.mass_ratio[n] > 1) || !owns_node(chunked_, static_cast<int>(n))) continue;
    const Vec3& x = chunked_.mesh.nodes[n];
    const Vector3<double> arm = Vector3<double>{x[0], x[1], x[2]} - bodies[at(b)].center;
    ratios[at(b)] = std::max({ratios[at(b)], nodes.mass_ratio[n], nodes.inertia_ratio[n]});
    sums[2 * at(b)].add(nodes.mass[n]);
    sums[2 * at(b) + 1].add(nodes.mass[n] * dot(arm, arm));
  }
  all_reduce(model_.ranks, Reduce::largest, ratios);
  sum_over_ranks(model_.ranks, sums);
  std::vector<double> shares;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Symmetric3<double>& i = bodies[b].inertia;
    const double least_inertia = -find_largest_eigenvalue({-i.xx, -i.yy, -i.zz, -i.xy, -i.yz, -i.zx});
    // A matrix with its off-diagonal blocks is at most twice its diagonal blocks.
    const double more = std::max(sums[2 * b].round() / bodies[b].mass, 2 * sums[2 * b + 1].round() / least_inertia);
    const bool is_bounded = !model_.has_rotations && least_inertia > 0;
    shares.push_back(1 / (is_bounded ? std::min(ratios[b], 1 + 2 * more) : ratios[b]));
  }
  return shares;
}

/// Growth of the square of the stable step of an element; without rigid bodies it would be `growth`.
double FictitiousMasses::limit_by_bodies(std::size_t element, double growth, const std::vector<double>& shares) const {
  if (bodies_of_nodes_.empty()) return growth;
  double limited = growth;
  for (const int n : chunked_.mesh.corners(element))
    if (const int b = bodies_of_nodes_[at(n)]; b >= 0)
      limited = std::min(limited, std::max(1.0, growth * shares[at(b)]));
  return limited;
}

double FictitiousMasses::give(State& state) {
  const std::vector<double> bounds = bounds_.list();
  double target = 0;
  for (const double bound : bounds) target = std::max(target, bound);
  all_reduce(model_.ranks, Reduce::largest, target);
  std::vector<double> growth(bounds.size(), 1);
  for (std::size_t e = 0; e < bounds.size(); ++e)
    if (bounds[e] > 0) growth[e] = std::pow(target / bounds[e], 2);
  NodeMasses nodes;
  for (int round = 0, is_enough = 0; round < most_rounds && is_enough == 0; ++round) {
    nodes = find_masses(state, growth);
    is_enough = 1;
    for (std::size_t e = 0; e < bounds.size(); ++e) {
      if (!(bounds[e] > 0) || round + 1 == most_rounds) continue;
      const double lack = target / bounds[e] / std::sqrt(find_growth(e, growth, nodes));
      if (!(lack > 1 + tolerated_lack)) continue;
      growth[e] *= lack * lack;
      is_enough = 0;
    }
    all_reduce(model_.ranks, Reduce::least, is_enough);
  }
  double least[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const std::vector<double> shares = find_body_shares(nodes);
  std::vector<double> factors(bounds.size(), 1);
  for (std::size_t e = 0; e < bounds.size(); ++e) {
    if (!(bounds[e] > 0)) continue;
    factors[e] = std::sqrt(limit_by_bodies(e, find_growth(e, growth, nodes), shares));
    least[0] = std::min(least[0], bounds[e]);
    least[1] = std::min(least[1], factors[e] * bounds[e]);
  }
  all_reduce(model_.ranks, Reduce::least, least);
  factors_ = to_view("percuss::relaxed_factors", factors);
  set_nodes(state, nodes);
  return std::isfinite(least[0]) ? least[1] / least[0] : 1;
}

/// Nodes of rigid bodies keep their own, and those that no element gives any.
void FictitiousMasses::set_nodes(State& state, const NodeMasses& nodes) {
  const auto mass = to_host(state.mass);
  const auto body = to_host(model_.rigid.body_of_node);
  std::vector<double> ratios(nodes.mass.size(), 1), turning = nodes.inertia_ratio, weights(nodes.mass.size(), 1);
  for (std::size_t n = 0; n < ratios.size(); ++n) {
    const bool is_rigid = body.extent(0) > 0 && body(n) >= 0;
    if (is_rigid) turning[n] = 1;
    if (is_rigid || !(mass(n) > 0) || !(nodes.mass[n] > 0)) continue;
    ratios[n] = nodes.mass[n] / mass(n);
    weights[n] = mass(n) / nodes.mass[n];
  }
  weights_ = to_view("percuss::relaxed_weights", weights);
  own_mass_ = state.mass;
  state.mass = scale_each("percuss::relaxed_mass", state.mass, ratios);
  state.inverse_mass = invert(state.inverse_mass, state.mass);
  if (!model_.has_rotations) return;
  own_inertia_ = state.inertia;
  state.inertia = scale_each("percuss::relaxed_inertia", state.inertia, turning);
  state.inverse_inertia = invert(state.inverse_inertia, state.inertia);
  if (!state.spin_tensors.any()) return;
  const auto turned = to_host(state.spin_tensors.node);
  std::vector<double> of_tensors(turned.extent(0));
  for (std::size_t i = 0; i < of_tensors.size(); ++i) of_tensors[i] = turning[at(turned(i))];
  tensor_ratios_ = to_view("percuss::relaxed_tensors", of_tensors);
  scale_tensors(state.spin_tensors, tensor_ratios_, false);
}

void FictitiousMasses::take(State& state) const {
  if (factors_.extent(0) == 0) return;
  state.mass = own_mass_;
  if (!model_.has_rotations) return;
  state.inertia = own_inertia_;
  if (state.spin_tensors.any()) scale_tensors(state.spin_tensors, tensor_ratios_, true);
}

Array<double> FictitiousMasses::find_bounds(const ChunkResults& results) const {
  if (factors_.extent(0) == 0) return results.stable_step;
  const auto least = least_, factors = factors_, least_of_chunk = results.stable_step;
  const ElementBounds bounds = bounds_;
  parallel_for(
      "percuss::find_relaxed_bounds", RangeOf(ExecSpace(), 0, bounds.chunks.count), KOKKOS_LAMBDA(const int c) {
        double here = INFINITY;
        for (int i = 0; i < count_elements(bounds.chunks, c); ++i) {
          const double bound = bounds(c, i) * factors(bounds.chunks.first_element(c) + i);
          if (bound < here) here = bound;
        }
        least(c) = least_of_chunk(c) < INFINITY ? here : INFINITY;  // of rigid parts
      });
  return least_;
}

void FictitiousMasses::predict(State& state, const StepTimes& times) {
  const Gravity gravity = state.gravity;
  if (gravity.g[0] == 0 && gravity.g[1] == 0 && gravity.g[2] == 0) return;
  const auto weights = weights_;
  const double dt_mean = times.dt_mean;
  const auto v = state.v, inverse_mass = state.inverse_mass;
  parallel_for(
      "percuss::pull_by_weight", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k)
          if (inverse_mass(n, k) > 0) v(n, k) += dt_mean * weights(n) * gravity.g[k];
      });
}

}  // namespace percuss
