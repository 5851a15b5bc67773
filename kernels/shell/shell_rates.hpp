#pragma once
// Rates of a shell element from the motion of its corners, and the corner forces that are the exact transpose.
//
// Rotations move directors along the normals of the element's own corners. What turns about the normal moves no
// director: it has a stiffness of its own (drilling), without which a twisting moment could not pass the kink between
// two elements. The rigid spin is taken out of the rates, and by the transpose out of the forces: their moments sum to
// zero to round-off on warped elements too, which the plain one-point shell (Belytschko, Lin and Tsay 1984) does not
// keep. Transverse shear is sampled on the edges (Dvorkin and Bathe 1984; Hughes and Tezduyar 1981).

#include "kernels/shell/shell_geometry.hpp"

namespace percuss {

/// Rates of an element in its frame; or the forces that do work on them, integrated over the element.
template <class T>
struct ShellRates {
  T membrane[3];            // xx, yy, 2 xy
  T curvature[3];           // likewise: the rate of a layer is membrane + z curvature
  T shear[2];               // 2 xz, 2 yz
  T membrane_hourglass[2];  // of vx, vy
  T bending_hourglass[2];   // of the director's rates
  T shear_hourglass[2];     // part of the covariant shear that changes along eta, along xi, beyond a uniform shear's
  T drilling;               // mean rate of the corners about e3, against the spin of the element
  T corner_drilling[2];     // of a triangle: what its corners turn about e3 beyond that mean
};

/// The four edges whose shear is sampled, each along xi or eta: 1-2, 4-3, 1-4, 2-3.
KOKKOS_INLINE_FUNCTION constexpr int find_shear_edge(int k, int end) {
  constexpr int corners[4][2] = {{0, 1}, {3, 2}, {0, 3}, {1, 2}};
  return corners[k][end];
}

/// Corner fields in the frame, by component.
template <class T>
struct ShellCornerField {
  T x[4], y[4], z[4];
};

/// Velocity of the corners without the rigid motion of the element, and against it the rate of their directors and
/// what they turn about e3. velocity: differences in the frame; rotation: angular velocities in the frame.
template <class T>
PERCUSS_FORCE_INLINE void remove_rigid_motion(const ShellGeometry<T>& g, const ShellDifferences<T>& velocity,
                                              const Vector3<T> (&rotation)[4], ShellCornerField<T>& v,
                                              ShellCornerField<T>& beta, T (&drill)[4]) {
  const Vector3<T> v_x = g.b1[0] * velocity.r + g.b1[1] * velocity.s;
  const Vector3<T> v_y = g.b2[0] * velocity.r + g.b2[1] * velocity.s;
  const Vector3<T> w{v_y.z, -v_x.z, T(0.5) * (v_x.y - v_y.x)};
  find_corner_values(velocity.r.x, velocity.s.x, velocity.h.x, v.x);
  find_corner_values(velocity.r.y, velocity.s.y, velocity.h.y, v.y);
  const T warping = T(0.25) * (velocity.h.z - g.hx * v_x.z - g.hy * v_y.z);
  for (int i = 0; i < 4; ++i) {
    const T sign = T(find_warp_sign(i)), height = sign * g.z;
    v.x[i] = v.x[i] - (w.y * height - w.z * g.y[i]);
    v.y[i] = v.y[i] - (w.z * g.x[i] - w.x * height);
    v.z[i] = sign * warping;
    const Vector3<T> theta = rotation[i] - w;
    beta.x[i] = theta.y * g.pz[i] - theta.z * g.py[i];
    beta.y[i] = theta.z * g.px[i] - theta.x * g.pz[i];
    beta.z[i] = theta.x * g.py[i] - theta.y * g.px[i];
    drill[i] = theta.z;
  }
}

/// Covariant shear rate of an edge: that of the chord against the mean of the directors at its ends.
template <class T>
PERCUSS_FORCE_INLINE T find_edge_shear(const ShellGeometry<T>& g, const ShellCornerField<T>& v,
                                       const ShellCornerField<T>& beta, int i, int j) {
  const T rise = T(find_warp_sign(j) - find_warp_sign(i)) * g.z;
  return T(0.25) * ((v.x[j] - v.x[i]) * (g.px[i] + g.px[j]) + (v.y[j] - v.y[i]) * (g.py[i] + g.py[j]) +
                    (v.z[j] - v.z[i]) * (g.pz[i] + g.pz[j]) + (g.x[j] - g.x[i]) * (beta.x[i] + beta.x[j]) +
                    (g.y[j] - g.y[i]) * (beta.y[i] + beta.y[j]) + rise * (beta.z[i] + beta.z[j]));
}

/// Shear of the edges as the element takes it: its means along xi and eta, and how each changes across; of a triangle,
/// whose edges are 1-2, 1-4 and 2-3, that of its middle, with each edge's share in what turns around it taken out, and
/// what turns around it, halved.
template <class T>
struct EdgeShear {
  T along[2], change[2];
};

template <class T, class Shapes>
PERCUSS_FORCE_INLINE EdgeShear<T> join_edges(const T (&edge)[4], [[maybe_unused]] const Shapes& shapes) {
  const T half = T(0.5);
  EdgeShear<T> shear{{half * (edge[0] + edge[1]), half * (edge[2] + edge[3])},
                     {half * (edge[1] - edge[0]), half * (edge[3] - edge[2])}};
  if constexpr (Shapes::has_triangles) {
    const T around = edge[0] + edge[3] - edge[2];
    shear.along[0] = select(shapes.is_triangle, half * edge[0] - T(1.0 / 6.0) * around, shear.along[0]);
    shear.change[0] = select(shapes.is_triangle, around, shear.change[0]);
    shear.change[1] = select(shapes.is_triangle, T(0), shear.change[1]);
  }
  return shear;
}

/// Its transpose: forces on the edges.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE void spread_to_edges(const EdgeShear<T>& on, [[maybe_unused]] const Shapes& shapes,
                                          T (&on_edge)[4]) {
  const T half = T(0.5);
  for (int k = 0; k < 2; ++k) {
    on_edge[2 * k] = half * (on.along[k] - on.change[k]);
    on_edge[2 * k + 1] = half * (on.along[k] + on.change[k]);
  }
  if constexpr (Shapes::has_triangles) {
    const auto& is_triangle = shapes.is_triangle;
    const T around = on.change[0] - T(1.0 / 6.0) * on.along[0];
    on_edge[0] = select(is_triangle, half * on.along[0] + around, on_edge[0]);
    on_edge[1] = select(is_triangle, T(0), on_edge[1]);
    on_edge[2] = select(is_triangle, half * on.along[1] - around, on_edge[2]);
    on_edge[3] = select(is_triangle, half * on.along[1] + around, on_edge[3]);
  }
}

