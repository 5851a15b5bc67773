#pragma once
// Short lists of all ranks, on each, for set-up.

#include <vector>

#include "comm/communicator.hpp"

namespace percuss {

/// The items of all ranks, by rank. Item: trivially copyable. Collective. Throws MpiError.
template <class Item>
std::vector<Item> gather_items(const Communicator& ranks, const std::vector<Item>& own) {
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<int> bytes(size), first(size + 1, 0);
  const int count = static_cast<int>(own.size() * sizeof(Item));
  wait_mpi([&] { return MPI_Allgather(&count, 1, MPI_INT, bytes.data(), 1, MPI_INT, ranks.handle()); },
           "MPI_Allgather");
  for (std::size_t r = 0; r < size; ++r) first[r + 1] = first[r] + bytes[r];
  std::vector<Item> all(static_cast<std::size_t>(first[size]) / sizeof(Item));
  check_mpi(
      MPI_Allgatherv(own.data(), count, MPI_BYTE, all.data(), bytes.data(), first.data(), MPI_BYTE, ranks.handle()),
      "MPI_Allgatherv");
  return all;
}

}  // namespace percuss
