#pragma once
// The list of materials. A new material is its own header and one entry here. It has
//   history_count, can_yield      constants
//   moduli()                      elastic constants, for the stabilisation of the element
//   update(stress, history, de)   one strain increment; returns a PlasticReturn if it can yield, nothing otherwise

#include "kernels/material/elastic.hpp"
#include "kernels/material/j2_plasticity.hpp"

namespace percuss {

template <class... Ts>
struct TypeList {};

using Materials = TypeList<Elastic, J2Plasticity>;

}  // namespace percuss
