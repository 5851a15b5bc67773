#include "src/step/run/stop_request.hpp"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <system_error>
#include <utility>

#include "comm/all_reduce.hpp"

namespace percuss {
namespace {

volatile std::sig_atomic_t stop_requested = 0, checkpoint_requested = 0;

constexpr std::chrono::milliseconds between_looks{250};

bool remove_request(const std::string& folder, const char* name) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::path(folder) / name;
  return std::filesystem::is_regular_file(file, ignored) && std::filesystem::remove(file, ignored);
}

bool is_older(const std::filesystem::path& file, const std::filesystem::path& other) {
  std::error_code missing, other_missing;
  const auto written = std::filesystem::last_write_time(file, missing);
  const auto other_written = std::filesystem::last_write_time(other, other_missing);
  return !missing && !other_missing && written < other_written;
}

}  // namespace

void request_stop() { stop_requested = 1; }

bool is_stop_requested() { return stop_requested != 0; }

void forget_stop_request() { stop_requested = 0; }

void request_checkpoint() { checkpoint_requested = 1; }

bool is_checkpoint_requested() { return checkpoint_requested != 0; }

void forget_checkpoint_request() { checkpoint_requested = 0; }

void remove_stale_requests(const std::string& folder, const std::string& lock) {
  for (const char* name : {"stop", "checkpoint", "frame"})
    if (is_older(std::filesystem::path(folder) / name, lock)) remove_request(folder, name);
}

FolderRequests::FolderRequests(std::string folder) : folder_(std::move(folder)) {}

FolderRequests::Found FolderRequests::take() {
  const Clock::time_point now = Clock::now();
  if (folder_.empty() || now < next_) return {};
  next_ = now + between_looks;
  return {remove_request(folder_, "stop"), remove_request(folder_, "checkpoint"), remove_request(folder_, "frame")};
}

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
