#include "src/step/assembly/build_masses.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/step/assembly/build_conditions.hpp"
#include "src/step/assembly/check_precision.hpp"
#include "src/step/elements/build_beams.hpp"
#include "src/step/elements/build_shells.hpp"
#include "src/step/elements/element_mass.hpp"
#include "src/step/fluids/hydrostatic.hpp"
#include "src/step/mass/mass_scaling.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// The share of each chunk in what its nodes get of their elements, in so many columns: elements in ascending order.
/// values: [elements][columns].
template <std::size_t columns>
Rows3<double> sum_by_slot(const Model& model, const Elements& elements,
                          const std::vector<std::array<double, columns>>& values) {
  const Rows3<double> by_slot("percuss::slot_mass", static_cast<std::size_t>(model.slot_count));
  const auto host = Kokkos::create_mirror_view(by_slot);
  const HostChunks chunks(model.chunks);
  for (int c = 0; c < chunks.count; ++c) {
    for (int i = 0; i < count_elements(chunks, c); ++i) {
      const auto e = static_cast<std::size_t>(find_element(chunks, c, i));
      const Topology& topology = elements.topology_of(e);
      for (int corner = 0; corner < 8; ++corner) {
        const double eighths = topology.find_mass_share(static_cast<std::size_t>(corner));
        const int slot = number_corner_slot(chunks, c, i, corner);
        for (std::size_t k = 0; k < columns; ++k) host(slot, k) += eighths * (values[e][k] / 8);
      }
    }
  }
  copy_values(by_slot, host);
  return by_slot;
}

/// Sums the masses of nodes over their elements, as forces are summed: so every copy of a node has the same bits.
template <std::size_t columns>
Rows3<double> sum_by_node(const Model& model, const Elements& elements,
                          const std::vector<std::array<double, columns>>& values) {
  const Rows3<double> by_slot = sum_by_slot(model, elements, values);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), by_slot);
  swap.end();
  const Rows3<double> rows("percuss::node_mass", static_cast<std::size_t>(model.node_count));
  assemble_slots(ExecSpace(), model.nodes_to_slots, by_slot, rows);
  return rows;
}

std::vector<double> assemble_masses(const Model& model, const Elements& elements,
                                    const std::vector<double>& element_mass) {
  std::vector<std::array<double, 1>> values;
  values.reserve(element_mass.size());
  for (const double mass : element_mass) values.push_back({mass});
  const auto host = to_host(sum_by_node(model, elements, values));
  std::vector<double> mass(host.extent(0));
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = host(n, 0);
  return mass;
}

/// Nodes that ties and welds turn, and those of rigid bodies, which have no rotation of their own.
std::vector<char> mark_plain_nodes(const Deck& deck, const ChunkedMesh& chunked, const Model& model) {
  std::vector<char> marks(chunked.mesh.nodes.size(), 0);
  const auto mark = [&](const auto& nodes) {
    for (std::size_t i = 0; i < nodes.extent(0); ++i) marks[static_cast<std::size_t>(nodes(i))] = 1;
  };
  mark(to_host(model.welds.local_node));
  mark(to_host(model.rigid.nodes.node));
  for (const TieDeck& tie : deck.contact.ties) {
    if (!tie.rotations) continue;
    for (const int n : select_surface_nodes(chunked.mesh, deck, tie.a).nodes) marks[static_cast<std::size_t>(n)] = 1;
  }
  return marks;
}

/// Rotary inertia of the nodes, summed as their masses are.
void build_inertia(const Deck& deck, const Mesh& mesh, std::vector<double> element_mass, Model& model) {
  std::vector<double> gyration_square = find_gyration_squares(deck, mesh);
  set_beam_gyrations(deck, mesh, gyration_square);
  for (std::size_t e = 0; e < element_mass.size(); ++e) element_mass[e] *= gyration_square[e];
  model.gyration_square = to_view("percuss::gyration_square", gyration_square);
  model.inertia = to_view("percuss::inertia", assemble_masses(model, mesh.elements, element_mass));
}

}  // namespace

