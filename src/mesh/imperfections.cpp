#include "src/mesh/imperfections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "comm/halo/shared_nodes.hpp"
#include "kernels/core/same_bits.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Random number from -1 to 1, the same for the same key.
double find_random(std::uint64_t key) {
  constexpr double unit = 1.0 / 4503599627370496.0;  // 2^-52
  return static_cast<double>(mix_bits(key) >> 11) * unit - 1;
}

/// A node's sum of the unit normals of its shells, in integers: no order of the sum shows in its bits.
struct NormalSum {
  static constexpr double unit = 1099511627776.0;  // 2^40
  std::int64_t node = 0;                           // number in the whole mesh
  std::array<std::int64_t, 3> sum{};
};

std::vector<NormalSum> sum_own_normals(const Mesh& mesh) {
  std::vector<NormalSum> sums(mesh.nodes.size());
  for (std::size_t n = 0; n < sums.size(); ++n) sums[n].node = mesh.node_numbers[n];
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    const Vec3 area = find_shell_area(gather_corners(mesh.elements, e, mesh.nodes));
    const double size = std::sqrt(dot(area, area));
    for (const int n : mesh.corners(e)) {
      for (std::size_t k = 0; k < 3; ++k)
        sums[at(n)].sum[k] += static_cast<std::int64_t>(std::llround(area[k] / size * NormalSum::unit));
    }
  }
  return sums;
}

/// Adds what other ranks have of the nodes that they hold too.
void add_other_ranks(const Communicator& ranks, const Mesh& mesh, std::vector<NormalSum>& sums) {
  if (ranks.size() == 1) return;
  UnstructuredExchange exchange(ranks);
  std::vector<int> shared = find_shared_nodes(exchange, mesh.node_numbers).nodes;
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  std::vector<NormalSum> own;
  for (const int n : shared) {
    own.push_back(sums[at(n)]);
    sums[at(n)].sum = {};
  }
  for (const NormalSum& part : gather_items(ranks, own)) {
    const auto place = std::lower_bound(mesh.node_numbers.begin(), mesh.node_numbers.end(), part.node);
    if (place == mesh.node_numbers.end() || *place != part.node) continue;
    const auto n = static_cast<std::size_t>(place - mesh.node_numbers.begin());
    for (std::size_t k = 0; k < 3; ++k) sums[n].sum[k] += part.sum[k];
  }
}

/// [nodes] unit normals of the shells of each node; 0 where there is none. Collective.
std::vector<Vec3> find_node_normals(const Communicator& ranks, const Mesh& mesh) {
  std::vector<NormalSum> sums = sum_own_normals(mesh);
  add_other_ranks(ranks, mesh, sums);
  std::vector<Vec3> normals(sums.size());
  for (std::size_t n = 0; n < sums.size(); ++n) {
    Vec3& normal = normals[n];
    for (std::size_t k = 0; k < 3; ++k) normal[k] = static_cast<double>(sums[n].sum[k]);
    const double size = std::sqrt(dot(normal, normal));
    for (std::size_t k = 0; k < 3; ++k) normal[k] = size > 1e-6 * NormalSum::unit ? normal[k] / size : 0;
  }
  return normals;
}

/// How far a node is displaced along its direction.
double find_displacement(const ImperfectionDeck& imperfection, const Vec3& place, std::int64_t id) {
  if (imperfection.mode) return (*imperfection.mode)(place);
  const NoiseDeck& noise = *imperfection.noise;
  const auto seed = static_cast<std::uint64_t>(noise.seed);
  return noise.amplitude * (noise.length ? find_noise(place, *noise.length, seed) : find_noise(id, seed));
}

/// Report and fault of an entry; of all ranks once merged.
struct Outcome {
  double largest = 0;
  double size = 0;  // longest edge of the box of its nodes
  std::int64_t nodes = 0;
  int bare = 0, endless = 0;  // 1: a node without a normal; a displacement that is not finite
};

Outcome displace(const ImperfectionDeck& imperfection, const std::vector<int>& nodes, const std::vector<Vec3>& normals,
                 const Mesh& mesh, std::vector<Vec3>& moved) {
  Outcome outcome;
  for (const int n : nodes) {
    const Vec3 along = imperfection.direction ? *imperfection.direction : normals[at(n)];
    const double d = find_displacement(imperfection, mesh.nodes[at(n)], mesh.node_ids[at(n)]);
    if (!std::isfinite(d)) outcome.endless = 1;
    if (along == Vec3{}) outcome.bare = 1;
    for (std::size_t k = 0; k < 3; ++k) moved[at(n)][k] += d * along[k];
    outcome.largest = std::max(outcome.largest, std::abs(d));
  }
  return outcome;
}

/// Nodes that several ranks hold count once: with the lowest of them.
std::int64_t count_nodes(const Communicator& ranks, const Mesh& mesh, const std::vector<int>& nodes) {
  std::int64_t count = static_cast<std::int64_t>(nodes.size());
  if (ranks.size() == 1) return count;
  UnstructuredExchange exchange(ranks);
  const SharedNodes shared = find_shared_nodes(exchange, mesh.node_numbers);
  count = std::count_if(nodes.begin(), nodes.end(), [&](int n) { return shared.owners[at(n)] == ranks.rank(); });
  all_reduce(ranks, Reduce::sum, count);
  return count;
}

