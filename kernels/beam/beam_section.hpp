#pragma once
// Cross sections of beams: areas, moments and torsion constants.
//
// Local axes: e1 along the beam, y along e2, z along e3. inertia_y is the integral of z^2 (bending about e2), inertia_z
// that of y^2.

#include <cmath>
#include <numbers>

namespace percuss {

struct BeamSection {
  double area = 0;                            // A
  double inertia_y = 0, inertia_z = 0;        // of bending about e2 and e3
  double torsion = 0;                         // J of Saint-Venant
  double shear_area_y = 0, shear_area_z = 0;  // A times the shear factor, for shear along e2 and e3
  double polar_inertia = 0;                   // that turns about the beam; 0: the sum of both inertias
};

/// A solid circle: shear factor 9/10 (Timoshenko).
inline BeamSection make_round(double radius) {
  const double square = radius * radius, area = std::numbers::pi * square;
  return {area, area * square / 4, area * square / 4, area * square / 2, 0.9 * area, 0.9 * area};
}

/// A circular tube: shear factor 1/2, that of a thin wall.
inline BeamSection make_tube(double outer_radius, double inner_radius) {
  const double a = outer_radius * outer_radius, b = inner_radius * inner_radius;
  const double area = std::numbers::pi * (a - b), square = a + b;
  return {area, area * square / 4, area * square / 4, area * square / 2, 0.5 * area, 0.5 * area};
}

/// A solid rectangle: shear factor 5/6. J from Roark's Formulas for Stress and Strain, table of torsion, within 0.4 %.
inline BeamSection make_rectangle(double width_y, double width_z) {
  const double a = std::fmax(width_y, width_z), b = std::fmin(width_y, width_z), q = b / a;
  const double area = a * b, torsion = a * b * b * b * (1.0 / 3 - 0.21 * q * (1 - q * q * q * q / 12));
  return {area, area * width_z * width_z / 12, area * width_y * width_y / 12, torsion, area * 5 / 6, area * 5 / 6};
}

/// A box with walls of one thickness: shear in the two walls along it, J of Bredt for a thin wall.
inline BeamSection make_box(double width_y, double width_z, double wall) {
  const double inner_y = width_y - 2 * wall, inner_z = width_z - 2 * wall;
  const auto cube = [](double x) { return x * x * x; };
  const double middle_y = width_y - wall, middle_z = width_z - wall;
  return {width_y * width_z - inner_y * inner_z,
          (width_y * cube(width_z) - inner_y * cube(inner_z)) / 12,
          (width_z * cube(width_y) - inner_z * cube(inner_y)) / 12,
          2 * wall * middle_y * middle_y * middle_z * middle_z / (middle_y + middle_z),
          2 * wall * middle_y,
          2 * wall * middle_z};
}

/// A symmetric I: flanges along y at both ends of a web along z. Shear along y in the flanges, each a rectangle, along
/// z in the web over the whole depth; J of thin walls; no stiffness against warping.
inline BeamSection make_i_shape(double width, double depth, double flange, double web) {
  const auto cube = [](double x) { return x * x * x; };
  const double high = depth - 2 * flange;
  return {2 * width * flange + web * high,
          (width * cube(depth) - (width - web) * cube(high)) / 12,
          (2 * flange * cube(width) + high * cube(web)) / 12,
          (2 * width * cube(flange) + (depth - flange) * cube(web)) / 3,
          2 * width * flange * 5 / 6,
          web * depth};
}

}  // namespace percuss
