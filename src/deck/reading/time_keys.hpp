#pragma once
// Keys of `time` and `audit`: how long a run is, its step, and what stops it.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<TimeDeck> time_value();
MapValue<AuditDeck> audit_value();

}  // namespace percuss
