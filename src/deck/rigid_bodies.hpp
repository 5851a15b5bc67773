#pragma once
// Parts and sets of nodes of a deck that are rigid, and those that form one body.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// Bodies in the order of their first parts, then those of sets of nodes.
struct RigidNames {
  std::vector<std::string> bodies;  // `rigid.body`, or the name of the part or of the set
  std::vector<int> body_of_part;    // [parts] -1: it deforms
  std::vector<int> body_of_set;     // [rigid_sets] -1: it names none

  /// The body of that name, -1: none.
  int find(const std::string& name) const {
    const auto known = std::find(bodies.begin(), bodies.end(), name);
    return known == bodies.end() ? -1 : static_cast<int>(known - bodies.begin());
  }
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
  for (const RigidSetDeck& set : deck.rigid_sets)
    if (set.body.empty()) names.bodies.push_back(set.name);
  for (const RigidSetDeck& set : deck.rigid_sets)
    names.body_of_set.push_back(names.find(set.body.empty() ? set.name : set.body));
  return names;
}

inline bool has_rigid_parts(const Deck& deck) {
  return std::any_of(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) { return part.rigid.has_value(); });
}

inline bool has_rigid_bodies(const Deck& deck) { return !deck.rigid_sets.empty() || has_rigid_parts(deck); }

/// Where the deck names a body: its first part, or its first set.
inline Place find_body_place(const Deck& deck, const RigidNames& names, int body) {
  for (std::size_t p = 0; p < deck.parts.size(); ++p)
    if (names.body_of_part[p] == body) return deck.parts[p].rigid->place;
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s)
    if (names.body_of_set[s] == body) return deck.rigid_sets[s].place;
  return {};
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
