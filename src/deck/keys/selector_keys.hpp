#pragma once
// Keys of a selector.

#include "src/deck/keys/keys.hpp"

namespace percuss {

/// Keys of a selector that is a map.
const Keys<Selector>& selector_keys();

}  // namespace percuss
