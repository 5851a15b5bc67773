#pragma once
// Which parts of a deck are rigid, and which of them are one body.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// Bodies in the order of their first parts.
struct RigidNames {
  std::vector<std::string> bodies;  // `rigid.body`, or the name of the part
  std::vector<int> body_of_part;    // [parts] -1: it deforms
};

inline RigidNames name_rigid_bodies(const Deck& deck) {
  RigidNames names;
  for (const PartDeck& part : deck.parts) {
    names.body_of_part.push_back(-1);
    if (!part.rigid) continue;
    const std::string& name = part.rigid->body.empty() ? part.name : part.rigid->body;
    const auto known = std::find(names.bodies.begin(), names.bodies.end(), name);
    names.body_of_part.back() = static_cast<int>(known - names.bodies.begin());
    if (known == names.bodies.end()) names.bodies.push_back(name);
  }
  return names;
}

inline bool has_rigid_parts(const Deck& deck) {
  return std::any_of(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) { return part.rigid.has_value(); });
}

/// Whether a tensor xx, yy, zz, xy, yz, zx is the inertia of some masses that do not lie on one line: then the second
/// moments of mass, tr(I)/2 1 - I, are positive semidefinite, and I is positive definite.
inline bool is_inertia_of_masses(const std::array<double, 6>& i) {
  constexpr double round_off = 1e-12;
  const auto find_determinant = [](const std::array<double, 6>& a) {
    return a[0] * (a[1] * a[2] - a[4] * a[4]) - a[3] * (a[3] * a[2] - a[4] * a[5]) + a[5] * (a[3] * a[4] - a[1] * a[5]);
  };
  const double half = 0.5 * (i[0] + i[1] + i[2]);
  if (!(half > 0)) return false;
  const std::array<double, 6> j{half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]};
  const auto is_positive = [&](const std::array<double, 6>& a, double least) {
    const double minors = a[0] * a[1] - a[3] * a[3] + (a[1] * a[2] - a[4] * a[4]) + (a[2] * a[0] - a[5] * a[5]);
    return a[0] + a[1] + a[2] > 0 && minors > least * half * half && find_determinant(a) > least * half * half * half;
  };
  return is_positive(i, round_off) && is_positive(j, -round_off);
}

}  // namespace percuss
