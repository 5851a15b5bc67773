#pragma once
// Strains at the points of a thick shell, and forces of their stresses: the points above one another are a column.
//
// zeta runs across the thickness, from corners 1 to 4 to corners 5 to 8. Strains are those of the element's coordinates
// E_kl = (d_k . v_l + d_l . v_k) / 2 with d_k = dx/dxi_k. Transverse shear is that of the middles of the edges (Dvorkin
// and Bathe 1984), strain across the thickness that of the four corners (Betsch and Stein 1995).

#include "kernels/element/hex8/gauss_points.hpp"

namespace percuss {

/// 64 times the strains of the element's coordinates that are assumed, by their share in 1, xi, eta and xi eta.
template <class T>
struct AssumedRates {
  T thickness[4];  // E_33
  T to_xi[2];      // 2 E_13, in 1 and eta
  T to_eta[2];     // 2 E_23, in 1 and xi
};

/// Assumed strain rates of the velocities v on the geometry a.
template <class T>
PERCUSS_FORCE_INLINE AssumedRates<T> find_assumed_rates(const VectorModes<T>& a, const VectorModes<T>& v) {
  const auto both = [&](int i, int j) { return dot(a[i], v[j]) + dot(a[j], v[i]); };
  return {{dot(a[3], v[3]) + dot(a[4], v[4]) + dot(a[5], v[5]) + dot(a[7], v[7]), both(3, 5) + both(4, 7),
           both(3, 4) + both(5, 7), both(3, 7) + both(4, 5)},
          {both(1, 3) + both(4, 6), both(1, 4) + both(3, 6)},
          {both(2, 3) + both(5, 6), both(2, 5) + both(3, 6)}};
}

/// What works on them: the transpose, added to 512 times the modes of the forces.
template <class T>
PERCUSS_FORCE_INLINE void add_assumed_forces(const VectorModes<T>& a, const AssumedRates<T>& s, VectorModes<T>& f) {
  const auto both = [&](int i, int j, const T& of) {
    f[i] = f[i] + of * a[j];
    f[j] = f[j] + of * a[i];
  };
  for (const int m : {3, 4, 5, 7}) f[m] = f[m] + s.thickness[0] * a[m];
  both(3, 5, s.thickness[1]);
  both(4, 7, s.thickness[1]);
  both(3, 4, s.thickness[2]);
  both(5, 7, s.thickness[2]);
  both(3, 7, s.thickness[3]);
  both(4, 5, s.thickness[3]);
  both(1, 3, s.to_xi[0]);
  both(4, 6, s.to_xi[0]);
  both(1, 4, s.to_xi[1]);
  both(3, 6, s.to_xi[1]);
  both(2, 3, s.to_eta[0]);
  both(5, 6, s.to_eta[0]);
  both(2, 5, s.to_eta[1]);
  both(3, 6, s.to_eta[1]);
}

/// The points above one another at xi, eta. A field's derivatives there are 1/8 of middle + zeta slope, by xi and eta,
/// and of `across`, by zeta.
template <class T>
struct ColumnField {
  Vector3<T> middle[2], slope[2], across;
  PERCUSS_FORCE_INLINE Vector3<T> get(int k, const T& zeta) const { return middle[k] + zeta * slope[k]; }
};
template <class T>
PERCUSS_FORCE_INLINE ColumnField<T> find_column(const VectorModes<T>& a, const GaussPoint& at) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta);
  return {{a[1] + eta * a[6], a[2] + xi * a[6]},
          {a[5] + eta * a[7], a[4] + xi * a[7]},
          a[3] + eta * a[4] + xi * (a[5] + eta * a[7])};
}

/// Geometry at a point of a column: g[k] = grad xi_k / 8, and 512 det J.
template <class T>
struct LayerGeometry {
  Vector3<T> d[2];  // of the column, by xi and eta
  Vector3<T> g[3];
  T volume;
};
template <class T>
PERCUSS_FORCE_INLINE LayerGeometry<T> find_layer_geometry(const ColumnField<T>& column, const T& zeta) {
  LayerGeometry<T> out{{column.get(0, zeta), column.get(1, zeta)}, {}, T(0)};
  const Vector3<T> c = cross(out.d[1], column.across);
  out.volume = dot(out.d[0], c);
  const T over = T(1) / out.volume;
  out.g[0] = over * c;
  out.g[1] = over * cross(column.across, out.d[0]);
  out.g[2] = over * cross(out.d[0], out.d[1]);
  return out;
}

/// The assumed strains of a column: 64 E_33, 64 E_13 and 64 E_23.
template <class T>
struct ColumnRates {
  T thickness, to_xi, to_eta;
};
template <class T>
PERCUSS_FORCE_INLINE ColumnRates<T> find_column_rates(const AssumedRates<T>& rates, const GaussPoint& at) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta), half = number<T>(0.5);
  return {rates.thickness[0] + xi * rates.thickness[1] + eta * (rates.thickness[2] + xi * rates.thickness[3]),
          half * (rates.to_xi[0] + eta * rates.to_xi[1]), half * (rates.to_eta[0] + xi * rates.to_eta[1])};
}

