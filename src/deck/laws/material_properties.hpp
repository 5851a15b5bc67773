#pragma once
// What the law of a material has, without its type.

#include <string>
#include <vector>

#include "kernels/material/elastic.hpp"
#include "kernels/material/point_step.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// The name by which a LawDeck has curve k of a key, among its tables, and its rate, among its numbers.
inline std::string name_curve(const std::string& key, int k) { return key + "." + std::to_string(k); }

/// The file of a material's compiled code; empty: it has none.
std::string find_code_file(const LawDeck& law);

/// Whether the history of a material has a scalar of this name.
bool has_scalar(const MaterialDeck& material, HistoryScalar name);

/// How many state variables a law of a user keeps.
int count_state_variables(const MaterialDeck& material);

/// Yield stresses that code of a user tells at the start: at no plastic strain, and at 1e-3 with a rate of 1. Empty:
/// the law requests none.
std::vector<double> find_yields_of_code(const MaterialDeck& material);

/// Elastic moduli at the start [stress].
LameConstants find_moduli(const MaterialDeck& material);

}  // namespace percuss
