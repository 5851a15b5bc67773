#pragma once
// What the rules on suspicious input need to know of the ties of the start.

#include "src/contact/ties/tie_hinges.hpp"
#include "src/contact/ties/tie_sizes.hpp"

namespace percuss {

struct TieMeasures {
  std::vector<TieHinge> hinges;  // rows of shell nodes that ties let turn
  std::vector<TieSizes> sizes;   // [ties]
};

}  // namespace percuss
