// Tetrahedra of the materials that are compiled into elements.

#include "kernels/tet/advance_tets.hpp"

namespace percuss {

PERCUSS_COMPILE_TETS(Elastic)
PERCUSS_COMPILE_TETS(J2Plasticity)

}  // namespace percuss
