#pragma once
// A four-node quadrilateral in its own frame: diagonals, gradient operator, corner normals.
//
// The frame follows the diagonals r = x3 - x1 and s = x4 - x2: e3 is normal to both, e1 halves the angle between the
// direction of xi and the normal of the direction of eta, so that the frame does not depend on which corner is first.
// Corners then lie at heights z, -z, z, -z: z is the warp. Fields of the corners are kept as differences, which is what
// the gradient operator of one point takes (Belytschko, Lin and Tsay 1984): B1.u = b1[0] ur + b1[1] us.

#include "kernels/core/tensor.hpp"

namespace percuss {

/// Differences of a corner field: along the diagonals, u3 - u1 and u4 - u2, and its hourglass part u1 - u2 + u3 - u4.
template <class T>
struct ShellDifferences {
  Vector3<T> r, s, h;
};

template <class T>
PERCUSS_FORCE_INLINE ShellDifferences<T> find_differences(const Vector3<T> (&u)[4]) {
  return {u[2] - u[0], u[3] - u[1], (u[0] + u[2]) - (u[1] + u[3])};
}

/// Differences in other axes, the rows of a matrix.
template <class T>
PERCUSS_FORCE_INLINE ShellDifferences<T> turn(const Matrix3<T>& axes, const ShellDifferences<T>& u) {
  return {axes * u.r, axes * u.s, axes * u.h};
}

/// Corner values about their mean.
template <class T>
PERCUSS_FORCE_INLINE void find_corner_values(const T& r, const T& s, const T& h, T (&u)[4]) {
  const T half = T(0.5), quarter = T(0.25);
  u[0] = quarter * h - half * r;
  u[2] = quarter * h + half * r;
  u[1] = -quarter * h - half * s;
  u[3] = -quarter * h + half * s;
}

/// What a pack holds. A triangle is a quadrilateral whose third corner stands twice: the gradient operator of one point
/// is then the triangle's own, and what hourglass modes see is nothing. Packs of quadrilaterals do not ask.
struct Quadrilaterals {
  static constexpr bool has_triangles = false;
};

/// Mask: of a scalar or of a pack.
template <class Mask>
struct MixedShapes {
  static constexpr bool has_triangles = true;
  Mask is_triangle;
};

/// Signs of the hourglass mode, which are also those of the corners' heights.
KOKKOS_INLINE_FUNCTION constexpr int find_warp_sign(int i) { return 1 - 2 * (i % 2); }

template <class T>
struct ShellGeometry {
  Matrix3<T> frame;            // rows e1, e2, e3
  T area;                      // of the projection along e3
  T x[4], y[4], z;             // corners about their mean; heights z, -z, z, -z
  T hx, hy;                    // hourglass parts of x and y
  T b1[2], b2[2];              // gradient operator: d/dx and d/dy of a field from its differences along r and s
  T px[4], py[4], pz[4];       // directors: unit vectors along the corner normals
  T least_cosine;              // between a corner normal and e3; of a fold not positive
  T xi_x, xi_y, eta_x, eta_y;  // inverse of the Jacobian at the centre
};

/// Least height of a corner normal along e3, as a share of the element's area: the normal of a corner that folds over
/// would point downwards, and its director would turn over within a step.
inline constexpr double shell_least_normal = 0.05;

/// Directors of the corners, from the two edges of each. Neighbours of a corner are as high as each other, so that the
/// in-plane part of the normal is the other diagonal, turned by a right angle. All corners of a triangle have its own.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE void find_directors(const ShellDifferences<T>& d, [[maybe_unused]] const Shapes& shapes,
                                         ShellGeometry<T>& g) {
  const T twice = g.z + g.z, least_height = T(shell_least_normal) * g.area;
  const T nx[4] = {twice * d.s.y, twice * d.r.y, -twice * d.s.y, -twice * d.r.y};
  const T ny[4] = {-twice * d.s.x, -twice * d.r.x, twice * d.s.x, twice * d.r.x};
  T nz[4], length[4];
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4, previous = (i + 3) % 4;
    nz[i] = (g.x[next] - g.x[i]) * (g.y[previous] - g.y[i]) - (g.y[next] - g.y[i]) * (g.x[previous] - g.x[i]);
    if constexpr (Shapes::has_triangles) nz[i] = select(shapes.is_triangle, g.area + g.area, nz[i]);
    g.pz[i] = larger(nz[i], least_height);
    length[i] = square_root(nx[i] * nx[i] + ny[i] * ny[i] + g.pz[i] * g.pz[i]);
  }
  const T first = length[0] * length[1], last = length[2] * length[3];
  const T over_all = T(1) / (first * last);  // one division for four
  const T over_first = over_all * last, over_last = over_all * first;
  for (int i = 0; i < 4; ++i) {
    const T over_length = (i < 2 ? over_first : over_last) * length[i ^ 1];
    g.px[i] = over_length * nx[i];
    g.py[i] = over_length * ny[i];
    g.pz[i] = over_length * g.pz[i];
    const T cosine = over_length * nz[i];
    g.least_cosine = i == 0 ? cosine : smaller(g.least_cosine, cosine);
  }
}

