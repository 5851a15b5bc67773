#pragma once
// Keys of entries that a sensor switches.

#include <string>
#include <utility>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// The name of a sensor.
struct SensorNameValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const;
  std::string takes() const { return "a name from sensors"; }
  Form form() const { return {Form::Kind::text}; }
};

/// Adds `from` and `until` to the keys of an entry that has a SwitchDeck `when`.
template <class Owner>
Keys<Owner> with_switch(Keys<Owner> keys) {
  const auto key = [](const char* name, std::string SwitchDeck::*member) {
    return make_key<Owner>(
        name, false, SensorNameValue{},
        [member](const SensorNameValue& value, const Reader& reader, const std::string& full, const Node& node,
                 Owner& owner) { return value.read(reader, full, node, owner.when.*member); });
  };
  keys.push_back(key("from", &SwitchDeck::from));
  keys.push_back(key("until", &SwitchDeck::until));
  return keys;
}

}  // namespace percuss
