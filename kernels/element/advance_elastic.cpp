// The elements of linear elasticity, of every kind.

#include "kernels/element/advance_chunk.hpp"

namespace percuss {

PERCUSS_COMPILE_ADVANCE(Elastic, HexKind::assumed_strain)
PERCUSS_COMPILE_ADVANCE(Elastic, HexKind::stiffness)
PERCUSS_COMPILE_ADVANCE(Elastic, HexKind::viscous)
PERCUSS_COMPILE_ADVANCE(Elastic, HexKind::full)
PERCUSS_COMPILE_ADVANCE(Elastic, HexKind::thick3)
PERCUSS_COMPILE_ADVANCE(Elastic, HexKind::thick5)

}  // namespace percuss
