#pragma once
// Wedges and pyramids of random shape for tests of the one-point solids.

#include <algorithm>
#include <cmath>

#include "kernels/material/elastic.hpp"
#include "kernels/one_point/one_point.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test {

template <class Shape>
using Places = CornerField<double, Shape>;
template <class Shape>
using ElasticSolid = OnePointState<double, Elastic, Shape>;

inline Places<Wedge6> reference_places(Wedge6) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
}
inline Places<Pyramid5> reference_places(Pyramid5) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}};
}

/// Tetrahedra at the corners of the triangles and of the base, whose volumes say whether a shape is inverted.
inline double find_least_corner(const Places<Wedge6>& x) {
  constexpr int edges[6][3] = {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};
  double least = 1e300;
  for (int c = 0; c < 6; ++c)
    least = std::min(least, dot(x[edges[c][0]] - x[c], cross(x[edges[c][1]] - x[c], x[edges[c][2]] - x[c])));
  return least;
}
inline double find_least_corner(const Places<Pyramid5>& x) {
  double least = 1e300;
  for (int c = 0; c < 4; ++c)
    least = std::min(least, dot(x[(c + 1) % 4] - x[c], cross(x[(c + 3) % 4] - x[c], x[4] - x[c])));
  return least;
}

/// The shape of reference, each of its corners moved by up to `distortion`, then stretched: of edges about 1 again.
template <class Shape>
Places<Shape> make_places(Random& random, double distortion, const Vector3<double>& stretch = {1, 1, 1}) {
  for (;;) {
    Places<Shape> x = reference_places(Shape());
    for (auto& corner : x.at)
      corner = corner + Vector3<double>{distortion * random(), distortion * random(), distortion * random()};
    if (find_least_corner(x) < 0.1) continue;
    for (auto& corner : x.at) corner = {stretch.x * corner.x, stretch.y * corner.y, stretch.z * corner.z};
    return x;
  }
}

template <class Shape>
Places<Shape> make_motion(Random& random) {
  Places<Shape> v;
  for (auto& corner : v.at) corner = {random(), random(), random()};
  return v;
}

template <class Shape>
Places<Shape> apply(const Matrix3<double>& a, const Places<Shape>& x) {
  Places<Shape> u;
  for (int i = 0; i < Shape::corners; ++i) u[i] = a * x[i];
  return u;
}

template <class Shape>
ElasticSolid<Shape> make_solid(double mass) {
  ElasticSolid<Shape> s{};
  s.mass = mass;
  s.polar.rotation = identity_matrix<double>();
  s.polar.stretch = {1, 1, 1, 0, 0, 0};
  return s;
}

inline SolidParameters<Elastic> make_solid_parameters(const LameConstants& c, double hourglass = 0.05,
                                                      BulkViscosity viscosity = {0, 0}) {
  return {{c.lambda, c.mu}, std::max(c.lambda, 0.0), c.mu, hourglass, viscosity};
}

}  // namespace percuss::test
