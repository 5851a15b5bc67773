#pragma once
// Reductions over ranks of plain numbers, in place: the sum, the least or the largest of what the ranks have.
//
// merge_reduction.hpp reduces structs, exact_reduction.hpp adds doubles without an order.

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <span>
#include <type_traits>

#include "comm/communicator.hpp"

namespace percuss {

/// Operation on the numbers of all ranks. Sums are for integers (and for doubles whose last bits do not matter).
enum class Reduce { sum, least, largest };

namespace all_reduce_detail {

template <class T>
MPI_Datatype find_type() {
  if constexpr (std::is_same_v<T, double>) {
    return MPI_DOUBLE;
  } else {
    static_assert(std::is_integral_v<T> && (sizeof(T) == 4 || sizeof(T) == 8), "no type of MPI is known for this");
    if constexpr (std::is_signed_v<T>)
      return sizeof(T) == 4 ? MPI_INT32_T : MPI_INT64_T;
    else
      return sizeof(T) == 4 ? MPI_UINT32_T : MPI_UINT64_T;
  }
}

inline MPI_Op find_operation(Reduce by) {
  if (by == Reduce::sum) return MPI_SUM;
  return by == Reduce::least ? MPI_MIN : MPI_MAX;
}

template <class T>
void reduce_in_place(const Communicator& ranks, Reduce by, std::span<T> values) {
  constexpr std::size_t piece = std::size_t{1} << 27;  // MPI counts with an int
  if (ranks.size() == 1) return;
  for (std::size_t first = 0; first < values.size(); first += piece) {
    const auto count = static_cast<int>(std::min(piece, values.size() - first));
    wait_mpi(
        [&] {
          return MPI_Allreduce(MPI_IN_PLACE, values.data() + first, count, find_type<T>(), find_operation(by),
                               ranks.handle());
        },
        "MPI_Allreduce");
  }
}

}  // namespace all_reduce_detail

/// One number: in, this rank's; out, that of all ranks. Collective. Throws MpiError.
template <class T>
requires std::is_arithmetic_v<T>
void all_reduce(const Communicator& ranks, Reduce by, T& value) {
  all_reduce_detail::reduce_in_place(ranks, by, std::span<T>(&value, 1));
}

/// Each number of an array, as many on every rank, in one message. Collective. Throws MpiError.
template <std::ranges::contiguous_range Values>
void all_reduce(const Communicator& ranks, Reduce by, Values&& values) {
  all_reduce_detail::reduce_in_place(ranks, by, std::span<std::ranges::range_value_t<Values>>(values));
}

}  // namespace percuss