/// Rate of deformation at a point; w: of the velocities of its column.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> find_layer_rate(const LayerGeometry<T>& at, const ColumnField<T>& w, const T& zeta,
                                                   const ColumnRates<T>& assumed) {
  const Vector3<T> w0 = w.get(0, zeta), w1 = w.get(1, zeta);
  const T e00 = dot(at.d[0], w0), e11 = dot(at.d[1], w1), e01 = number<T>(0.5) * (dot(at.d[0], w1) + dot(at.d[1], w0));
  const Vector3<T> t0 = e00 * at.g[0] + e01 * at.g[1] + assumed.to_xi * at.g[2],
                   t1 = e01 * at.g[0] + e11 * at.g[1] + assumed.to_eta * at.g[2],
                   t2 = assumed.to_xi * at.g[0] + assumed.to_eta * at.g[1] + assumed.thickness * at.g[2];
  const auto sum = [&](auto of, auto other) {
    return of(t0) * other(at.g[0]) + of(t1) * other(at.g[1]) + of(t2) * other(at.g[2]);
  };
  const auto x = [](const Vector3<T>& u) { return u.x; };
  const auto y = [](const Vector3<T>& u) { return u.y; };
  const auto z = [](const Vector3<T>& u) { return u.z; };
  return {sum(x, x), sum(y, y), sum(z, z), sum(x, y), sum(y, z), sum(z, x)};
}

/// What the points of a column work on, 512 times.
template <class T>
struct ColumnForces {
  Vector3<T> middle[2], slope[2];
  T thickness, to_xi, to_eta;
};

/// Adds a stress that counts for so much of a volume, 512 times.
template <class T>
PERCUSS_FORCE_INLINE void add_layer(const Symmetric3<T>& stress, const LayerGeometry<T>& at, const T& zeta,
                                    const T& volume, ColumnForces<T>& f) {
  const Vector3<T> t0 = volume * (stress * at.g[0]), t1 = volume * (stress * at.g[1]), t2 = volume * (stress * at.g[2]);
  const T s01 = dot(at.g[0], t1);
  const Vector3<T> p[2] = {dot(at.g[0], t0) * at.d[0] + s01 * at.d[1], s01 * at.d[0] + dot(at.g[1], t1) * at.d[1]};
  for (int k = 0; k < 2; ++k) {
    f.middle[k] = f.middle[k] + p[k];
    f.slope[k] = f.slope[k] + zeta * p[k];
  }
  f.thickness = f.thickness + dot(at.g[2], t2);
  f.to_xi = f.to_xi + dot(at.g[0], t2);
  f.to_eta = f.to_eta + dot(at.g[1], t2);
}

/// Adds a column: to 512 times the modes of the forces, and to what works on assumed strains.
template <class T>
PERCUSS_FORCE_INLINE void add_column(const ColumnForces<T>& c, const GaussPoint& at, VectorModes<T>& f,
                                     AssumedRates<T>& assumed) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta);
  f[1] = f[1] + c.middle[0];
  f[2] = f[2] + c.middle[1];
  f[4] = f[4] + c.slope[1];
  f[5] = f[5] + c.slope[0];
  f[6] = f[6] + eta * c.middle[0] + xi * c.middle[1];
  f[7] = f[7] + eta * c.slope[0] + xi * c.slope[1];
  const T by_xi = xi * c.thickness;
  assumed.thickness[0] = assumed.thickness[0] + c.thickness;
  assumed.thickness[1] = assumed.thickness[1] + by_xi;
  assumed.thickness[2] = assumed.thickness[2] + eta * c.thickness;
  assumed.thickness[3] = assumed.thickness[3] + eta * by_xi;
  assumed.to_xi[0] = assumed.to_xi[0] + c.to_xi;
  assumed.to_xi[1] = assumed.to_xi[1] + eta * c.to_xi;
  assumed.to_eta[0] = assumed.to_eta[0] + c.to_eta;
  assumed.to_eta[1] = assumed.to_eta[1] + xi * c.to_eta;
}

template <class T>
PERCUSS_FORCE_INLINE ColumnForces<T> begin_column() {
  const Vector3<T> none{T(0), T(0), T(0)};
  return {{none, none}, {none, none}, T(0), T(0), T(0)};
}

/// Forces of the points of an element, 512 times, while they are added up.
template <class T>
struct ThickForces {
  VectorModes<T> modes;
  AssumedRates<T> assumed;

  PERCUSS_FORCE_INLINE ThickForces() : assumed{{T(0), T(0), T(0), T(0)}, {T(0), T(0)}, {T(0), T(0)}} {
    for (int m = 1; m <= 7; ++m) modes[m] = {T(0), T(0), T(0)};
  }
};

}  // namespace percuss
