#pragma once
// Which nodes or faces an entry of a deck means.

#include <array>
#include <optional>
#include <string>

#include "src/deck/text/deck_errors.hpp"

namespace percuss {

using Vec3 = std::array<double, 3>;

/// Nodes or faces by name ("bar", "bar/x_min", "nodes_7") and, optionally, only those inside a box of space.
struct Selector {
  std::string name;  // a part, a side "part/side", or a set of an Exodus mesh "part/set"; empty: the whole mesh
  std::optional<std::array<Vec3, 2>> inside;  // lowest and highest corner at time 0
  Place place;
};

}  // namespace percuss
