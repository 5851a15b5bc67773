#pragma once
// Requests to the run in progress, to stop or to write a checkpoint: made by a signal on any rank, honoured where all
// ranks agree.

#include <stdexcept>

#include "comm/communicator.hpp"

namespace percuss {

/// The run was asked to stop before its first step, so that there is nothing to write (exit code 130).
class Interruption : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Asks the run in progress, or the next one, to stop; async-signal-safe.
void request_stop();

/// Whether this rank was asked to.
bool is_stop_requested();

/// The next run of this process starts afresh.
void forget_stop_request();

/// Asks for a checkpoint after the step that is under way; async-signal-safe.
void request_checkpoint();

/// Whether this rank was asked for one, and since then has none.
bool is_checkpoint_requested();
void forget_checkpoint_request();

/// Throws Interruption on all ranks if any was asked to stop. stage: what was done, "the mesh was built". Collective.
void stop_if_requested(const Communicator& ranks, const char* stage);

}  // namespace percuss
