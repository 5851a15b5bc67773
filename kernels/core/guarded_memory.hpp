#pragma once
// Memory that the host cannot touch outside of kernels and explicit copies, on a machine without a device: a build with
// PERCUSS_MEMORY_APART puts all views of kernels there, and so finds each place of the host that would fail where a
// device has memory of its own.
//
// Its pages are without access but in a kernel or a copy. An access from the host faults; the guard records where, and
// then lets that one instruction pass. `PERCUSS_HOST_READS=stop` ends the program at the first one instead.

#if defined(PERCUSS_MEMORY_APART)

#include <Kokkos_Core.hpp>

#include <cstddef>

namespace percuss {

/// The pages, for Kokkos.
class GuardedPages {
 public:
  using memory_space = GuardedPages;
  using size_type = std::size_t;
  using execution_space = Kokkos::DefaultExecutionSpace;
  using device_type = Kokkos::Device<execution_space, memory_space>;

  static constexpr const char* name() { return "guarded"; }
  void* impl_allocate(const char* label, std::size_t bytes, std::size_t logical,
                      Kokkos::Tools::SpaceHandle space) const;
  void impl_deallocate(const char* label, void* place, std::size_t bytes, std::size_t logical,
                       Kokkos::Tools::SpaceHandle space) const;
};

struct GuardedName {
  static constexpr const char* get_name() { return "guarded"; }
};
using GuardedSpace =
    Kokkos::Experimental::LogicalMemorySpace<GuardedPages, Kokkos::DefaultExecutionSpace, GuardedName,
                                             Kokkos::Experimental::LogicalSpaceSharesAccess::no_shared_access>;

/// While it lives, this thread may touch the pages: a kernel or a copy.
class OpenGuard {
 public:
  OpenGuard();
  ~OpenGuard();
  OpenGuard(const OpenGuard&) = delete;
  OpenGuard& operator=(const OpenGuard&) = delete;
};

/// The guard acts while one of these lives, after Kokkos has been initialized. The end writes the places at which the
/// host touched the memory, with how often, to standard error: addresses of the program from the inside to the outside.
/// Last comes how many of these there are, unless a kernel has not ended (scripts/list_host_reads reads it all).
class MemoryGuard {
 public:
  MemoryGuard();
  ~MemoryGuard();
  MemoryGuard(const MemoryGuard&) = delete;
  MemoryGuard& operator=(const MemoryGuard&) = delete;

  /// Touches so far: instructions, not places.
  static long count_touches();
};

}  // namespace percuss

namespace Kokkos {

/// Kernels run on cores of the host; only they see the pages.
template <>
struct SpaceAccessibility<DefaultExecutionSpace, percuss::GuardedSpace> {
  enum { accessible = true, assignable = false, deepcopy = true };
  using space = Device<DefaultExecutionSpace, percuss::GuardedSpace>;
};

namespace Impl {

/// The pages themselves say who may touch them.
template <>
struct verify_space<HostSpace, percuss::GuardedSpace, false> {
  KOKKOS_FUNCTION static void check() {}
};

template <class Exec>
struct GuardedCopy {
  GuardedCopy(void* to, const void* from, std::size_t bytes) {
    const percuss::OpenGuard open;
    DeepCopy<HostSpace, HostSpace, Exec>(to, from, bytes);
  }
  GuardedCopy(const Exec& space, void* to, const void* from, std::size_t bytes) {
    const percuss::OpenGuard open;
    DeepCopy<HostSpace, HostSpace, Exec>(space, to, from, bytes);
  }
};
template <class Exec>
struct DeepCopy<percuss::GuardedSpace, percuss::GuardedSpace, Exec> : GuardedCopy<Exec> {
  using GuardedCopy<Exec>::GuardedCopy;
};
template <class Exec>
struct DeepCopy<percuss::GuardedSpace, HostSpace, Exec> : GuardedCopy<Exec> {
  using GuardedCopy<Exec>::GuardedCopy;
};
template <class Exec>
struct DeepCopy<HostSpace, percuss::GuardedSpace, Exec> : GuardedCopy<Exec> {
  using GuardedCopy<Exec>::GuardedCopy;
};

}  // namespace Impl
}  // namespace Kokkos

#endif
