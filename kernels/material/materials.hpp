#pragma once
// The list of materials. A new material is its own header and one entry here.

#include "kernels/material/elastic.hpp"
#include "kernels/material/j2_plasticity.hpp"

namespace percuss {

template <class... Ts>
struct TypeList {};

using Materials = TypeList<Elastic, J2Plasticity>;

}  // namespace percuss
