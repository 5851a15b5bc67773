#pragma once
// The kinds of hexahedra, and where their records hold what. Apart from the element itself, so that who reads records
// need not compile it.

#include <type_traits>

#include "kernels/core/common_record.hpp"
#include "kernels/core/precision.hpp"

namespace percuss {

struct CalledMaterial;
struct Elastic;

/// What is compiled for each material: the one-point element with one of three hourglass controls, 2x2x2 points, or a
/// thick shell of three or five points across its thickness.
enum class HexKind { assumed_strain, stiffness, viscous, full, thick3, thick5 };

/// Points across the thickness of a thick shell; 0: it is none.
template <HexKind Kind>
inline constexpr int layers_of = Kind == HexKind::thick3   ? 3
                                 : Kind == HexKind::thick5 ? 5
                                                           : 0;
template <HexKind Kind>
inline constexpr bool is_thick = layers_of<Kind> > 0;

template <class Material>
inline constexpr bool is_elastic = std::is_same_v<Material, Elastic>;

/// Whether the moduli change, lane by lane.
template <class Material>
inline constexpr bool has_own_moduli = std::is_same_v<Material, CalledMaterial> || is_elastic<Material>;

template <class Material>
inline constexpr bool is_called = std::is_same_v<Material, CalledMaterial>;

/// Whether an element has room for the volumes of its points at the start.
template <class Material, HexKind Kind>
inline constexpr bool keeps_point_volumes = (Kind == HexKind::full) && has_own_moduli<Material>;

/// Points with stress and history of their own.
template <HexKind Kind>
inline constexpr int hex_points = Kind == HexKind::full ? 8
                                  : is_thick<Kind>      ? 4 * layers_of<Kind>
                                                        : 1;

/// Where things lie in a record, in scalars of one lane: those of SolidRecord with stress (6) by point, then hourglass
/// forces (12), in float the rests of the stress, the volumes of the points (of 2x2x2 at the start, of thick shells
/// now), what columns of thick shells lacked (4) if their law yields, then history: scalar i of point p at history +
/// points i + p, in float followed by its rests.
struct HexRecord : SolidRecord {
  template <HexKind Kind>
  static constexpr bool keeps_hourglass = Kind == HexKind::assumed_strain || Kind == HexKind::stiffness;
  template <HexKind Kind>
  static constexpr int point_volumes = stress + 6 * hex_points<Kind>*(1 + rest) + (keeps_hourglass<Kind> ? 12 : 0);
  template <HexKind Kind, class Material>
  static constexpr bool keeps_volumes = keeps_point_volumes<Material, Kind> ||
                                        (is_thick<Kind> && has_own_moduli<Material>);
  template <HexKind Kind, class Material>
  static constexpr int history = point_volumes<Kind> + (keeps_volumes<Kind, Material> ? hex_points<Kind> : 0) +
                                 (is_thick<Kind> && Material::can_yield ? 4 : 0);

  /// Scalars that a record holds if its points have so many history variables.
  template <HexKind Kind, class Material>
  static constexpr int find_size(int count) {
    return history<Kind, Material> + hex_points<Kind> * (1 + rest) * count;
  }
};

/// Scalars that one element's record holds, without and with one history variable: assumed strain and stiffness 35, 36;
/// viscous 23, 24; 2x2x2 points 73, 73. In float 50, 52; 38, 40; 130, 138.
template <class Material, HexKind Kind>
inline constexpr int hex_record_size = HexRecord::find_size<Kind, Material>(Material::history_count);

}  // namespace percuss
