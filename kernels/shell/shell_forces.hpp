#pragma once
// Corner forces and moments of a shell element: the transpose of shell_rates.hpp, term by term.

#include "kernels/shell/shell_rates.hpp"

namespace percuss {

/// Sets u to the corner shares of the forces on d/dx, d/dy and the hourglass part of a field.
template <class T>
PERCUSS_FORCE_INLINE void set_gradient_forces(const ShellGeometry<T>& g, const T& on_x, const T& on_y,
                                              const T& on_hourglass, T (&u)[4]) {
  const T h = T(0.25) * on_hourglass;
  const T x = on_x - h * g.hx, y = on_y - h * g.hy;
  const T r = g.b1[0] * x + g.b2[0] * y, s = g.b1[1] * x + g.b2[1] * y;
  u[0] = h - r;
  u[1] = -h - s;
  u[2] = h + r;
  u[3] = s - h;
}

/// Adds the forces of the four edges in shear. on_edge: force on the covariant shear of each.
template <class T>
PERCUSS_FORCE_INLINE void add_edge_forces(const ShellGeometry<T>& g, const T (&on_edge)[4], ShellCornerField<T>& f,
                                          ShellCornerField<T>& c) {
  const auto pull = [](const T& by, int i, int j, T(&u)[4]) {
    u[i] = u[i] - by;
    u[j] = u[j] + by;
  };
  const auto turn_both = [](const T& by, int i, int j, T(&u)[4]) {
    u[i] = u[i] + by;
    u[j] = u[j] + by;
  };
  for (int k = 0; k < 4; ++k) {
    const int i = find_shear_edge(k, 0), j = find_shear_edge(k, 1);
    const T quarter = T(0.25) * on_edge[k];
    pull(quarter * (g.px[i] + g.px[j]), i, j, f.x);
    pull(quarter * (g.py[i] + g.py[j]), i, j, f.y);
    pull(quarter * (g.pz[i] + g.pz[j]), i, j, f.z);
    turn_both(quarter * (g.x[j] - g.x[i]), i, j, c.x);
    turn_both(quarter * (g.y[j] - g.y[i]), i, j, c.y);
    turn_both(quarter * (T(find_warp_sign(j) - find_warp_sign(i)) * g.z), i, j, c.z);
  }
}

/// Takes the moment that is left over all corners out of the forces: the transpose of taking out the rigid spin.
template <class T>
PERCUSS_FORCE_INLINE void balance_moments(const ShellGeometry<T>& g, ShellCornerField<T>& f,
                                          const ShellCornerField<T>& m) {
  Vector3<T> left{T(0), T(0), T(0)};
  for (int i = 0; i < 4; ++i) {
    const Vector3<T> place{g.x[i], g.y[i], T(find_warp_sign(i)) * g.z};
    left = left + Vector3<T>{m.x[i], m.y[i], m.z[i]} + cross(place, Vector3<T>{f.x[i], f.y[i], f.z[i]});
  }
  const T half = T(0.5);
  const T x_r = half * left.z * g.b2[0], x_s = half * left.z * g.b2[1];
  const T y_r = -half * left.z * g.b1[0], y_s = -half * left.z * g.b1[1];
  const T z_r = left.y * g.b1[0] - left.x * g.b2[0], z_s = left.y * g.b1[1] - left.x * g.b2[1];
  const auto add = [](const T& r, const T& s, T(&u)[4]) {
    u[0] = u[0] - r;
    u[1] = u[1] - s;
    u[2] = u[2] + r;
    u[3] = u[3] + s;
  };
  add(x_r, x_s, f.x);
  add(y_r, y_s, f.y);
  add(z_r, z_s, f.z);
}

/// Forces and moments on the corners in space axes, from what does work on the rates: sum_I f_I . v_I + m_I . w_I is
/// the sum of products of `on` with find_shell_rates() of any motion; forces and moments add up to zero.
template <class T, class Shapes = Quadrilaterals>
PERCUSS_FORCE_INLINE void find_shell_forces(const ShellGeometry<T>& g, const ShellRates<T>& on, Vector3<T> (&force)[4],
                                            Vector3<T> (&moment)[4], const Shapes& shapes = {}) {
  ShellCornerField<T> f, c;
  set_gradient_forces(g, on.membrane[0], on.membrane[2], on.membrane_hourglass[0], f.x);
  set_gradient_forces(g, on.membrane[2], on.membrane[1], on.membrane_hourglass[1], f.y);
  set_gradient_forces(g, on.curvature[0], on.curvature[2], on.bending_hourglass[0], c.x);
  set_gradient_forces(g, on.curvature[2], on.curvature[1], on.bending_hourglass[1], c.y);
  for (int i = 0; i < 4; ++i) f.z[i] = c.z[i] = T(0);
  const EdgeSkew<T> skew = find_edge_skew(g, shapes);
  const T on_changes = on.shear_hourglass[0] + on.shear_hourglass[1];
  const T on_x = on.shear[0] - skew.x * on_changes, on_y = on.shear[1] - skew.y * on_changes;
  const T on_xi = g.xi_x * on_x + g.xi_y * on_y, on_eta = g.eta_x * on_x + g.eta_y * on_y;
  T on_edge[4];
  spread_to_edges({{on_xi, on_eta}, {on.shear_hourglass[0], on.shear_hourglass[1]}}, shapes, on_edge);
  add_edge_forces(g, on_edge, f, c);
  ShellCornerField<T> m;
  spread_drilling({on.drilling, {on.corner_drilling[0], on.corner_drilling[1]}}, shapes, m.z);
  for (int i = 0; i < 4; ++i) {
    m.x[i] = g.py[i] * c.z[i] - g.pz[i] * c.y[i];
    m.y[i] = g.pz[i] * c.x[i] - g.px[i] * c.z[i];
    m.z[i] = m.z[i] + (g.px[i] * c.y[i] - g.py[i] * c.x[i]);
  }
  balance_moments(g, f, m);
  for (int i = 0; i < 4; ++i) {
    force[i] = transpose_times(g.frame, Vector3<T>{f.x[i], f.y[i], f.z[i]});
    moment[i] = transpose_times(g.frame, Vector3<T>{m.x[i], m.y[i], m.z[i]});
  }
}

}  // namespace percuss
