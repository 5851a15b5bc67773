#pragma once
// Values of views, copied and set. Where the host reads the memory of kernels this needs no deep_copy(), whose kernels
// each source would compile for each pair of types.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "kernels/core/contract.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

#if defined(PERCUSS_ON_DEVICE)
inline constexpr bool copies_on_host = false;
#else
inline constexpr bool copies_on_host = is_host_memory;
#endif

/// Copies bytes, on all threads if they are many; none if both places are the same.
void copy_bytes(void* to, const void* from, std::size_t count);

/// Copies the values of a view to one of the same shape. Both are contiguous.
template <class To, class From>
void copy_values(const To& to, const From& from) {
  if constexpr (copies_on_host) {
    using Value = typename To::non_const_value_type;
    static_assert(std::is_same_v<Value, typename From::non_const_value_type> && std::is_trivially_copyable_v<Value>);
    PERCUSS_EXPECT(to.span_is_contiguous() && from.span_is_contiguous());
    if (to.span() != from.span()) Kokkos::abort("percuss::copy_values: the views differ in size");
    copy_bytes(to.data(), from.data(), to.span() * sizeof(Value));
  } else {
    Kokkos::deep_copy(to, from);
  }
}

/// Sets all values of a contiguous view.
template <class View>
void set_values(const WorkSpace& space, const View& view, const typename View::value_type& value) {
  if constexpr (copies_on_host) {
    PERCUSS_EXPECT(view.span_is_contiguous());
    constexpr std::int64_t block = 4096;
    const auto count = static_cast<std::int64_t>(view.span());
    auto* const data = view.data();
    parallel_for("percuss::set_values", RangeOf(space, 0, static_cast<int>((count + block - 1) / block)),
                 [&](int b) { std::fill(data + b * block, data + std::min(count, (b + 1) * block), value); });
  } else {
    Kokkos::deep_copy(space.all(), view, value);
  }
}
template <class View>
void set_values(const View& view, const typename View::value_type& value) {
  set_values(view.span() < 100000 ? WorkSpace(SmallSpace()) : WorkSpace(ExecSpace()), view, value);
}

}  // namespace percuss
