// Wedges and pyramids of one material, PERCUSS_MATERIAL. kernels/CMakeLists.txt compiles this for each material.

#include "kernels/one_point/one_point_chunks.hpp"
#include "kernels/tet/advance_solids.hpp"
#ifdef PERCUSS_ON_DEVICE  // which calls functions of the same source only
#include "kernels/material/laws/call_material.hpp"
#endif

namespace percuss {

template <class Shape>
inline constexpr bool fits_record =
    sizeof(OnePointState<double, Elastic, Shape>) == OnePointRecord<Shape>::find_size(0) * sizeof(double);
static_assert(fits_record<Wedge6> && fits_record<Pyramid5>);

PERCUSS_COMPILE_SOLIDS(OnePointBlock<PERCUSS_MATERIAL, Wedge6>)
PERCUSS_COMPILE_SOLIDS(OnePointBlock<PERCUSS_MATERIAL, Pyramid5>)

}  // namespace percuss
