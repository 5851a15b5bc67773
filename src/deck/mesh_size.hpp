#pragma once
// How many elements and nodes a generated part will have, before anything is allocated.

#include "src/deck/deck.hpp"

namespace percuss {

/// Counts as double: products of counts in a deck overflow integers.
struct MeshSize {
  double elements = 0, nodes = 0;
};

/// Elements and nodes are numbered by 32-bit integers.
inline constexpr double largest_mesh = 2147483647;

/// Size of a part with all its copies; zero for a mesh from a file.
MeshSize count_cells(const PartDeck& part);

}  // namespace percuss
