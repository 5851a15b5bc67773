#pragma once
// The nodes or faces that an entry of a deck means.

#include <array>
#include <optional>
#include <string>

#include "src/deck/text/deck_errors.hpp"

namespace percuss {

using Vec3 = std::array<double, 3>;

/// Nodes or faces by name ("bar", "bar/x_min", "nodes_7") and, optionally, only those inside a box of space.
struct Selector {
  // A part, a side "part/side", a set of an Exodus mesh "part/set", or "body:NAME", all nodes of a rigid body; empty:
  // the whole mesh.
  std::string name;
  std::optional<std::array<Vec3, 2>> inside;  // lowest and highest corner at time 0
  Place place;
};

inline constexpr const char* body_prefix = "body:";  // names of parts and sets have no colon

/// The rigid body that is meant; empty: none.
inline std::string find_body(const Selector& selector) {
  const std::string prefix = body_prefix;
  return selector.name.starts_with(prefix) ? selector.name.substr(prefix.size()) : std::string();
}

/// Kind of what a selector of the deck chooses.
enum class Chosen { some, nodes, faces, touching, surface_nodes, elements };  // touching: faces, or beams

/// A selector as the deck has it; `all` has no name.
struct UsedSelector {
  Selector where;
  Chosen chosen = Chosen::some;  // some: what it is depends on its section
};

}  // namespace percuss
