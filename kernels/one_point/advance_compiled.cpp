// Wedges and pyramids of the materials that are compiled into elements.

#include "kernels/one_point/advance_one_point.hpp"

namespace percuss {

PERCUSS_COMPILE_ONE_POINTS(Elastic)
PERCUSS_COMPILE_ONE_POINTS(J2Plasticity)

}  // namespace percuss
