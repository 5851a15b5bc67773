#pragma once
// The copy of a view on the host.

#include <Kokkos_Core.hpp>
#include <utility>

namespace percuss {

/// Type of what Kokkos::create_mirror_view() gives for a view: the view itself where kernels run on host memory. The
/// member of View that names it depends on the version of Kokkos.
template <class View>
using HostMirror = decltype(Kokkos::create_mirror_view(std::declval<const View&>()));

}  // namespace percuss
