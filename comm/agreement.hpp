#pragma once
// All ranks agree on a failure of one rank, so that no rank waits in a collective that others skip.
//
// comm does not know what kinds of errors there are: a kind travels as a code, its message as text.
// src/fail_together.hpp turns exceptions into these and back.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "comm/communicator.hpp"

namespace percuss {

/// A failure on a rank.
struct Failure {
  int code = 0;  // its kind, as the caller counts kinds
  std::string text;
  friend bool operator==(const Failure&, const Failure&) = default;
};

/// The failure of the lowest rank that has one, on every rank; nothing if no rank has. One reduction where all is well.
/// Collective. Throws MpiError.
std::optional<Failure> agree_on_failure(const Communicator& ranks, const std::optional<Failure>& own);

/// [ranks] what each rank gave, on rank 0; empty on the others. Together less than 2 GiB. Collective. Throws MpiError.
std::vector<std::string> gather_texts(const Communicator& ranks, const std::string& own);

/// The text that rank `root` gave, on every rank. Collective. Throws MpiError.
std::string broadcast_text(const Communicator& ranks, const std::string& own, int root);

/// Gives every rank the values of rank `root`, however many there are. Collective. Throws MpiError.
template <class T>
void broadcast_values(const Communicator& ranks, std::vector<T>& values, int root) {
  static_assert(std::is_trivially_copyable_v<T>, "values travel as bytes");
  auto count = static_cast<std::int64_t>(values.size());
  check_mpi(MPI_Bcast(&count, 1, MPI_INT64_T, root, ranks.handle()), "MPI_Bcast");
  values.resize(static_cast<std::size_t>(count));
  constexpr std::int64_t piece = std::int64_t{1} << 20;  // MPI counts with an int
  for (std::int64_t first = 0; first < count; first += piece) {
    const auto bytes = static_cast<int>(std::min(piece, count - first) * static_cast<std::int64_t>(sizeof(T)));
    check_mpi(MPI_Bcast(values.data() + first, bytes, MPI_BYTE, root, ranks.handle()), "MPI_Bcast");
  }
}

}  // namespace percuss
