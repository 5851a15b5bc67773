#pragma once
// Views that every step reads and writes from end to end.
//
// A core that streams through small pages waits for their addresses: where the system hands out huge pages on request,
// they are requested before the first touch.

#include <cstdint>
#include <string>

#include "kernels/core/view_copy.hpp"
#include "kernels/core/views.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace percuss {

/// Asks for huge pages under the whole ones of a range that is not touched yet. It is a hint: no error if refused.
inline void wish_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t huge_page = std::uintptr_t{1} << 21;
  if (!is_host_memory) return;
  const auto start = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (start + huge_page - 1) / huge_page * huge_page;
  const std::uintptr_t end = (start + bytes) / huge_page * huge_page;
  if (first < end) ::madvise(static_cast<char*>(data) + (first - start), end - first, MADV_HUGEPAGE);
#endif
}

/// A view of `count` items on such pages, all zero.
template <class View>
View make_streamed(const std::string& label, std::size_t count) {
  const View view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), count);
  wish_huge_pages(view.data(), view.span() * sizeof(typename View::value_type));
  set_values(view, typename View::value_type(0));
  return view;
}

}  // namespace percuss
