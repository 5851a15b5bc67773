// Tetrahedra of one material, PERCUSS_MATERIAL. kernels/CMakeLists.txt compiles this for each material.

#include "kernels/tet/advance_solids.hpp"
#ifdef PERCUSS_ON_DEVICE  // which calls functions of the same source only
#include "kernels/material/laws/call_material.hpp"
#endif

namespace percuss {

static_assert(sizeof(TetState<double, Elastic>) == TetRecord::find_size(0) * sizeof(double));

PERCUSS_COMPILE_SOLIDS(TetBlock<PERCUSS_MATERIAL>)

}  // namespace percuss
