#pragma once
// Characteristic lengths of elements that code of a user tells: VUCHARLENGTH.

#include <array>
#include <cstdint>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// An element at the start, as the code gets it.
struct UserShape {
  std::int64_t id = 0;        // the user's
  int kind = 6;               // 4: a tetrahedron, 5: a wedge, 6: a hexahedron; 7: a pyramid, which Abaqus does not have
  std::vector<Vec3> corners;  // in the order of Abaqus
  double length = 0;          // edge of a cube of its volume
};

/// How many lengths the law requests; 0: none.
int count_user_lengths(const LawDeck& law);

/// Throws InputError if the law requests lengths and its library has no VUCHARLENGTH, or fields and it has no
/// VUSDFLD.
void require_user_entries(const LawDeck& law);

/// The lengths, count_user_lengths() of them. Throws InputError if one is no number.
std::vector<double> find_user_lengths(const LawDeck& law, const UserShape& shape);

}  // namespace percuss
