#include "src/step/build/build_masses.hpp"

#include <numeric>

#include "comm/halo/halo_swap.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/beams/build_beams.hpp"
#include "src/step/build/build_conditions.hpp"
#include "src/step/build/check_precision.hpp"
#include "src/step/build/chunks/build_shells.hpp"
#include "src/step/build/mass_scaling.hpp"
#include "src/step/model/pack_width.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// By the modes of the element's kernel.
double find_kernel_volume(const Mesh& mesh, std::size_t element) {
  if (mesh.topology_of(element).family != ElementFamily::hexahedra) return find_element_volume(mesh, element);
  const HexCorners corners = gather_corners(mesh.elements, element, mesh.nodes);
  double x[8], y[8], z[8];
  for (std::size_t i = 0; i < 8; ++i) {
    x[i] = corners[i][0];
    y[i] = corners[i][1];
    z[i] = corners[i][2];
  }
  to_modes(x);
  to_modes(y);
  to_modes(z);
  VectorModes<double> a{};
  for (int m = 1; m < 8; ++m) a[m] = {x[m], y[m], z[m]};
  return find_volume_gradient(a).volume;
}

/// The share of each chunk in the mass of its nodes, in the first column: elements in ascending order.
Rows3<double> sum_mass_by_slot(const Model& model, const Elements& elements, const std::vector<double>& element_mass) {
  const Rows3<double> slot_mass("percuss::slot_mass", static_cast<std::size_t>(model.slot_count));
  const auto host = Kokkos::create_mirror_view(slot_mass);
  const auto first_element = to_host(model.chunks.first_element), first_slot = to_host(model.chunks.first_slot),
             first_pack = to_host(model.chunks.first_pack);
  const auto corner_slots = to_host(model.chunks.corner_slots);
  for (std::size_t c = 0; c < static_cast<std::size_t>(model.chunks.count); ++c) {
    for (int e = first_element(c); e < first_element(c + 1); ++e) {
      const int i = e - first_element(c);
      const double share = element_mass[static_cast<std::size_t>(e)] / 8;
      const auto slot = [&](int corner) {
        return corner_slots(
            (static_cast<std::size_t>(first_pack(c) + i / pack_width) * 8 + static_cast<std::size_t>(corner)) *
                pack_width +
            static_cast<std::size_t>(i % pack_width));
      };
      const Topology& topology = elements.topology_of(static_cast<std::size_t>(e));
      for (int corner = 0; corner < 8; ++corner) {
        const double eighths = topology.find_mass_share(static_cast<std::size_t>(corner));
        host(static_cast<std::size_t>(first_slot(c) + slot(corner)), 0) += eighths * share;
      }
    }
  }
  Kokkos::deep_copy(slot_mass, host);
  return slot_mass;
}

/// Masses of the nodes, as forces are summed: so every copy of a node has the same bits.
std::vector<double> assemble_masses(const Model& model, const Elements& elements,
                                    const std::vector<double>& element_mass) {
  const Rows3<double> slot_mass = sum_mass_by_slot(model, elements, element_mass);
  HaloSwap swap(model.ranks, model.halo);
  swap.begin(ExecSpace(), slot_mass);
  swap.end();
  const Rows3<double> rows("percuss::node_mass", static_cast<std::size_t>(model.node_count));
  assemble_slots(ExecSpace(), model.nodes_to_slots, slot_mass, rows);
  const auto host = to_host(rows);
  std::vector<double> mass(host.extent(0));
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = host(n, 0);
  return mass;
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
  std::vector<double> element_mass(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto material = static_cast<std::size_t>(mesh.block_of(e).material);
    element_mass[e] = deck.materials[material].density * find_kernel_volume(mesh, e);
  }
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
  model.mass = to_view("percuss::mass", mass);
  model.element_mass = to_view("percuss::element_mass", element_mass);
  if (model.has_rotations) build_inertia(deck, mesh, element_mass, model);
  return mass;
}

std::vector<double> find_masses_of_others(const Deck& deck, const ChunkedMesh& chunked, const Model& model) {
  if (!gives_rigid_masses(deck)) return {};
  const auto of_elements = to_host(model.element_mass), extra = to_host(model.extra_mass);
  std::vector<double> element_mass(chunked.mesh.elements.size(), 0);
  for (const Chunk& chunk : chunked.chunks) {
    if (is_rigid_chunk(deck, chunk)) continue;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
      element_mass[static_cast<std::size_t>(e)] = of_elements(e);
  }
  std::vector<double> mass = assemble_masses(model, chunked.mesh.elements, element_mass);
  for (std::size_t n = 0; n < extra.extent(0); ++n) mass[n] += extra(n);
  return mass;
}

}  // namespace percuss
