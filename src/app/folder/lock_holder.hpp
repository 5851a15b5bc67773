#pragma once
// Who holds the lock of a folder of results, and whether that process is still there.

#include <string>

namespace percuss {

/// Identity of a process for others. Process ids are reused; together with the start time they are unique.
struct LockHolder {
  std::string host;
  std::string boot;           // id of the running kernel, new at every boot
  std::string pid_namespace;  // in which `process` counts; containers have their own
  long process = 0;
  long long process_start = 0;  // clock ticks after the boot
  std::string started;          // UTC
  std::string command;
  std::string nonce;  // a random number, which no other lock has
};

/// This process, with a new nonce.
LockHolder describe_this_process();

/// The text of a lock file: "key: value" lines.
std::string format_holder(const LockHolder& holder);

/// Reads that text; keys that are missing leave their member as it is.
LockHolder parse_holder(const std::string& text);

enum class HolderState {
  running,
  ended,
  unknown  // on another machine or in another container
};

/// silent_s: seconds since the last sign of life of the holder, by the time of its lock file.
HolderState find_state(const LockHolder& holder, double silent_s);

/// "process 123 on host a, started 2026-01-31T12:00:00Z: percuss run deck.yaml"
std::string describe_holder(const LockHolder& holder);

}  // namespace percuss
