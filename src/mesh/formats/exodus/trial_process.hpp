#pragma once
// Tries something in a process of its own first: libraries that crash or hang on damaged files then take only that
// process down.

#include <cstdint>
#include <functional>
#include <string>

namespace percuss {

/// Runs `trial` in a forked process with silent standard output and error, and waits for it. Rethrows its InputError
/// or SystemError; throws InputError if it crashed or took longer than `seconds` of wall-clock time. Whatever it
/// changed in memory is lost with its process.
void run_trial_process(const std::function<void()>& trial, unsigned seconds);

/// Seconds that are far more than reading a file of so many bytes takes, on a slow network file system too.
unsigned find_patience(std::uintmax_t bytes);

/// Does `work` on a file in such a process before anybody does it in earnest. Throws InputError, with the file's name,
/// if it crashed or took longer than reading the file can take; what it threw there is left to be thrown in earnest.
void rehearse(const std::string& path, std::uintmax_t bytes, const std::function<void()>& work);

}  // namespace percuss
