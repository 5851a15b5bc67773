#include "comm/agreement.hpp"

#include <cstddef>

#include "comm/all_reduce.hpp"

namespace percuss {

std::string broadcast_text(const Communicator& ranks, const std::string& own, int root) {
  int length = static_cast<int>(own.size());
  wait_mpi([&] { return MPI_Bcast(&length, 1, MPI_INT, root, ranks.handle()); }, "MPI_Bcast");
  std::string text = own;
  text.resize(static_cast<std::size_t>(length));
  wait_mpi([&] { return MPI_Bcast(text.data(), length, MPI_CHAR, root, ranks.handle()); }, "MPI_Bcast");
  return text;
}

std::vector<std::string> gather_texts(const Communicator& ranks, const std::string& own) {
  const auto count = static_cast<std::size_t>(ranks.rank() == 0 ? ranks.size() : 0);
  const int length = static_cast<int>(own.size());
  std::vector<int> lengths(count), first(count + 1, 0);
  wait_mpi([&] { return MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, ranks.handle()); },
           "MPI_Gather");
  for (std::size_t r = 0; r < count; ++r) first[r + 1] = first[r] + lengths[r];
  std::string all(static_cast<std::size_t>(first.back()), '\0');
  check_mpi(
      MPI_Gatherv(own.data(), length, MPI_CHAR, all.data(), lengths.data(), first.data(), MPI_CHAR, 0, ranks.handle()),
      "MPI_Gatherv");
  std::vector<std::string> texts(count);
  for (std::size_t r = 0; r < count; ++r) {
    texts[r] = all.substr(static_cast<std::size_t>(first[r]), static_cast<std::size_t>(lengths[r]));
  }
  return texts;
}

std::optional<Failure> agree_on_failure(const Communicator& ranks, const std::optional<Failure>& own) {
  int lowest = own ? ranks.rank() : ranks.size();
  all_reduce(ranks, Reduce::least, lowest);
  if (lowest == ranks.size()) return std::nullopt;
  Failure failure = ranks.rank() == lowest ? *own : Failure{};
  wait_mpi([&] { return MPI_Bcast(&failure.code, 1, MPI_INT, lowest, ranks.handle()); }, "MPI_Bcast");
  failure.text = broadcast_text(ranks, failure.text, lowest);
  return failure;
}

}  // namespace percuss
