#pragma once
// MPI's start and end as an object, and the ranks that run together. Every MPI call of percuss is wrapped by check_mpi.

#include <mpi.h>

#include <optional>
#include <stdexcept>
#include <utility>

namespace percuss {

/// An MPI call failed; what() names the call and MPI's reason.
class MpiError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MpiError if `code`, returned by the MPI call named `call`, is not MPI_SUCCESS.
void check_mpi(int code, const char* call);

/// CPU seconds of the calling thread without what it spent in wait_mpi(): its work, whoever else uses the core. A rank
/// that waits for others may spin or yield; neither is work. Of a program on one rank: seconds by the clock, which cost
/// less to read.
double compute_seconds();

/// Tells compute_seconds() that the calling thread waits for other ranks while this lives.
class WaitScope {
 public:
  WaitScope();
  ~WaitScope();
  WaitScope(const WaitScope&) = delete;
  WaitScope& operator=(const WaitScope&) = delete;

 private:
  double start_;
};

/// check_mpi(call(), name) for a call that may wait for other ranks.
template <class Call>
void wait_mpi(const Call& call, const char* name) {
  int code = MPI_SUCCESS;
  {
    const WaitScope waits;
    code = call();
  }
  check_mpi(code, name);
}

/// Whether mpirun or a like launcher has started this process, by what launchers leave in its environment.
bool is_launched();

/// MPI is up while this lives. One in a program, in main. Collective: construction and destruction.
class MpiSession {
 public:
  /// Starts MPI for one calling thread a rank (MPI_THREAD_FUNNELED). Throws MpiError.
  MpiSession(int& argc, char**& argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

/// A group of ranks; a light handle that does not own the MPI communicator.
class Communicator {
 public:
  /// All ranks of the program; its errors return to the caller instead of ending the program.
  static Communicator world();

  /// The ranks of an MPI communicator that lives longer than this. Throws MpiError.
  explicit Communicator(MPI_Comm handle);

  int rank() const { return rank_; }
  int size() const { return size_; }
  MPI_Comm handle() const { return handle_; }

  /// Returns when every rank has called it. Collective.
  void barrier() const;

  /// Tells MPI profilers that what they are to look at begins or ends (MPI_Pcontrol); without one it does nothing.
  void mark_profiled(bool begins) const;

  /// Ends every rank at once with an exit code: for a failure that one rank alone has seen. Does not return.
  [[noreturn]] void abort(int exit_code) const;

 private:
  MPI_Comm handle_;
  int rank_ = 0, size_ = 1;
};

/// An MPI communicator made for one use and freed with this: its messages never meet those of anybody else.
class OwnedCommunicator {
 public:
  /// The same ranks. Collective over them. Throws MpiError.
  static OwnedCommunicator duplicate(const Communicator& ranks);

  /// The ranks first <= rank < last of `ranks`, renumbered from 0. Collective over those alone. Throws MpiError.
  static OwnedCommunicator of_range(const Communicator& ranks, int first, int last);

  /// The ranks of `ranks` that run on the same machine as this one, in their order. Collective over all. Throws
  /// MpiError.
  static OwnedCommunicator of_machine(const Communicator& ranks);

  ~OwnedCommunicator();
  OwnedCommunicator(OwnedCommunicator&& other) noexcept : ranks_(std::exchange(other.ranks_, std::nullopt)) {}
  OwnedCommunicator& operator=(OwnedCommunicator&& other) noexcept;

  const Communicator& operator*() const { return *ranks_; }
  const Communicator* operator->() const { return &*ranks_; }

 private:
  explicit OwnedCommunicator(MPI_Comm handle);

  std::optional<Communicator> ranks_;
};

}  // namespace percuss
