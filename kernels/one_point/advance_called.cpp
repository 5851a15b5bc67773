// Wedges and pyramids of every material that is called.

#include "kernels/material/laws/call_material.hpp"
#include "kernels/one_point/advance_one_point.hpp"

namespace percuss {

PERCUSS_COMPILE_ONE_POINTS(CalledMaterial)

}  // namespace percuss
