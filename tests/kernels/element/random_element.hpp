#pragma once
// Random but reproducible elements and motions for the element tests.

#include <cstdint>
#include <iterator>
#include <type_traits>
#include <vector>

#include "kernels/element/hex8/thick_shell.hpp"

namespace percuss::test {

/// A small deterministic generator: the tests must not depend on a library's distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2654435769u + 1) {}
  /// Uniform in [-1, 1].
  double operator()() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1.0;
  }

 private:
  std::uint64_t state_;
};

/// Corner positions or velocities, by corner.
struct Corners {
  double x[8], y[8], z[8];
};

inline constexpr int corner_xi[8] = {-1, 1, 1, -1, -1, 1, 1, -1};
inline constexpr int corner_eta[8] = {-1, -1, 1, 1, -1, -1, 1, 1};
inline constexpr int corner_zeta[8] = {-1, -1, -1, -1, 1, 1, 1, 1};

/// A brick of edges (ex, ey, ez) about the origin whose corners are moved by up to `distortion` of the edges.
inline Corners make_element(Random& random, double ex, double ey, double ez, double distortion) {
  Corners c{};
  for (int i = 0; i < 8; ++i) {
    c.x[i] = ex * (0.5 * corner_xi[i] + distortion * random());
    c.y[i] = ey * (0.5 * corner_eta[i] + distortion * random());
    c.z[i] = ez * (0.5 * corner_zeta[i] + distortion * random());
  }
  return c;
}

inline VectorModes<double> find_modes(Corners c) {
  to_modes(c.x);
  to_modes(c.y);
  to_modes(c.z);
  VectorModes<double> a{};
  for (int m = 1; m < 8; ++m) a[m] = {c.x[m], c.y[m], c.z[m]};
  return a;
}

inline Matrix3<double> random_matrix(Random& random, double size) {
  Matrix3<double> m{};
  for (auto& row : m.row) row = {size * random(), size * random(), size * random()};
  return m;
}

/// Corner values of the linear field u = g x.
inline Corners apply(const Matrix3<double>& g, const Corners& c) {
  Corners out{};
  for (int i = 0; i < 8; ++i) {
    const Vector3<double> u = g * Vector3<double>{c.x[i], c.y[i], c.z[i]};
    out.x[i] = u.x;
    out.y[i] = u.y;
    out.z[i] = u.z;
  }
  return out;
}

/// An element at rest in its first shape.
template <class Material, HexKind Kind = HexKind::stiffness, class T = double>
HexState<T, Material, Kind> make_state(const T& mass) {
  HexState<T, Material, Kind> s{};
  s.mass = mass;
  s.polar.rotation = identity_matrix<T>();
  s.polar.stretch = {T(1), T(1), T(1), T(0), T(0), T(0)};
  return s;
}

/// A state of an element with corners at `a`, which need not be a brick.
template <class Material, HexKind Kind>
HexState<double, Material, Kind> make_state(double mass, const VectorModes<double>& a) {
  auto s = make_state<Material, Kind>(mass);
  if constexpr (keeps_point_volumes<Material, Kind>) find_point_volumes(a, s.start.excess);
  return s;
}

/// Stresses of the points of an element.
template <class State>
std::vector<Symmetric3<double>> list_stresses(const State& state) {
  if constexpr (std::is_array_v<decltype(state.stress)>) {
    return {std::begin(state.stress), std::end(state.stress)};
  } else {
    return {state.stress};
  }
}

template <HexKind Kind_>
struct KindOf {
  static constexpr HexKind value = Kind_;
};

}  // namespace percuss::test
