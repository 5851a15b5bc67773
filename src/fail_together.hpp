#pragma once
// Work that may fail on one rank alone, and must then fail on all of them with the same error.

#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

#include "comm/agreement.hpp"
#include "src/error.hpp"

namespace percuss {

/// Kinds of errors as they travel between ranks.
enum class FailureKind : int { input, run, system, mpi, memory, length, internal };

/// The error that is being handled. Only inside a catch clause.
inline Failure describe_current_error() {
  const auto make = [](FailureKind kind, const char* text) { return Failure{static_cast<int>(kind), text}; };
  try {
    throw;
  } catch (const InputError& error) {
    return make(FailureKind::input, error.what());
  } catch (const RunError& error) {
    return make(FailureKind::run, error.what());
  } catch (const SystemError& error) {
    return make(FailureKind::system, error.what());
  } catch (const MpiError& error) {
    return make(FailureKind::mpi, error.what());
  } catch (const std::bad_alloc& error) {
    return make(FailureKind::memory, error.what());
  } catch (const std::length_error& error) {
    return make(FailureKind::length, error.what());
  } catch (const std::exception& error) {
    return make(FailureKind::internal, error.what());
  } catch (...) {
    return make(FailureKind::internal, "an error without a message");
  }
}

/// Throws the failure as the error that it was.
[[noreturn]] inline void throw_failure(const Failure& failure) {
  switch (static_cast<FailureKind>(failure.code)) {
    case FailureKind::input:
      throw InputError(failure.text);
    case FailureKind::run:
      throw RunError(failure.text);
    case FailureKind::system:
      throw SystemError(failure.text);
    case FailureKind::mpi:
      throw MpiError(failure.text);
    case FailureKind::memory:
      throw std::bad_alloc();
    case FailureKind::length:
      throw std::length_error(failure.text);
    case FailureKind::internal:
      break;
  }
  throw std::runtime_error(failure.text);
}

/// Calls work() on every rank. If it throws on any, the error of the lowest such rank is thrown on all. The work itself
/// must not be collective: a rank that fails in it would leave the others waiting. Collective. Throws MpiError.
template <class Work>
void fail_together(const Communicator& ranks, const Work& work) {
  std::optional<Failure> own;
  try {
    work();
  } catch (...) {
    own = describe_current_error();
  }
  if (const auto failure = agree_on_failure(ranks, own)) throw_failure(*failure);
}

}  // namespace percuss
