#pragma once
// Yield of the element as a section: the stress of its centre and the stresses that its hourglass forces stand for,
// together.
//
// A plate of height h whose stress is sigma0 at mid-height and t at its surface, linear between, yields as a whole
// where
//   n^2 + m = 1,   n = sigma0 / Y,  m = t / (1.5 Y)
// with t along sigma0 (an ideally plastic rectangular section under axial force and moment), and at n^2 + m^2 = 1 with
// t across it in the space of deviators. With both parts, m_a along and m_c across, and summed over the plates,
//   F = n^2 + (m_c^2 + sqrt(m_c^4 + 4 m_a^2)) / 2 - 1.
// The trial beyond F = 0 returns along the normal, in the metric of elastic energy n^2 + (3/4) m^2: dn = 2 n L and
// dm = (4/3) dF/dm L, one step of Newton's method for L. Where the centre itself flows, and in
// near-inverted elements, it keeps what its own return left; Q is scaled by the share of that return and limited to the
// room of 1 - n^2.

#include "kernels/core/long_sum.hpp"
#include "kernels/element/hex8/assumed_strain.hpp"
#include "kernels/material/plastic_return.hpp"

namespace percuss {

/// Whether an element of the material yields as a section. Its flow stress must be that of J2 plasticity.
template <class Material>
KOKKOS_INLINE_FUNCTION constexpr bool bends_plastically() {
  if constexpr (requires { Material::bends_plastically; }) return Material::bends_plastically;
  return false;
}

/// Lower bound of 1 - n^2 in the limit of m, which keeps some resistance against hourglass modes.
inline constexpr double least_room = 0.1;

/// The stress of a plastic step at the centre, and what it leaves to bending.
template <class T>
struct SectionState {
  Symmetric3<T> deviator;  // Cauchy stress at the centre, spatial
  PlasticReturn<T> plastic;
  T guard;  // of find_guard()
};

/// What bending yields: factors of the parts of Q along and across the centre's stress, and of its deviator.
template <class T>
struct SectionYield {
  T along, across, centre;
  T returned;  // share of the part across that the return takes, without relaxation
  T strain;    // plastic, of bending, mean over the element, times 3 mu
};

/// Whether the section yields, of a trial Q. surface_stress_square: of find_surface_stress_square().
template <class T>
PERCUSS_FORCE_INLINE auto find_yielding(const PlasticReturn<T>& plastic, const T& surface_stress_square) {
  const T room = plastic.flow_stress * (T(1) - plastic.loading);
  return (number<T>(4.0 / 9) * surface_stress_square > room * room) || (plastic.share < T(1));
}

/// The return of the section from m_a = along, m_c^2 = across_square.
template <class T>
PERCUSS_FORCE_INLINE SectionYield<T> return_section(const SectionState<T>& state, const T& along,
                                                    const T& across_square) {
  const T one(1), nothing = number<T>(1e-12), share = state.plastic.share;
  const auto plain = (share < one) || (state.guard > T(0));
  SectionYield<T> out;
  const T left = share * along, after = share * share * across_square;
  // return to F = 0
  const T a = select(plain, T(0), left), c = select(plain, T(0), after);
  const T root = larger(square_root(c * c + T(4) * a * a), nothing);
  const T excess = larger(state.plastic.loading + number<T>(0.5) * (c + root) - one, T(0));
  const T slope_a = T(2) * a / root, slope_c = one + c / root;
  const T length = excess / (T(4) * share * state.plastic.loading +
                             number<T>(4.0 / 3) * (slope_a * slope_a + slope_c * slope_c * c) + number<T>(1e-9));
  const T reduced = larger(left - number<T>(4.0 / 3) * slope_a * length, T(0));
  const T across_return = one / (one + number<T>(4.0 / 3) * slope_c * length);
  out.centre = select(plain, one, one / (one + T(2) * length));
  // limit, as the normal of the trial leads past F = 0 only nearly
  const T loading = state.plastic.loading * out.centre * out.centre;
  const T room = larger(larger(one - loading, number<T>(least_room)), state.guard);
  const T limited = reduced * reduced + select(plain, one, room) * (across_return * across_return * after);
  const T limit = smaller(one, room / square_root(larger(limited, nothing)));
  const T remaining = limit * across_return;
  out.across = remaining * share;
  out.returned = select(plain, T(0), out.across * (one - remaining));  // no more than is left, however far the trial is
  out.along = larger(limit * reduced / larger(along, number<T>(1e-9)), state.guard * out.across);
  out.strain = number<T>(0.75) * state.plastic.flow_stress *
               (along * along * out.along * (one - out.along) + across_square * out.across * (one - out.across));
  out.strain = select(plain, T(0), out.strain);
  return out;
}

/// m_a of each plate, signed, times n.
template <class T>
struct SectionAlong {
  T plate[3];
  Vector3<T> traction[3];  // deviator times the axes
};

template <class T>
PERCUSS_FORCE_INLINE SectionAlong<T> find_section_along(const SectionState<T>& state, const VectorModes<T>& a,
                                                        const T& volume, const HourglassModes<T>& q) {
  SectionAlong<T> out;
  for (int k = 0; k < 3; ++k) out.traction[k] = state.deviator * a[1 + k];
  const T scale = T(3) / (volume * state.plastic.flow_stress * state.plastic.flow_stress);
  for (int i = 0; i < 3; ++i) {
    const Plate plate = find_plate(i);
    out.plate[i] = scale * (dot(q.mode[plate.first_mode], out.traction[plate.first]) +
                            dot(q.mode[plate.second_mode], out.traction[plate.second]));
  }
  return out;
}

/// The return of trial forces, plate by plate.
template <class T>
struct SectionReturn {
  const ElementAxes<T>& axes;
  const VectorModes<T>& a;
  const SectionAlong<T>& centre;
  const HourglassModes<T>& q;  // of the trial
  double poisson;
  T lost;   // share of the part across that is returned
  T scale;  // of the part along, over m_a times n
};

/// Adds to the forces of plate I what the part along the centre's stress differs by, as the plane stress with the
/// centre's deviator, and the trace that plane stress keeps of what is lost.
template <int I, class T>
PERCUSS_FORCE_INLINE void add_section_return(const SectionReturn<T>& to, HourglassModes<T>& out) {
  constexpr Plate plate = find_plate(I);
  const Vector3<T>&g1 = to.a[1 + plate.first], &g2 = to.a[1 + plate.second];
  const Vector3<T>&t1 = to.centre.traction[plate.first], &t2 = to.centre.traction[plate.second];
  const T m11 = to.axes.square[plate.first], m22 = to.axes.square[plate.second], m12 = to.axes.product[I];
  const T scale = T(1) / (m11 * m22 - m12 * m12);
  const T i11 = scale * m22, i22 = scale * m11, i12 = -(scale * m12);
  const T e11 = dot(g1, t1), e22 = dot(g2, t2), e12 = dot(g1, t2);
  const T w11 = i11 * e11 + i12 * e12, w12 = i11 * e12 + i12 * e22;
  const T w21 = i12 * e11 + i22 * e12, w22 = i12 * e12 + i22 * e22;
  const T along = to.scale * to.centre.plate[I];
  const T own = dot(to.q.mode[plate.first_mode], g1) + dot(to.q.mode[plate.second_mode], g2);
  const T trace = number<T>((1 - 2 * to.poisson) / (3 * (1 - to.poisson))) * to.lost * own +
                  number<T>(to.poisson / (1 - to.poisson)) * along * (w11 + w22);
  const T s11 = along * (w11 * i11 + w12 * i12) + trace * i11, s22 = along * (w21 * i12 + w22 * i22) + trace * i22,
          s12 = along * (w11 * i12 + w12 * i22) + trace * i12;
  Vector3<T>&q1 = out.mode[plate.first_mode], &q2 = out.mode[plate.second_mode];
  q1 = q1 + s11 * g1 + s12 * g2;
  q2 = q2 + s12 * g1 + s22 * g2;
}

/// The motion of a step that yields, and what is known of it.
template <class T>
struct SectionMotion {
  const VectorModes<T>&a, &v;  // of x(n+1) and v(n+1/2)
  T dt;
  T volume;                 // at n+1/2
  T surface_stress_square;  // of the trial
  T guard;
};

/// Takes from the centre what the section yields, of the lanes that yield.
template <class T, class Material, class State, class Lanes>
PERCUSS_FORCE_INLINE void yield_at_center(const Material& material, const PlasticReturn<T>& plastic,
                                          const SectionYield<T>& yield, const Lanes& lanes, State& state) {
  const T mean = number<T>(1.0 / 3.0) * trace(state.stress);
  const Symmetric3<T> deviator = state.stress + Symmetric3<T>{-mean, -mean, -mean, T(0), T(0), T(0)};
  const T lost = select(lanes, yield.centre - T(1), T(0));
  const T of_bending = select(lanes, yield.strain, T(0));
  const T strain =
      number<T>(1 / (3 * material.mu)) * (of_bending - lost * square_root(plastic.loading) * plastic.flow_stress);
  auto& history = state.history.value;
  if constexpr (is_short<T>) {
    add_where(lanes, state.stress, state.stress_rest[0], lost * deviator);
    add_where(lanes, history[0][0], history[1][0], strain);
  } else {
    state.stress = state.stress + lost * deviator;
    history[0][0] = history[0][0] + strain;
  }
}

/// The return of an element whose trial Q is state.hourglass. A call, so that the body of the element keeps its
/// registers where nothing yields; lanes that do not yield keep their bits.
template <class T, class Material, class State>
PERCUSS_NO_INLINE void yield_as_section(const Material& material, const PlasticReturn<T>& plastic,
                                        const SectionMotion<T>& motion, State& state) {
  const auto lanes = find_yielding(plastic, motion.surface_stress_square);
  const T half_dt = number<T>(0.5) * motion.dt, one(1);
  VectorModes<T> middle;
  for (int m = 1; m <= 3; ++m) middle[m] = motion.a[m] - half_dt * motion.v[m];
  const ElementAxes<T> axes = find_element_axes(middle);
  const T mean = number<T>(1.0 / 3.0) * trace(state.stress);
  const Symmetric3<T> deviator = state.stress + Symmetric3<T>{-mean, -mean, -mean, T(0), T(0), T(0)};
  const SectionState<T> section{push_forward(state.polar.rotation, deviator), plastic, motion.guard};
  HourglassModes<T>& q = state.hourglass;
  const SectionAlong<T> centre = find_section_along(section, motion.a, motion.volume, q);
  const T over = one / larger(plastic.loading, number<T>(1e-6));
  const T all = number<T>(4.0 / 9) * motion.surface_stress_square / (plastic.flow_stress * plastic.flow_stress);
  const T sum =
      centre.plate[0] * centre.plate[0] + centre.plate[1] * centre.plate[1] + centre.plate[2] * centre.plate[2];
  const T along_square = smaller(sum * over, all);
  const SectionYield<T> yield = return_section(section, square_root(along_square), larger(all - along_square, T(0)));
  HourglassModes<T> out;
  for (int h = 0; h < 4; ++h) out.mode[h] = yield.across * q.mode[h];
  const SectionReturn<T> to{axes,
                            motion.a,
                            centre,
                            q,
                            find_plate_moduli(material.moduli()).poisson,
                            yield.returned,
                            number<T>(0.5) * (yield.along - yield.across) * over * motion.volume};  // 1.5 V / 3
  add_section_return<0>(to, out);
  add_section_return<1>(to, out);
  add_section_return<2>(to, out);
  for (int h = 0; h < 4; ++h) {
    q.mode[h] = {select(lanes, out.mode[h].x, q.mode[h].x), select(lanes, out.mode[h].y, q.mode[h].y),
                 select(lanes, out.mode[h].z, q.mode[h].z)};
  }
  yield_at_center(material, plastic, yield, lanes, state);
}

}  // namespace percuss
