#pragma once
// Words of other codes (LS-DYNA, Abaqus) and of textbooks, and what they are called here.

#include <string>
#include <vector>

namespace percuss {

/// A hint for an unknown key that other codes have, such as " (did you mean 'density'?)" for rho; empty: none is known.
/// `known` are the keys of its map. Letter case is ignored.
std::string find_foreign_key(const std::string& key, const std::vector<std::string>& known);

/// Remedy where a material has a model of other codes: "set parts.NAME.rigid: true" for rigid; empty: no such model is
/// known.
std::string find_foreign_model(const std::string& model);

}  // namespace percuss
