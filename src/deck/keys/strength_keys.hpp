#pragma once
// Keys of the strengths of ties and welds.

#include <fmt/format.h>

#include <utility>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// Strengths of a connection, and how they act together.
template <class Connection>
Keys<Connection> strength_keys() {
  return {
      may("normal", &Connection::normal_strength, NumberValue{positive}),
      may("shear", &Connection::shear_strength, NumberValue{positive}),
      may("normal_exponent", &Connection::normal_exponent, NumberValue{positive}),
      may("shear_exponent", &Connection::shear_exponent, NumberValue{positive}),
  };
}

/// Exponents belong to a strength.
template <class Connection>
bool check_strengths(const Reader& reader, const Node& node, Connection& connection) {
  bool good = true;
  for (const auto& [key, strength] : {std::pair("normal_exponent", connection.normal_strength),
                                      std::pair("shear_exponent", connection.shear_strength)}) {
    const Node* exponent = node.find(key);
    if (exponent == nullptr || strength) continue;
    reader.error(exponent->key, fmt::format("{} has no effect{} (the strength that it belongs to is not given)",
                                            reader.name_of(key), reader.in()));
    good = false;
  }
  return good;
}

}  // namespace percuss
