#pragma once
// The chunks of a model by compiled variant, as the launchers take them. Apart from the model: whoever includes this
// compiles the laws and the layers of shells.

#include <tuple>

#include "kernels/beam/beam_damping.hpp"
#include "kernels/beam/beam_force.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/element/stiffness_damping.hpp"
#include "kernels/one_point/one_point_chunks.hpp"
#include "kernels/shell/shell_damping.hpp"
#include "kernels/shell/shell_force.hpp"
#include "kernels/tet/tet_force.hpp"

namespace percuss {

/// Data of some chunks for the launchers, family by family.
struct ElementBlocks {
  HexBlocks hexahedra;
  TetBlocks tetrahedra;
  OnePointBlocks one_point;  // wedges and pyramids
  ShellBlocks shells;
  BeamBlock beams;
  DampedSolids damped_solids;  // in proportion to stiffness
  DampedShells damped_shells;
  DampedBeams damped_beams;

  /// visit(block of a, same block of b), for each block of every family.
  template <class Visit>
  static void visit_pairs(ElementBlocks& a, ElementBlocks& b, const Visit& visit) {
    const auto visit_tuple = [&](auto& of_a, auto& of_b) {
      std::apply([&](auto&... block_a) { std::apply([&](auto&... block_b) { (visit(block_a, block_b), ...); }, of_b); },
                 of_a);
    };
    visit_tuple(a.hexahedra, b.hexahedra);
    visit_tuple(a.tetrahedra, b.tetrahedra);
    visit_tuple(a.one_point, b.one_point);
    visit_tuple(a.shells, b.shells);
    visit(a.beams, b.beams);
    visit(a.damped_solids, b.damped_solids);
    visit(a.damped_shells, b.damped_shells);
    visit(a.damped_beams, b.damped_beams);
  }
};

}  // namespace percuss