/// Geometry of a quadrilateral from the differences of its corner positions in space axes.
template <class T, class Shapes = Quadrilaterals>
PERCUSS_FORCE_INLINE ShellGeometry<T> find_shell_geometry(const ShellDifferences<T>& position,
                                                          const Shapes& shapes = {}) {
  const T half = T(0.5), quarter = T(0.25);
  ShellGeometry<T> g;
  const Vector3<T> normal = cross(position.r, position.s);
  const T twice_area = norm(normal);
  g.area = half * twice_area;
  const Vector3<T> e3 = (T(1) / twice_area) * normal;
  const Vector3<T> xi = position.r - position.s, eta = position.r + position.s;
  const Vector3<T> middle = (T(1) / norm(xi)) * xi + (T(1) / norm(eta)) * cross(eta, e3);
  const Vector3<T> e1 = (T(1) / norm(middle)) * middle;
  g.frame = {{e1, cross(e3, e1), e3}};
  const ShellDifferences<T> d = turn(g.frame, position);
  g.hx = d.h.x;
  g.hy = d.h.y;
  g.z = quarter * d.h.z;
  if constexpr (Shapes::has_triangles) g.z = select(shapes.is_triangle, T(0), g.z);  // round-off
  find_corner_values(d.r.x, d.s.x, d.h.x, g.x);
  find_corner_values(d.r.y, d.s.y, d.h.y, g.y);
  const T over_twice_area = T(1) / twice_area;
  g.b1[0] = over_twice_area * d.s.y;
  g.b1[1] = -over_twice_area * d.r.y;
  g.b2[0] = -over_twice_area * d.s.x;
  g.b2[1] = over_twice_area * d.r.x;
  g.xi_x = over_twice_area * T(2) * (d.r.y + d.s.y);
  g.xi_y = -over_twice_area * T(2) * (d.r.x + d.s.x);
  g.eta_x = -over_twice_area * T(2) * (d.r.y - d.s.y);
  g.eta_y = over_twice_area * T(2) * (d.r.x - d.s.x);
  find_directors(d, shapes, g);
  return g;
}

/// Sums of the products of the corners' gradients, which say how fast an element swings: xx, yy, xy.
template <class T>
struct GradientProducts {
  T xx, yy, xy;
};

/// Products over four corners; over the three of a triangle, times three quarters, because they have more mass each.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE GradientProducts<T> find_gradient_products(const ShellGeometry<T>& g,
                                                                [[maybe_unused]] const Shapes& shapes) {
  const auto sum = [&](const T(&a)[2], const T(&b)[2]) {
    const T quadrilateral = T(2) * (a[0] * b[0] + a[1] * b[1]);
    if constexpr (Shapes::has_triangles) {
      const T both = (a[0] + a[1]) * (b[0] + b[1]);
      return select(shapes.is_triangle, T(0.75) * (a[0] * b[0] + a[1] * b[1] + both), quadrilateral);
    } else {
      return quadrilateral;
    }
  };
  return {sum(g.b1, g.b1), sum(g.b2, g.b2), sum(g.b1, g.b2)};
}

/// What a triangle keeps of its stiffness in transverse shear, so that it does not lock where it is thin: t^2 / (t^2 +
/// alpha h^2), h^2 the mean square of its edges (Lyly, Stenberg and Vihinen 1993; Bischoff and Bletzinger 2001).
inline constexpr double triangle_shear_stabilisation = 0.1;

template <class T, class Mask>
PERCUSS_FORCE_INLINE T find_shear_share(const ShellGeometry<T>& g, const T& thickness,
                                        const MixedShapes<Mask>& shapes) {
  const GradientProducts<T> b = find_gradient_products(g, shapes);
  const T edge_square = T(16.0 / 9.0) * g.area * g.area * (b.xx + b.yy), square = thickness * thickness;
  return select(shapes.is_triangle, square * (T(1) / (square + T(triangle_shear_stabilisation) * edge_square)), T(1));
}

/// Integrals over the element of the products of the gradient of xi eta: xx, yy, xy, for a constant Jacobian.
template <class T>
struct HourglassIntegrals {
  T xx, yy, xy;
};

template <class T>
PERCUSS_FORCE_INLINE HourglassIntegrals<T> integrate_hourglass(const ShellGeometry<T>& g) {
  const T third = T(1.0 / 3.0) * g.area;
  return {third * (g.xi_x * g.xi_x + g.eta_x * g.eta_x), third * (g.xi_y * g.xi_y + g.eta_y * g.eta_y),
          third * (g.xi_x * g.xi_y + g.eta_x * g.eta_y)};
}

}  // namespace percuss
