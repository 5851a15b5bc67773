#pragma once
// The models of a material: its laws and equations of state, each with its keys. Their tables are in kernels/material.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

struct LawModel {
  enum class State { none, may, must };
  std::string name;
  State state;  // whether it has an equation of state
  Keys<LawDeck> keys;
  std::string (*find_fault)(const LawDeck&);             // what is wrong between several constants; empty: nothing
  std::string (*find_fault_with_state)(const LawDeck&);  // likewise, only with an equation of state
};

/// Laws, as `model` names them.
const std::vector<LawModel>& law_models();

/// Equations of state, as `kind` names them.
const std::vector<LawModel>& state_models();

}  // namespace percuss
