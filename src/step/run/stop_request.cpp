#include "src/step/run/stop_request.hpp"

#include <fmt/format.h>

#include <csignal>

#include "comm/all_reduce.hpp"

namespace percuss {
namespace {

volatile std::sig_atomic_t stop_requested = 0, checkpoint_requested = 0;

}  // namespace

void request_stop() { stop_requested = 1; }

bool is_stop_requested() { return stop_requested != 0; }

void forget_stop_request() { stop_requested = 0; }

void request_checkpoint() { checkpoint_requested = 1; }

bool is_checkpoint_requested() { return checkpoint_requested != 0; }

void forget_checkpoint_request() { checkpoint_requested = 0; }

void stop_if_requested(const Communicator& ranks, const char* stage) {
  int asked = is_stop_requested() ? 1 : 0;
  all_reduce(ranks, Reduce::largest, asked);
  if (asked == 0) return;
  throw Interruption(
      fmt::format("interrupted {} (a signal asked the run to stop before its first step): no file was changed; start "
                  "it again with the same command",
                  stage));
}

}  // namespace percuss
