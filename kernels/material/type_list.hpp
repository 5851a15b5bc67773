#pragma once
// A list of types, and one value of any of them that can be copied byte by byte.

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <type_traits>

namespace percuss {

template <class... Ts>
struct TypeList {};

template <class... Lists>
struct JoinLists;
template <class... Ts>
struct JoinLists<TypeList<Ts...>> {
  using type = TypeList<Ts...>;
};
template <class... As, class... Bs, class... Rest>
struct JoinLists<TypeList<As...>, TypeList<Bs...>, Rest...> : JoinLists<TypeList<As..., Bs...>, Rest...> {};

/// The types of a list for which the Predicate's value is true, in their order.
template <class List, template <class> class Predicate>
struct FilterList;
template <class... Ts, template <class> class Predicate>
struct FilterList<TypeList<Ts...>, Predicate> {
  using type =
      typename JoinLists<TypeList<>, std::conditional_t<Predicate<Ts>::value, TypeList<Ts>, TypeList<>>...>::type;
};

/// Room for one value of a type of some list: it goes to a device as it is. Whoever holds it need not know the list.
template <int Size>
struct AnyOf {
  int kind = -1;  // place in the list; -1: none
  alignas(double) unsigned char bytes[Size] = {};
};

/// Sets the value, which is of a type of the list.
template <int Size, class... Ts, class T>
void set_any_of(AnyOf<Size>& any, TypeList<Ts...>, const T& value) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= Size);
  static_assert((std::is_same_v<T, Ts> || ...), "not in the list: it could not be called");
  constexpr bool is[] = {std::is_same_v<T, Ts>...};
  any.kind = static_cast<int>(std::find(std::begin(is), std::end(is), true) - std::begin(is));
  std::memcpy(any.bytes, &value, sizeof value);
}

/// Calls f with the value, by a chain of comparisons, which is the same way for all lanes of a pack; does nothing if
/// there is none.
template <int Size, class... Ts, class F>
KOKKOS_INLINE_FUNCTION void visit_any_of(const AnyOf<Size>& any, TypeList<Ts...>, const F& f) {
  int kind = 0;
  static_cast<void>(((any.kind == kind++ ? (f(*reinterpret_cast<const Ts*>(any.bytes)), true) : false) || ...));
}

}  // namespace percuss
