// The elements of every material that is called, of every kind.

#include "kernels/element/advance_chunk.hpp"
#include "kernels/material/laws/call_material.hpp"

namespace percuss {

PERCUSS_COMPILE_ADVANCE(CalledMaterial, HexKind::assumed_strain)
PERCUSS_COMPILE_ADVANCE(CalledMaterial, HexKind::stiffness)
PERCUSS_COMPILE_ADVANCE(CalledMaterial, HexKind::viscous)
PERCUSS_COMPILE_ADVANCE(CalledMaterial, HexKind::full)
PERCUSS_COMPILE_ADVANCE(CalledMaterial, HexKind::thick3)
PERCUSS_COMPILE_ADVANCE(CalledMaterial, HexKind::thick5)

}  // namespace percuss
