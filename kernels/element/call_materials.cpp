// All materials that solids call, compiled once for the packs of all families.

#include "kernels/material/laws/call_material.hpp"

namespace percuss {

template void CalledMaterial::update(PointStep<Pack<double>>&) const;

}  // namespace percuss
