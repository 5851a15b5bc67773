#pragma once
// Tries something in a process of its own first: libraries that crash or hang on damaged files then take only that
// process down.

#include <functional>

namespace percuss {

/// Runs `trial` in a forked process with silent standard output and error, and waits for it. Rethrows its InputError
/// or SystemError; throws InputError if it crashed or took longer than `seconds` of wall-clock time. Whatever it
/// changed in memory is lost with its process.
void run_trial_process(const std::function<void()>& trial, unsigned seconds);

}  // namespace percuss
