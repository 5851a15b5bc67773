#pragma once
// dv of a place in the extrapolated iterate of the packs.

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/contact/rows/row_pack.hpp"

namespace percuss {

KOKKOS_INLINE_FUNCTION void set_dv(const RowPacks& packs, int a, const Point3& dv) {
  store_row(packs.dv, a, dv);
  packs.dv(a, 3) = 0;
  packs.moved(a) = dv.x != 0 || dv.y != 0 || dv.z != 0 ? 1 : 0;
}

KOKKOS_INLINE_FUNCTION Point3 extrapolate(const Point3& dv, const Point3& before, double beta) {
  return beta > 0 ? dv + beta * (dv - before) : dv;
}

}  // namespace percuss
