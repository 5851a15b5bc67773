#pragma once
// Keys of `output.fields` and of the entries of `output.field_outputs`.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// `output.fields`: of the whole mesh.
MapValue<FieldsDeck> fields_value();

/// `output.field_outputs`: of a region, or of the whole mesh, in a file of its own.
NamedMapValue<FieldsDeck, MapValue<FieldsDeck>> field_outputs_value();

/// Names that `write` takes.
const std::vector<std::string>& field_names();

/// How many frames they write, and points of shells that no part has.
void check_fields(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