/// By how much a uniform shear of 1, xz or yz, changes across an element whose opposite edges differ: the covariant
/// shear follows the edges, gamma . (x_xi + eta h / 4). Nothing in a triangle, where it is what turns that is sampled.
template <class T>
struct EdgeSkew {
  T x, y;
};

template <class T, class Shapes>
PERCUSS_FORCE_INLINE EdgeSkew<T> find_edge_skew(const ShellGeometry<T>& g, [[maybe_unused]] const Shapes& shapes) {
  EdgeSkew<T> skew{T(0.25) * g.hx, T(0.25) * g.hy};
  if constexpr (Shapes::has_triangles) {
    skew = {select(shapes.is_triangle, T(0), skew.x), select(shapes.is_triangle, T(0), skew.y)};
  }
  return skew;
}

/// What the corners turn about e3, as the element takes it: the mean of its nodes; of a triangle also what they turn
/// beyond it, as two fields of corner values at right angles to each other and to the mean, with the mean square 1.
template <class T>
struct Drilling {
  T mean, beyond[2];
};

KOKKOS_INLINE_FUNCTION constexpr double find_drilling_field_size(int i) {
  return i == 0 ? 0.40824829046386302 : 0.23570226039551584;  // 1/sqrt 6, 1/sqrt 18
}

