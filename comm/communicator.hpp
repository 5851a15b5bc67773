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

/// The clock of compute_seconds(): that of the thread, which stands still while another program or rank has its core,
/// or the usual one, which costs a twentieth to read. A reading of the thread's own is a system call; those of a step
/// with contact would be a twentieth of a small scene's run.
enum class WorkClock { thread, usual };

/// Chooses the clock. Until then a program on several ranks counts by the thread's clock, one on a single rank by the
/// usual one. Between phases, on each rank by itself.
void choose_work_clock(WorkClock clock);

/// Seconds without what the calling thread spent in wait_mpi(): its work. A rank that waits for others may spin or
/// yield; neither is work.
double compute_seconds();

/// During its lifetime compute_seconds() counts the calling thread as waiting for other ranks.
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

  /// Marks the begin or end of the profiled region for MPI profilers (MPI_Pcontrol); no effect without one.
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
  /// A communicator of the same ranks. Collective over them. Throws MpiError.
  static OwnedCommunicator duplicate(const Communicator& ranks);

  /// The ranks first <= rank < last of `ranks`, renumbered from 0. Collective over those alone. Throws MpiError.
  static OwnedCommunicator of_range(const Communicator& ranks, int first, int last);

  /// A communicator of the same ranks in the order of their keys, which differ. Collective over them. Throws MpiError.
  static OwnedCommunicator in_order(const Communicator& ranks, int key);

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