std::vector<double> build_masses(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  const Mesh& mesh = chunked.mesh;
  check_surfaces(deck, mesh);
  std::vector<double> element_mass(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) element_mass[e] = find_element_mass(deck, mesh, e);
  if constexpr (is_single_precision) check_single_precision(deck, chunked, element_mass);
  scale_masses(deck, chunked, element_mass, model);
  model.scales_in_run = deck.scales_mass_in_run();
  model.resists_folding = deck.elements.resist_folding;
  std::vector<double> mass = assemble_masses(model, mesh.elements, element_mass);
  add_deck_masses(deck, chunked, mass, model);
  std::vector<int> all(mass.size());
  std::iota(all.begin(), all.end(), 0);
  const MassPoint scene = find_mass_point(chunked, all, mass);
  model.total_mass = scene.mass;
  model.mass_center = scene.center;
  const Vec3 extent = subtract(mesh.high, mesh.low);
  model.half_extent = 0.5 * std::sqrt(dot(extent, extent));
  model.mass = to_view("percuss::mass", mass);
  model.element_mass = to_view("percuss::element_mass", element_mass);
  if (model.has_rotations) build_inertia(deck, mesh, element_mass, model);
  return mass;
}

void build_spin_tensors(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  if (!has_bending_beams(deck, chunked.mesh)) return;
  const auto mass = to_host(model.element_mass);
  const auto of_elements = find_beam_tensors(deck, chunked.mesh, {mass.data(), mass.data() + mass.extent(0)});
  std::vector<std::array<double, 3>> halves[2];
  for (const auto& t : of_elements) {
    halves[0].push_back({t[0], t[1], t[2]});
    halves[1].push_back({t[3], t[4], t[5]});
  }
  const auto first = to_host(sum_by_node(model, chunked.mesh.elements, halves[0])),
             second = to_host(sum_by_node(model, chunked.mesh.elements, halves[1]));
  const std::vector<char> is_plain = mark_plain_nodes(deck, chunked, model);
  std::vector<int> nodes, row(chunked.mesh.nodes.size(), -1);
  for (std::size_t n = 0; n < row.size(); ++n) {
    if (is_plain[n] != 0 || first(n, 0) + first(n, 1) + first(n, 2) == 0) continue;
    row[n] = static_cast<int>(nodes.size());
    nodes.push_back(static_cast<int>(n));
  }
  model.spin_tensors = {to_view("percuss::tensor_nodes", nodes), to_view("percuss::tensor_rows", row),
                        TensorRows("percuss::spin_tensors", nodes.size())};
  const auto excess = Kokkos::create_mirror_view(model.spin_tensors.excess);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto n = static_cast<std::size_t>(nodes[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      excess(i, k) = first(n, k);
      excess(i, 3 + k) = second(n, k);
    }
  }
  copy_values(model.spin_tensors.excess, excess);
}

RigidMasses find_rigid_masses(const Deck& deck, const ChunkedMesh& chunked, const std::vector<double>& mass,
                              const Model& model) {
  RigidMasses masses{mass, {}, {}};
  if (!has_rigid_bodies(deck)) return masses;
  const auto of_elements = to_host(model.element_mass), extra = to_host(model.extra_mass),
             gyration_square = to_host(model.gyration_square);
  std::vector<double> element_mass(chunked.mesh.elements.size(), 0), turning;
  for (const Chunk& chunk : chunked.chunks) {
    if (deck.parts[static_cast<std::size_t>(chunk.part)].rigid) continue;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
      element_mass[static_cast<std::size_t>(e)] = of_elements(e);
  }
  masses.of_others = assemble_masses(model, chunked.mesh.elements, element_mass);
  for (std::size_t n = 0; n < extra.extent(0); ++n) masses.of_others[n] += extra(n);
  if (!model.has_rotations) return masses;
  for (std::size_t e = 0; e < element_mass.size(); ++e) turning.push_back(element_mass[e] * gyration_square(e));
  masses.inertia_of_others = assemble_masses(model, chunked.mesh.elements, turning);
  return masses;
}

}  // namespace percuss
