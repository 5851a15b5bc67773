#include "src/step/mass/lumped_masses.hpp"

#include "kernels/core/small_space.hpp"
#include "kernels/element/element_records.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {
namespace {

/// Shares of the corners that kernels see, in eighths of the mass of an element. Which of those follows from the
/// corners that stand twice.
struct MassShares {
  Kokkos::Array<double, kernel_corner_count> hex, quad, triangle, line, wedge, pyramid;

  MassShares() {
    for (std::size_t i = 0; i < kernel_corner_count; ++i) {
      hex[i] = hex8_topology.find_mass_share(i);
      quad[i] = quad4_topology.find_mass_share(i);
      triangle[i] = tri3_topology.find_mass_share(i);
      line[i] = line2_topology.find_mass_share(i);
      wedge[i] = wedge6_topology.find_mass_share(i);
      pyramid[i] = pyramid5_topology.find_mass_share(i);
    }
  }
};

}  // namespace

LumpedMasses::LumpedMasses(const Model& model)
    : model_(model),
      slots_("percuss::slot_lumped", static_cast<std::size_t>(model.slot_count)),
      nodes_("percuss::lumped", static_cast<std::size_t>(model.node_count)),
      halo_(model.ranks, model.halo) {}

const Rows3<double>& LumpedMasses::sum(const Array<const double>& element_mass) {
  const MassShares shares;
  const auto slots = slots_;
  const auto mass = element_mass;
  const auto gyration_square = model_.gyration_square;
  const ElementChunks chunks = model_.chunks;
  parallel_for(
      "percuss::lump_masses", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int s = chunks.first_slot(c); s < chunks.first_slot(c + 1); ++s) slots(s, 0) = slots(s, 1) = 0;
        const int first = chunks.first_element(c);
        const bool of_shells = is_shell(chunks, c), of_beams = is_beam(chunks, c);
        const bool turns = (of_shells || of_beams) && gyration_square.extent(0) > 0;
        for (int i = 0; i < chunks.first_element(c + 1) - first; ++i) {
          const auto slot = [&](int k) { return find_corner_slot(chunks, c, i, k); };
          const auto& share = of_beams                          ? shares.line
                              : of_shells && slot(2) == slot(3) ? shares.triangle
                              : of_shells                       ? shares.quad
                              : slot(4) == slot(5)              ? shares.pyramid
                              : slot(5) == slot(7)              ? shares.wedge
                                                                : shares.hex;
          const double eighth = mass(first + i) / 8,
                       turning = turns ? mass(first + i) * gyration_square(first + i) / 8 : 0;
          for (int k = 0; k < 8; ++k) {
            slots(chunks.first_slot(c) + slot(k), 0) += share[k] * eighth;
            slots(chunks.first_slot(c) + slot(k), 1) += share[k] * turning;
          }
        }
      });
  halo_.begin(ExecSpace(), slots_);
  halo_.end();
  assemble_slots(ExecSpace(), model_.nodes_to_slots, slots_, nodes_);
  return nodes_;
}

}  // namespace percuss