void check_outcome(const Deck& deck, const ImperfectionDeck& imperfection, const Outcome& outcome) {
  if (outcome.endless != 0)
    throw InputError(deck.where(imperfection.place) +
                     ": error: the imperfection is not finite at some node (it must be a number everywhere)");
  if (outcome.bare != 0)
    throw InputError(deck.where(imperfection.place) +
                     ": error: the imperfection has no direction at some node (only nodes of shells have a normal): "
                     "give a direction");
}

/// Longest edge of the box around nodes of all ranks [length].
double find_size(const Communicator& ranks, const Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<double> bounds(6, -std::numeric_limits<double>::infinity());  // minus the lowest, then the highest place
  for (const int n : nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      bounds[k] = std::max(bounds[k], -mesh.nodes[at(n)][k]);
      bounds[3 + k] = std::max(bounds[3 + k], mesh.nodes[at(n)][k]);
    }
  }
  all_reduce(ranks, Reduce::largest, bounds);
  return std::max({bounds[0] + bounds[3], bounds[1] + bounds[4], bounds[2] + bounds[5]});
}

/// An imperfection that changes the shape as a whole.
void warn_of_size(const Deck& deck, const ImperfectionDeck& imperfection, const Outcome& outcome, Mesh& mesh) {
  constexpr double most = 0.1;  // of the size of what is displaced; imperfections are a few per cent of a thickness
  if (outcome.largest <= most * outcome.size) return;
  mesh.warnings.push_back({"imperfection_size",
                           fmt::format("the imperfection displaces nodes by up to {:.3g}, what it displaces is {:.3g} "
                                       "long (an imperfection is a small share of it): check its unit",
                                       outcome.largest, outcome.size),
                           deck.where(imperfection.place), 0, 1});
}

/// Elements that were sound before.
void check_elements(const Deck& deck, const Communicator& ranks, const Mesh& mesh) {
  constexpr std::int64_t none = std::int64_t{1} << 62;
  std::int64_t worst = none;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (!(find_element_volume(mesh, e) > 0)) worst = std::min(worst, mesh.element_ids[e]);
  all_reduce(ranks, Reduce::least, worst);
  if (worst == none) return;
  throw InputError(
      fmt::format("{}: error: the imperfections leave element {} without volume (its nodes move past each other): make "
                  "the imperfections smaller",
                  deck.where(deck.imperfections.front().place), worst));
}

}  // namespace

double find_noise(std::int64_t node_id, std::uint64_t seed) {
  return find_random(mix_bits(seed) ^ static_cast<std::uint64_t>(node_id));
}

// Value noise (Perlin's smooth step between the corners of a cell): first and second derivatives are continuous.
double find_noise(const Vec3& place, double length, std::uint64_t seed) {
  std::array<std::int64_t, 3> cell{};
  Vec3 share{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double scaled = place[k] / length, low = std::floor(scaled), t = scaled - low;
    cell[k] = static_cast<std::int64_t>(low);
    share[k] = t * t * t * (t * (6 * t - 15) + 10);
  }
  double value = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::uint64_t key = mix_bits(seed);
    double weight = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned high = corner >> k & 1;
      key = mix_bits(key ^ static_cast<std::uint64_t>(cell[k] + high));
      weight *= high != 0 ? share[k] : 1 - share[k];
    }
    value += weight * find_random(key);
  }
  return value;
}

void apply_imperfections(const Deck& deck, const Communicator& ranks, Mesh& mesh) {
  if (deck.imperfections.empty()) return;
  const std::vector<Vec3> normals = find_node_normals(ranks, mesh);
  std::vector<Vec3> moved = mesh.nodes;
  for (const ImperfectionDeck& imperfection : deck.imperfections) {
    const std::vector<int> nodes = select_nodes(mesh, deck, imperfection.where);
    Outcome outcome = displace(imperfection, nodes, normals, mesh, moved);
    outcome.nodes = count_nodes(ranks, mesh, nodes);
    outcome.size = find_size(ranks, mesh, nodes);
    all_reduce(ranks, Reduce::largest, outcome.largest);
    all_reduce(ranks, Reduce::largest, outcome.bare);
    all_reduce(ranks, Reduce::largest, outcome.endless);
    check_outcome(deck, imperfection, outcome);
    warn_of_size(deck, imperfection, outcome, mesh);
    const std::string& name = imperfection.where.name;
    mesh.notes.push_back(fmt::format("imperfection of {}: largest displacement {:.4g}, of {} nodes",
                                     name.empty() ? "all nodes" : "'" + name + "'", outcome.largest, outcome.nodes));
  }
  mesh.nodes = std::move(moved);
  check_elements(deck, ranks, mesh);
}

}  // namespace percuss
