#include "kernels/node/nodal_load.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {

void apply_nodal_loads(const ExecSpace& space, const NodalLoads& loads, const NodalLoadValues& values,
                       const Rows3<double>& slot_force, const Rows3<double>& slot_moment) {
  if (loads.count == 0) return;
  const bool has_moments = slot_moment.extent(0) > 0;
  parallel_for(
      "percuss::apply_nodal_loads", RangeOf(space, 0, loads.count), KOKKOS_LAMBDA(const int i) {
        const double share = loads.share.extent(0) == 0 ? 1.0 : loads.share(i);
        const int s = loads.first_slot + i, load = loads.load(i);
        for (int k = 0; k < 3; ++k) {
          slot_force(s, k) = share * values(load, k);
          if (has_moments) slot_moment(s, k) = share * values(load, 3 + k);
        }
      });
}

}  // namespace percuss
