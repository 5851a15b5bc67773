#pragma once
// The first of the faults that ranks find, so that any number of ranks refuses the same input for the same reason.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"

namespace percuss {

/// The number of a rank that has found nothing.
inline constexpr std::int64_t no_finding = std::numeric_limits<std::int64_t>::max();

/// The text of the finding with the lowest number, among equals that of the lowest rank, on every rank; nothing if no
/// rank has one. number: such as that of an element in the whole mesh, or of a line. Collective. Throws MpiError.
inline std::optional<std::string> agree_on_first(const Communicator& ranks, std::int64_t number,
                                                 const std::string& text) {
  std::int64_t first = number;
  all_reduce(ranks, Reduce::least, first);
  if (first == no_finding) return {};
  int rank = number == first ? ranks.rank() : ranks.size();
  all_reduce(ranks, Reduce::least, rank);
  return broadcast_text(ranks, text, rank);
}

}  // namespace percuss
