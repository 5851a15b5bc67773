#pragma once
// Results of the plastic return of a step for the rest of the element.

#include "kernels/core/simd.hpp"

namespace percuss {

/// Result of `update` of a material that can yield. Hourglass forces, which stand for stresses off the element's point,
/// relax with them.
template <class T>
struct PlasticReturn {
  T share;        // of the trial deviator that the return leaves; 1: the step was elastic
  T flow_stress;  // uniaxial yield stress after the step
  T loading;      // (von Mises stress / flow stress)^2 after the return, at most 1
};

}  // namespace percuss
