#pragma once
// Elements as a linear operator on velocities: what stiffness and damping, as they are at n, answer to a small motion.
//
// For the largest eigenvalue that limits the step (theory.md, section 1): A(h) = h^2 K / 4 + h C / 2 with a trial step
// h. K is that of the elastic moduli on the geometry of n, without stress; C that of the viscosities, linearised about
// the rate of n. Both are symmetric. Plastic flow only softens K.

#include "kernels/element/hex8/thick_shell.hpp"
#include "kernels/element/internal_force.hpp"

namespace percuss {

/// The motion that the operator is applied to.
struct ElasticProbe {
  Rows3<const double> x;  // positions at n
  Rows3<const double> u;  // any velocities
  double step = 0;        // h
  double coarse = 0;      // chunks whose step bound is above this count with that bound instead of their stiffness
};

/// fields.slot_force: out, minus the chunks' share of A(h) u; state and results: in, of the evaluation at n. Where
/// `coarse` allows it a chunk counts as (h / bound)^2 m u, which is an upper bound of its A(h).
void apply_elastic_operator(const ExecSpace& space, const ElementChunks& chunks, const HexBlocks& blocks,
                            const ElasticProbe& probe, const ChunkFields& fields);

/// What an element brings along besides its geometry.
template <class T>
struct ProbedElement {
  T mass;
  T viscous_pressure;                                         // q at n
  T step;                                                     // h
  Symmetric3<T> stretch{T(1), T(1), T(1), T(0), T(0), T(0)};  // V at n
  T pressure{T(0)};                                           // largest of a direction, at n
};

/// Moduli at the current volume; for a material that yields, those of the start.
template <class T, class Material>
PERCUSS_FORCE_INLINE Moduli<T> find_probed_moduli(const SolidParameters<Material>& par,
                                                  const ProbedElement<T>& element) {
  if constexpr (is_elastic<Material>) {
    return find_elastic_moduli(par.material.moduli(), element.pressure, T(1) / determinant(full(element.stretch)));
  } else {
    return {number<T>(par.lambda), number<T>(par.mu)};
  }
}

/// |dq / d(tr D)| from q itself: with compression c > 0, q / (rho l) = b2^2 l c^2 + b1 c_d c, and the tangent is
/// rho l (b1 c_d + 2 b2^2 l c) = rho l sqrt((b1 c_d)^2 + 4 b2^2 q / rho).
template <class T>
PERCUSS_FORCE_INLINE T find_viscous_tangent(const BulkViscosity& b, const T& density, const T& length, const T& speed,
                                            const T& pressure) {
  const T linear = number<T>(b.linear) * speed;
  const T quadratic = number<T>(4 * b.quadratic * b.quadratic) * larger(pressure, T(0)) * (T(1) / density);
  return density * length * square_root(linear * linear + quadratic);
}

/// h^2/4 K + h/2 C of the hourglass control on the rates u, on the geometry a, b; spatial frame.
template <HexKind Kind, class T, class Material>
PERCUSS_FORCE_INLINE HourglassModes<T> probe_hourglass(const SolidParameters<Material>& par, const VectorModes<T>& a,
                                                       const VolumeGradient<T>& b, const T& gradient_square,
                                                       const ProbedElement<T>& element, const HourglassModes<T>& u) {
  const T elastic = number<T>(0.25) * element.step * element.step;
  HourglassModes<T> q;
  if constexpr (Kind == HexKind::assumed_strain) {
    const PlateModuli moduli = find_plate_moduli({par.lambda, par.mu});
    T guard(0);
    if constexpr (!Material::can_yield) {
      const StartShape<T> start = find_start_shape(a, element.stretch, b.volume);
      q = find_assumed_strain_response(moduli, start.axes, start.volume, u).force;
    } else {
      q = find_assumed_strain_response(moduli, find_element_axes(a), b.volume, u).force;
      guard = find_guard(a, b) *
              find_hourglass_stiffness(gradient_square, b.volume, par.mu, PlasticHourglass<T>::guard_coefficient);
    }
    for (int h = 0; h < 4; ++h) q.mode[h] = elastic * (q.mode[h] + guard * u.mode[h]);
  } else {
    T share(0);
    if constexpr (Kind == HexKind::stiffness) {
      share = elastic * find_hourglass_stiffness(gradient_square, b.volume, par.mu, par.hourglass);
    } else {
      share = number<T>(0.5) * element.step *
              find_hourglass_viscosity(gradient_square, b.volume, element.mass, par.mu, par.hourglass);
    }
    for (int h = 0; h < 4; ++h) q.mode[h] = share * u.mode[h];
  }
  return q;
}

/// Deviatoric forces of the 2x2x2 points: modes of 2 mu times the rate of shear times `elastic`, 512 times. With h^2/4
/// it is A(h) u without its volumetric part.
template <class T>
PERCUSS_FORCE_INLINE VectorModes<T> probe_points(const T& mu, const VectorModes<T>& a, const VectorModes<T>& u,
                                                 const T& elastic) {
  const T third = number<T>(1.0 / 3.0), shear = T(2) * mu * elastic;
  VectorModes<T> force;
  for (int m = 1; m <= 7; ++m) force[m] = {T(0), T(0), T(0)};
  for (int p = 0; p < 8; ++p) {
    const GaussPoint at = find_gauss_point(p);
    const PointGeometry<T> point = find_point_geometry(a, at);
    const Symmetric3<T> d = symmetric_part(find_point_gradient(point, at, u, identity_matrix<T>()));
    const T mean = third * trace(d);
    add_point_force(shear * (d + Symmetric3<T>{-mean, -mean, -mean, T(0), T(0), T(0)}), point, at, force);
  }
  return force;
}

/// A(h) u of one element, or a pack of them. a, u: modes of x(n) and of the velocities.
template <HexKind Kind, class T, class Material>
PERCUSS_FORCE_INLINE void probe_hex8(const SolidParameters<Material>& par, const VectorModes<T>& a,
                                     const VectorModes<T>& u, const ProbedElement<T>& element,
                                     const CornerForces<T>& out) {
  const VolumeGradient<T> b = find_volume_gradient(a);
  const GradientSize<T> size = find_gradient_size(b);
  const T density = element.mass * (T(1) / b.volume);
  const T speed = square_root(number<T>(par.lambda + 2 * par.mu) * (T(1) / density));
  const T elastic = number<T>(0.25) * element.step * element.step;
  const Moduli<T> moduli = find_probed_moduli(par, element);
  const Matrix3<T> l = find_velocity_gradient(u, b);
  const Symmetric3<T> d = symmetric_part(l);
  const T viscous =
      number<T>(0.5) * element.step *
      find_viscous_tangent(par.viscosity, density, find_thickness(size, b.volume), speed, element.viscous_pressure);
  if constexpr (Kind == HexKind::full) {
    const T bulk = (moduli.lambda + number<T>(2.0 / 3.0) * moduli.mu) * elastic + viscous;
    find_full_forces(probe_points(moduli.mu, a, u, elastic), identity_matrix<T>(), bulk * trace(d), b, out);
  } else if constexpr (is_thick<Kind>) {
    const Moduli<T> probed{elastic * moduli.lambda, elastic * moduli.mu};
    find_full_forces(probe_columns<layers_of<Kind>>(probed, a, u), identity_matrix<T>(), viscous * trace(d), b, out);
  } else {
    const T pressure = (moduli.lambda * elastic + viscous) * trace(d);
    const Symmetric3<T> t =
        (T(2) * moduli.mu * elastic) * d + Symmetric3<T>{pressure, pressure, pressure, T(0), T(0), T(0)};
    const HourglassModes<T> q = probe_hourglass<Kind>(par, a, b, size.trace, element, find_hourglass_rates(u, a, l));
    find_corner_forces(t, q, a, b, out);
  }
}

}  // namespace percuss
