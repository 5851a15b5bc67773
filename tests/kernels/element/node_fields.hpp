#pragma once
// Vectors at the nodes of a block of elements, and what tests of every such block ask: power, momentum, frequency.
//
// A block has x and mass [nodes], states [elements], and advance(parameters, v, dt), whose result has force [nodes].

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test {

using NodeField = std::vector<Vector3<double>>;

inline NodeField make_field(Random& random, std::size_t count) {
  NodeField v;
  for (std::size_t i = 0; i < count; ++i) v.push_back({random(), random(), random()});
  return v;
}

inline double find_power(const NodeField& f, const NodeField& v) {
  double power = 0;
  for (std::size_t i = 0; i < v.size(); ++i) power += dot(f[i], v[i]);
  return power;
}

/// Forces on the nodes x of a block that nothing holds.
inline void expect_balance(const NodeField& x, const NodeField& force) {
  Vector3<double> sum{0, 0, 0}, moment{0, 0, 0};
  double size = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    sum = sum + force[n];
    moment = moment + cross(x[n], force[n]);
    size += norm(force[n]);
  }
  EXPECT_NEAR(norm(sum) / size, 0, 1e-14);
  EXPECT_NEAR(norm(moment) / size, 0, 1e-14);
}

/// Largest omega^2 of a block by power iteration on its own forces about the state that it has.
template <class Block, class Parameters>
double find_largest_square(Block block, const Parameters& par, Random& random) {
  const double dt = 1e-9;
  const auto start = block.states;
  const NodeField at_rest = block.advance(par, NodeField(block.x.size(), {0, 0, 0}), 0).force;
  NodeField v = make_field(random, block.x.size());
  double square = 0;
  for (int i = 0; i < 300; ++i) {
    block.states = start;
    const NodeField f = block.advance(par, v, dt).force;
    double product = 0, length = 0, size = 0;
    NodeField next;
    for (std::size_t n = 0; n < v.size(); ++n) {
      const Vector3<double> change = (1 / dt) * (f[n] - at_rest[n]);
      product += dot(change, v[n]);
      length += block.mass[n] * dot(v[n], v[n]);
      next.push_back((1 / block.mass[n]) * change);
      size = std::max(size, norm(next.back()));
    }
    square = product / length;
    for (std::size_t n = 0; n < v.size(); ++n) v[n] = (1 / size) * next[n];
  }
  return square;
}

}  // namespace percuss::test
