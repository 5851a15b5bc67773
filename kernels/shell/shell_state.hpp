#pragma once
// What a shell element remembers between steps, but for its points.

namespace percuss {

/// State of an element, or a pack of elements. Stress xx, yy, xy and history, point after point from bottom to top,
/// follow it in the record.
template <class T>
struct ShellState {
  T mass;             // constant
  T gyration_square;  // rotary inertia over mass, constant
  T thickness;        // at n
  T shear[2];         // transverse shear stress xz, yz, at n
  // Forces on these rates, at n. A triangle has no hourglass modes of the membrane: there its corners' drilling beyond
  // the mean has their place.
  T membrane_hourglass[2], bending_hourglass[2], shear_hourglass[2];
  T drilling;  // moment on the mean rate of drilling, at n
};

}  // namespace percuss
