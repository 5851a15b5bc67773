#pragma once
// The materials as an element sees them: what they remember at its points, and how their stress is advanced.

#include "kernels/element/modes.hpp"
#include "kernels/material/called_material.hpp"
#include "kernels/material/j2_plasticity.hpp"

namespace percuss {

/// What a material remembers at the points of an element: scalar i of point p is value[i][p]; no room for nothing.
template <class T, class Material, int Points, int Count = Material::history_count>
struct MaterialHistory {
  T value[Count][Points];
  PERCUSS_FORCE_INLINE void load(int p, T* point, int count = Count) const {
    for (int i = 0; i < count; ++i) point[i] = value[i][p];
  }
  PERCUSS_FORCE_INLINE void store(int p, const T* point, int count = Count) {
    for (int i = 0; i < count; ++i) value[i][p] = point[i];
  }
};
template <class T, class Material, int Points>
struct MaterialHistory<T, Material, Points, 0> {
  PERCUSS_FORCE_INLINE void load(int, T*) const {}
  PERCUSS_FORCE_INLINE void store(int, const T*) {}
};

/// Elastic moduli: one number for all lanes, or one by lane.
template <class S>
struct Moduli {
  S lambda, mu;
};

/// What a called material returns.
template <class T>
struct CalledResponse : PlasticReturn<T> {
  Moduli<T> moduli;
};

template <class Material>
inline constexpr bool is_called = std::is_same_v<Material, CalledMaterial>;

/// Whether the state can change although the element rests.
template <class Material>
KOKKOS_INLINE_FUNCTION bool changes_at_rest(const Material& material) {
  if constexpr (is_called<Material>) return material.changes_at_rest;
  return false;
}

/// lambda + 2 mu of a called material at n, of which bulk viscosity takes the wave speed: of the stiffest point.
template <class T, class History>
PERCUSS_FORCE_INLINE T find_longitudinal_modulus(const History& history) {
  T largest = history.value[0][0];
  for (const T& modulus : history.value[0]) largest = larger(largest, modulus);
  return largest;
}

/// Advances the stress of a point; returns a CalledResponse, or a PlasticReturn if the material can yield, and nothing
/// to speak of otherwise.
template <class T, class Material, int Points>
PERCUSS_FORCE_INLINE auto update_stress(const Material& material, Symmetric3<T>& stress,
                                        MaterialHistory<T, Material, Points>& history, int point,
                                        const PointMotion<T>& motion) {
  T here[Material::history_count > 0 ? Material::history_count : 1];
  if constexpr (is_called<Material>) {
    const int count = material.count_history();
    history.load(point, here, count);
    PointStep<T> step{motion, stress, here};
    material.update(step);
    history.store(point, here, count);
    stress = step.stress;
    return CalledResponse<T>{step.plastic, {step.lambda, step.mu}};
  } else {
    history.load(point, here);
    if constexpr (Material::can_yield) {
      const PlasticReturn<T> plastic = material.update(stress, here, motion.de);
      history.store(point, here);
      return plastic;
    } else {
      material.update(stress, here, motion.de);
      history.store(point, here);
      return false;
    }
  }
}

/// The moduli that bound the next step.
template <class Parameters, class Response>
PERCUSS_FORCE_INLINE auto find_moduli(const Parameters& par, [[maybe_unused]] const Response& response) {
  if constexpr (is_called<decltype(par.material)>) {
    return response.moduli;
  } else {
    return Moduli<double>{par.lambda, par.mu};
  }
}

}  // namespace percuss