template <class T, class Shapes>
PERCUSS_FORCE_INLINE Drilling<T> join_drills(const T (&drill)[4], [[maybe_unused]] const Shapes& shapes) {
  const T first = drill[0] + drill[1];
  Drilling<T> joined{T(0.25) * (first + (drill[2] + drill[3])), {T(0), T(0)}};
  if constexpr (Shapes::has_triangles) {
    const auto& is_triangle = shapes.is_triangle;
    const T last = drill[2] + drill[3];  // twice the third corner's
    joined.mean = select(is_triangle, T(1.0 / 3.0) * (first + T(0.5) * last), joined.mean);
    joined.beyond[0] = select(is_triangle, T(find_drilling_field_size(0)) * (drill[1] - drill[0]), T(0));
    joined.beyond[1] = select(is_triangle, T(find_drilling_field_size(1)) * (last - first), T(0));
  }
  return joined;
}

/// Its transpose: moments of the corners about e3.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE void spread_drilling(const Drilling<T>& on, [[maybe_unused]] const Shapes& shapes,
                                          T (&moment)[4]) {
  const T quarter = T(0.25) * on.mean;
  for (int i = 0; i < 4; ++i) moment[i] = quarter;
  if constexpr (Shapes::has_triangles) {
    const auto& is_triangle = shapes.is_triangle;
    const T third = T(1.0 / 3.0) * on.mean;
    const T between = T(find_drilling_field_size(0)) * on.beyond[0],
            against = T(find_drilling_field_size(1)) * on.beyond[1];
    moment[0] = select(is_triangle, third - between - against, quarter);
    moment[1] = select(is_triangle, third + between - against, quarter);
    moment[2] = moment[3] = select(is_triangle, T(0.5) * third + against, quarter);
  }
}

/// Rates from the differences of the velocity and the angular velocities of the corners, both in the element's frame.
template <class T, class Shapes = Quadrilaterals>
PERCUSS_FORCE_INLINE ShellRates<T> find_shell_rates(const ShellGeometry<T>& g, const ShellDifferences<T>& velocity,
                                                    const Vector3<T> (&rotation)[4], const Shapes& shapes = {}) {
  ShellCornerField<T> v, beta;
  T drill[4];
  remove_rigid_motion(g, velocity, rotation, v, beta, drill);
  const auto along_x = [&](const T(&u)[4]) { return g.b1[0] * (u[2] - u[0]) + g.b1[1] * (u[3] - u[1]); };
  const auto along_y = [&](const T(&u)[4]) { return g.b2[0] * (u[2] - u[0]) + g.b2[1] * (u[3] - u[1]); };
  const auto hourglass = [&](const T(&u)[4], const T& u_x, const T& u_y) {
    return T(0.25) * ((u[0] + u[2]) - (u[1] + u[3]) - g.hx * u_x - g.hy * u_y);
  };
  const T vx_x = along_x(v.x), vx_y = along_y(v.x), vy_x = along_x(v.y), vy_y = along_y(v.y);
  const T bx_x = along_x(beta.x), bx_y = along_y(beta.x), by_x = along_x(beta.y), by_y = along_y(beta.y);
  T edge[4];
  for (int k = 0; k < 4; ++k) {
    edge[k] = find_edge_shear(g, v, beta, find_shear_edge(k, 0), find_shear_edge(k, 1));
  }
  const EdgeShear<T> shear = join_edges(edge, shapes);
  const T &along_xi = shear.along[0], &along_eta = shear.along[1];
  const T shear_x = g.xi_x * along_xi + g.eta_x * along_eta, shear_y = g.xi_y * along_xi + g.eta_y * along_eta;
  const EdgeSkew<T> skew = find_edge_skew(g, shapes);
  const T uniform = skew.x * shear_x + skew.y * shear_y;
  const Drilling<T> turning = join_drills(drill, shapes);
  return {{vx_x, vy_y, vx_y + vy_x},
          {bx_x, by_y, bx_y + by_x},
          {shear_x, shear_y},
          {hourglass(v.x, vx_x, vx_y), hourglass(v.y, vy_x, vy_y)},
          {hourglass(beta.x, bx_x, bx_y), hourglass(beta.y, by_x, by_y)},
          {shear.change[0] - uniform, shear.change[1] - uniform},
          turning.mean,
          {turning.beyond[0], turning.beyond[1]}};
}

}  // namespace percuss
