#pragma once
// How elements are integrated and stabilised: of the whole scene, and what a part has instead.

#include <optional>

namespace percuss {

struct ElementDeck {
  /// membrane: of the shells of a part.
  enum class Integration { one_point, full, thick_shell, membrane };
  enum class Hourglass { assumed_strain, stiffness, viscous };
  Integration integration = Integration::one_point;
  /// The direction of a hexahedron that crosses a thick shell: one by the order of its nodes, of which the third
  /// is from the first four to the others, or that in which it is shortest.
  enum class Across { first, second, third, shortest };
  Across across = Across::third;
  int thick_points = 0;                             // of thick shells across the thickness; 0: by the material
  Hourglass hourglass = Hourglass::assumed_strain;  // only with Integration::one_point
  double hourglass_coefficient = 0.05;              // not with Hourglass::assumed_strain
  /// Rates of tetrahedra, wedges and pyramids are averaged over their nodes, or each has its own, with which they lock.
  enum class Tetrahedra { mixed, plain };
  Tetrahedra tetrahedra = Tetrahedra::mixed;
  bool resist_folding = true;  // forces at corners of hexahedra that turn inside out
  bool skip_resting = true;    // leave chunks of elements alone that rest; no result depends on it
  double linear_viscosity = 0.06;
  double quadratic_viscosity = 1.2;
  double stiffness_damping = 0;  // stress per elastic modulus and rate of strain [time]
  double shell_hourglass = 1;    // share of the stiffness of shells against hourglass modes and drilling
};

/// Values of a part instead of the members of ElementDeck with the same names.
struct PartElementDeck {
  std::optional<ElementDeck::Integration> integration;
  std::optional<ElementDeck::Across> across;
  std::optional<int> thick_points;
  std::optional<ElementDeck::Hourglass> hourglass;
  std::optional<double> hourglass_coefficient, linear_viscosity, quadratic_viscosity, stiffness_damping,
      shell_hourglass;
};

/// The settings of a part.
inline ElementDeck find_settings(const ElementDeck& scene, const PartElementDeck& part) {
  ElementDeck settings = scene;
  settings.integration = part.integration.value_or(scene.integration);
  settings.across = part.across.value_or(scene.across);
  settings.thick_points = part.thick_points.value_or(scene.thick_points);
  settings.hourglass = part.hourglass.value_or(scene.hourglass);
  settings.hourglass_coefficient = part.hourglass_coefficient.value_or(scene.hourglass_coefficient);
  settings.linear_viscosity = part.linear_viscosity.value_or(scene.linear_viscosity);
  settings.quadratic_viscosity = part.quadratic_viscosity.value_or(scene.quadratic_viscosity);
  settings.stiffness_damping = part.stiffness_damping.value_or(scene.stiffness_damping);
  settings.shell_hourglass = part.shell_hourglass.value_or(scene.shell_hourglass);
  return settings;
}

}  // namespace percuss
