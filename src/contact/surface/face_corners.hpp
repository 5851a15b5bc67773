#pragma once
// Steps along the corners of a face, and its diagonals. Of a triangle, a face of shells, two in a row are the same
// node.

#include <cstddef>

namespace percuss {

/// Whether the corner is the same node as the one before it: what is done once a node leaves it out.
template <class Corners>
bool is_repeated(const Corners& corners, std::size_t i) {
  return corners[i] == corners[(i + 3) % 4];
}

/// Nodes of a face.
template <class Corners>
std::size_t count_corners(const Corners& corners) {
  std::size_t count = 4;
  for (std::size_t i = 0; i < 4; ++i) count -= is_repeated(corners, i) ? 1 : 0;
  return count;
}

/// The next corner that is another node.
template <class Corners>
std::size_t find_next_corner(const Corners& corners, std::size_t i) {
  const std::size_t next = (i + 1) % 4;
  return corners[next] == corners[i] ? (next + 1) % 4 : next;
}

/// The one before.
template <class Corners>
std::size_t find_previous_corner(const Corners& corners, std::size_t i) {
  const std::size_t previous = (i + 3) % 4;
  return corners[previous] == corners[i] ? (previous + 3) % 4 : previous;
}

/// A diagonal of a face by places among its corners.
struct FaceDiagonal {
  std::size_t ends[2];   // lower node number first
  std::size_t wings[2];  // the corner on either side
  int turn;              // 1 if the triangle of the second wing runs from end 0 to end 1, else -1
};

/// which: 0 or 1. Corners run around the face.
template <class Corners>
FaceDiagonal find_diagonal(const Corners& corners, std::size_t which) {
  const std::size_t p = which, q = which + 2, next = which + 1, last = (which + 3) % 4;
  return corners[q] < corners[p] ? FaceDiagonal{{q, p}, {next, last}, -1} : FaceDiagonal{{p, q}, {next, last}, 1};
}

}  // namespace percuss
