// Tetrahedra of every material that is called.

#include "kernels/material/laws/call_material.hpp"
#include "kernels/tet/advance_tets.hpp"

namespace percuss {

PERCUSS_COMPILE_TETS(CalledMaterial)

}  // namespace percuss
