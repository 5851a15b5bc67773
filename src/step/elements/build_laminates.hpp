#pragma once
// Laminates of shells as kernels hold them. Internal to build_shells.

#include <optional>
#include <string>
#include <vector>

#include "kernels/shell/laminate.hpp"
#include "kernels/shell/shell_geometry.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// The layers of a laminate and their places across the thickness.
struct Laminate {
  LaminateLayer layer;
  ThicknessPoints rule;
  bool can_yield = false, can_fail = false;  // whether any ply can
};

/// points: of each ply; 0: as many as the default gives.
Laminate make_laminate(const MaterialDeck& material, int points);

/// Why shells cannot have these plies: the reason in words; empty: they can.
std::string find_laminate_fault(const MaterialDeck& material);

/// The reference axis that the materials of a laminate give [any length, in space at time 0]: that of the part's
/// material, or else of the first ply that has axes; none: the side of each shell from its first corner to its
/// second.
std::optional<Vector3<double>> find_given_axis(const MaterialDeck& material);

/// Cosine and sine of the reference axis of a laminate against the first axis of a shell's frame; both 0 where the axis
/// is normal to it. corners: of the shell, in space.
PlaneDirection<double> find_reference_axis(const std::optional<Vector3<double>>& given,
                                           const Vector3<double> (&corners)[4], const Matrix3<double>& frame);

}  // namespace percuss
