#include "comm/rcb/cut_tree.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {

void find_owners(const ExecSpace& space, const CutTree& tree, const Rows3<const double>& positions,
                 const Array<const std::int64_t>& ids, const Array<int>& owners) {
  parallel_for(
      "percuss::find_owners", RangeOf(space, 0, static_cast<int>(positions.extent(0))), KOKKOS_LAMBDA(const int i) {
        const double position[3] = {positions(i, 0), positions(i, 1), positions(i, 2)};
        owners(i) = find_owner(tree, position, ids(i));
      });
}

}  // namespace percuss
