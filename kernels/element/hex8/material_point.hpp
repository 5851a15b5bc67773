#pragma once
// The materials as an element sees them: their history at its points, and the update of their stress.

#include "kernels/core/widen.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/hex8/modes.hpp"
#include "kernels/material/laws/called_material.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"

namespace percuss {

/// History of a material at the points of an element: scalar i of point p is value[i][p]; empty if there is none. In
/// single precision the remainders of the `count` scalars follow them.
template <class T, class Material, int Points, int Count = Material::history_count>
struct MaterialHistory {
  T value[is_short<T> ? 2 * Count : Count][Points];
  PERCUSS_FORCE_INLINE void load(int p, T* point, int count = Count) const {
    for (int i = 0; i < count; ++i) point[i] = value[i][p];
  }
  PERCUSS_FORCE_INLINE void store(int p, const T* point, int count = Count) {
    for (int i = 0; i < count; ++i) value[i][p] = point[i];
  }
};
template <class T, class Material, int Points>
struct MaterialHistory<T, Material, Points, 0> {
  PERCUSS_FORCE_INLINE void load(int, T*, int = 0) const {}
  PERCUSS_FORCE_INLINE void store(int, const T*, int = 0) {}
};

/// Rests of the stresses of an element's points, in float.
template <class T, int Points>
struct StressRests {
  Symmetric3<T> point[Points];
  PERCUSS_FORCE_INLINE Symmetric3<T>& operator[](int p) { return point[p]; }
};
template <class T>
struct NoStressRests {
  PERCUSS_FORCE_INLINE NoStressRests& operator[](int) { return *this; }
};
template <class T, int Points>
using StressRestsOf = std::conditional_t<is_short<T>, StressRests<T, Points>, NoStressRests<T>>;

/// What a called material returns.
template <class T>
struct CalledResponse : PlasticReturn<T> {
  Moduli<T> moduli;
};

/// What an elastic material returns.
template <class T>
struct ElasticResponse {
  Moduli<T> moduli;
};

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

/// V / V(0) of an element with a called material and the volume now: mass that was added is not its material's.
template <class T, class Parameters, class State>
PERCUSS_FORCE_INLINE T find_volume_ratio(const Parameters& par, const State& state, const T& volume) {
  const CalledMaterial& material = par.material;
  const T own_mass = material.is_scaled ? state.history.value[material.find_mass_place()][0] : state.mass;
  return number<T>(material.density) * volume / own_mass;
}

/// A tensor as the sum of value and rest, part of its lanes in double, and back.
template <int Part, class T>
PERCUSS_FORCE_INLINE Wide<T> widen_sum(const T& value, const T& rest) {
  return widen<Part>(value) + widen<Part>(rest);
}
template <class T>
PERCUSS_FORCE_INLINE void narrow_sum(const Wide<T> (&parts)[wide_count<T>], T& value, T& rest) {
  narrow(parts, value);
  Wide<T> left[wide_count<T>];
  visit_parts<T>([&](auto part) { left[part] = parts[part] - widen<part>(value); });
  narrow(left, rest);
}
template <int Part, class T>
PERCUSS_FORCE_INLINE Symmetric3<Wide<T>> widen_tensor(const Symmetric3<T>& a) {
  return {widen<Part>(a.xx), widen<Part>(a.yy), widen<Part>(a.zz),
          widen<Part>(a.xy), widen<Part>(a.yz), widen<Part>(a.zx)};
}

/// Input of a called material, part of its lanes in double.
template <int Part, class T>
PERCUSS_FORCE_INLINE PointMotion<Wide<T>> widen_motion(const PointMotion<T>& m) {
  PointMotion<Wide<T>> wide{widen_tensor<Part>(m.de), widen<Part>(m.dt),        widen<Part>(m.volume_ratio),
                            widen<Part>(m.length),    widen<Part>(m.viscosity), m.time};
  wide.change = {widen<Part>(m.change.growth), widen<Part>(m.change.inverse)};
  wide.is_apart = m.is_apart;
  wide.spin = {widen<Part>(m.spin.x), widen<Part>(m.spin.y), widen<Part>(m.spin.z)};
  return wide;
}

/// A called material works in double for any precision of the element: its powers and logarithms cost more than the
/// conversion to double and back.
template <class T, class Material, int Points>
PERCUSS_FORCE_INLINE CalledResponse<T> call_in_double(const Material& material, Symmetric3<T>& stress,
                                                      Symmetric3<T>& rest,
                                                      MaterialHistory<T, Material, Points>& history, int point,
                                                      const PointMotion<T>& motion) {
  constexpr int parts = wide_count<T>;
  const int count = material.count_history();
  Wide<T> here[parts][Material::history_count], s[6][parts], out[5][parts];
  visit_parts<T>([&](auto part) {
    for (int i = 0; i < count; ++i)
      here[part][i] = widen_sum<part>(history.value[i][point], history.value[count + i][point]);
    PointStep<Wide<T>> step{widen_motion<part>(motion), widen_tensor<part>(stress), here[part]};
    const Symmetric3<Wide<T>> left = widen_tensor<part>(rest);
    step.stress = step.stress + left;
    material.update(step);
    const auto& t = step.stress;
    s[0][part] = t.xx, s[1][part] = t.yy, s[2][part] = t.zz, s[3][part] = t.xy, s[4][part] = t.yz, s[5][part] = t.zx;
    out[0][part] = step.plastic.share;
    out[1][part] = smaller(step.plastic.flow_stress, Wide<T>(beyond_all<T>));
    out[2][part] = step.plastic.loading;
    out[3][part] = step.lambda;
    out[4][part] = step.mu;
  });
  for (int i = 0; i < count; ++i) {
    Wide<T> value[parts];
    for (int part = 0; part < parts; ++part) value[part] = here[part][i];
    narrow_sum(value, history.value[i][point], history.value[count + i][point]);
  }
  T* const values[6] = {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.yz, &stress.zx};
  T* const rests[6] = {&rest.xx, &rest.yy, &rest.zz, &rest.xy, &rest.yz, &rest.zx};
  for (int k = 0; k < 6; ++k) narrow_sum(s[k], *values[k], *rests[k]);
  T narrowed[5];
  for (int k = 0; k < 5; ++k) narrow(out[k], narrowed[k]);
  return {{narrowed[0], narrowed[1], narrowed[2]}, {narrowed[3], narrowed[4]}};
}

/// Advances the stress of an elastic point, and the digits that a float does not hold.
template <class T, class Rest>
PERCUSS_FORCE_INLINE ElasticResponse<T> update_elastic_stress(const Elastic& material, Symmetric3<T>& stress,
                                                              [[maybe_unused]] Rest& rest,
                                                              const PointMotion<T>& motion) {
  const Symmetric3<T> more = find_cauchy_increment(material.moduli(), stress, motion.de, motion.change);
  if constexpr (is_short<T>)
    add_to(stress, rest, more);
  else
    stress = stress + more;
  return {find_elastic_moduli(material.moduli(), bound_pressure(stress), motion.change.inverse)};
}

/// Advances the stress of a point; returns a CalledResponse or an ElasticResponse, or a PlasticReturn if the material
/// can yield. rest: of the stress, in float; nothing else.
template <class T, class Material, int Points, class Rest>
PERCUSS_FORCE_INLINE auto update_stress(const Material& material, Symmetric3<T>& stress, [[maybe_unused]] Rest& rest,
                                        MaterialHistory<T, Material, Points>& history, int point,
                                        const PointMotion<T>& motion) {
  constexpr int most = Material::history_count > 0 ? Material::history_count : 1;
  if constexpr (is_called<Material> && is_short<T>) {
    return call_in_double(material, stress, rest, history, point, motion);
  } else if constexpr (is_called<Material>) {
    T here[most];
    const int count = material.count_history();
    history.load(point, here, count);
    PointStep<T> step{motion, stress, here};
    material.update(step);
    history.store(point, here, count);
    stress = step.stress;
    return CalledResponse<T>{step.plastic, {step.lambda, step.mu}};
  } else if constexpr (is_elastic<Material>) {
    return update_elastic_stress(material, stress, rest, motion);
  } else {
    T here[is_short<T> ? 2 * most : most];
    constexpr int count = is_short<T> ? 2 * Material::history_count : Material::history_count;
    const auto update = [&] {
      if constexpr (is_short<T>)
        return material.update(stress, rest, here, motion.de);
      else
        return material.update(stress, here, motion.de);
    };
    history.load(point, here, count);
    const PlasticReturn<T> plastic = update();
    history.store(point, here, count);
    return plastic;
  }
}

/// The moduli that bound the next step.
template <class Parameters, class Response>
PERCUSS_FORCE_INLINE auto find_moduli(const Parameters& par, [[maybe_unused]] const Response& response) {
  if constexpr (has_own_moduli<decltype(par.material)>) {
    return response.moduli;
  } else {
    return Moduli<double>{par.lambda, par.mu};
  }
}

}  // namespace percuss
