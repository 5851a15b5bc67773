// The hexahedra of one material, PERCUSS_MATERIAL, of every kind. kernels/CMakeLists.txt compiles this for each
// material.

#include "kernels/element/hex_body.hpp"
#ifdef PERCUSS_ON_DEVICE  // which calls functions of the same source only
#include "kernels/material/laws/call_material.hpp"
#endif

namespace percuss {

#define PERCUSS_COMPILE_HEXAHEDRA(KIND)                                                                        \
  template void advance_block(const ExecSpace&, const ElementChunks&, const HexBlock<PERCUSS_MATERIAL, KIND>&, \
                              const ElementMotion&, const ChunkFields&);
PERCUSS_COMPILE_HEXAHEDRA(HexKind::assumed_strain)
PERCUSS_COMPILE_HEXAHEDRA(HexKind::stiffness)
PERCUSS_COMPILE_HEXAHEDRA(HexKind::viscous)
PERCUSS_COMPILE_HEXAHEDRA(HexKind::full)
PERCUSS_COMPILE_HEXAHEDRA(HexKind::thick3)
PERCUSS_COMPILE_HEXAHEDRA(HexKind::thick5)

}  // namespace percuss
