// The elements of J2 plasticity, of every kind.

#include "kernels/element/advance_chunk.hpp"

namespace percuss {

PERCUSS_COMPILE_ADVANCE(J2Plasticity, HexKind::assumed_strain)
PERCUSS_COMPILE_ADVANCE(J2Plasticity, HexKind::stiffness)
PERCUSS_COMPILE_ADVANCE(J2Plasticity, HexKind::viscous)
PERCUSS_COMPILE_ADVANCE(J2Plasticity, HexKind::full)
PERCUSS_COMPILE_ADVANCE(J2Plasticity, HexKind::thick3)
PERCUSS_COMPILE_ADVANCE(J2Plasticity, HexKind::thick5)

}  // namespace percuss
