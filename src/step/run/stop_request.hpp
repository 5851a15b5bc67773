#pragma once
// Requests to the run in progress, to stop or to write something: made by a signal on any rank or by a file in the
// folder of results, honoured where all ranks agree.

#include <chrono>
#include <stdexcept>
#include <string>

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

/// Whether this rank was asked for a checkpoint, and has written none since.
bool is_checkpoint_requested();
void forget_checkpoint_request();

/// Requests by files, for users who cannot send a signal: DIR/stop ends the run with a checkpoint, DIR/checkpoint
/// writes one, DIR/frame writes a frame of fields and, without sensors, a row of the history.
class FolderRequests {
 public:
  struct Found {
    bool stop = false, checkpoint = false, frame = false;
  };

  /// Requests during the start are found at the first check. folder: empty for a run without files.
  explicit FolderRequests(std::string folder);

  /// Requests since the last call; the files are removed. Checks at most four times a second.
  Found take();

 private:
  using Clock = std::chrono::steady_clock;

  std::string folder_;
  Clock::time_point next_ = Clock::now();
};

/// Removes the requests in a folder that are older than the lock of its run: they were made to an earlier one.
void remove_stale_requests(const std::string& folder, const std::string& lock);

/// Throws Interruption on all ranks if any was asked to stop. stage: what was done, "the mesh was built". Collective.
void stop_if_requested(const Communicator& ranks, const char* stage);

}  // namespace percuss
