#pragma once
// Execution space, memory space and the view types that every kernel shares.
//
// The back end is chosen when percuss is configured (PERCUSS_BACKEND). All vector-valued node data lie row by
// row (x, y, z of a node together), because both the gather of an element and a node loop want whole rows.

#include <Kokkos_Core.hpp>
#include <utility>

#include <cstdint>

#if defined(PERCUSS_MEMORY_APART)
#include "kernels/core/guarded_memory.hpp"
#endif

namespace percuss {

#if defined(PERCUSS_BACKEND_OPENMP)
using ExecSpace = Kokkos::OpenMP;
#elif defined(PERCUSS_BACKEND_SERIAL)
using ExecSpace = Kokkos::Serial;
#elif defined(PERCUSS_BACKEND_CUDA)
using ExecSpace = Kokkos::Cuda;
#else
using ExecSpace = Kokkos::DefaultExecutionSpace;
#endif
#if defined(PERCUSS_MEMORY_APART)
using MemSpace = GuardedSpace;
#elif defined(PERCUSS_PINNED_MEMORY)
// Host memory that the device reads too: for tests that look into views.
using MemSpace = Kokkos::SharedHostPinnedSpace;
#elif defined(PERCUSS_BACKEND_CUDA) && !defined(PERCUSS_DEVICE_MEMORY)
// Moved between host and device as either reads it: the host looks into views between kernels.
using MemSpace = Kokkos::SharedSpace;
#else
using MemSpace = ExecSpace::memory_space;
#endif
/// Whether the host reads the memory of kernels.
#if defined(PERCUSS_MEMORY_APART)
inline constexpr bool is_host_memory = false;
#else
inline constexpr bool is_host_memory = Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemSpace>::accessible;
#endif

/// One value an item: shape [n].
template <class T>
using Array = Kokkos::View<T*, Kokkos::LayoutRight, MemSpace>;

/// Three values an item, stored as a row: shape [n][3].
template <class T>
using Rows3 = Kokkos::View<T* [3], Kokkos::LayoutRight, MemSpace>;

/// Four values an item, stored as a row: shape [n][4] (the corners of a face).
template <class T>
using Rows4 = Kokkos::View<T* [4], Kokkos::LayoutRight, MemSpace>;

using Range = Kokkos::RangePolicy<ExecSpace, Kokkos::IndexType<int>>;

/// Type of what Kokkos::create_mirror_view() gives for a view: the view itself where kernels run on host memory. The
/// member of View that names it depends on the version of Kokkos.
template <class View>
using HostMirror = decltype(Kokkos::create_mirror_view(std::declval<const View&>()));

}  // namespace percuss
