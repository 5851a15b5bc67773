#pragma once
// One call for the laws that elements compile in and for those that they call.

#include "kernels/core/simd.hpp"
#include "kernels/material/point_step.hpp"

namespace percuss {

template <class Material>
inline constexpr bool is_compiled_in = requires {
  requires Material::is_compiled_in;
};

/// Advances a point by one law; the function that each is compiled as. Returns nothing but through `step`.
template <class T, class Law>
PERCUSS_NO_INLINE void advance_point(const Law& law, PointStep<T>& step) {
  if constexpr (!is_compiled_in<Law>) {
    law.update(step);
  } else if constexpr (Law::can_yield) {
    step.plastic = law.update(step.stress, step.history, step.motion.de);
  } else {
    law.update(step.stress, step.history, step.motion.de);
  }
}

}  // namespace percuss
