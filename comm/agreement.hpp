#pragma once
// A failure that one rank has seen becomes the failure of all, so that nobody waits in a collective that others skip.
//
// comm does not know what kinds of errors there are: a kind travels as a code, its message as text.
// src/fail_together.hpp turns exceptions into these and back.

#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.hpp"

namespace percuss {

/// What went wrong on a rank.
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

}  // namespace percuss
