#include "comm/communicator.hpp"

#include <array>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>

#include "comm/before_abort.hpp"

namespace percuss {

namespace {

clockid_t work_clock = CLOCK_MONOTONIC;
std::function<void()> last_action;  // before an abort

double read_work_clock() {
  timespec time{};
  clock_gettime(work_clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Open MPI starts a daemon for a process that is alone, which may outlive it, and looks for networks: a third of a
/// second for what one process never needs. Without daemons, processes would also make and remove one and the same
/// folder at a time. Whoever has set these variables is heeded.
void keep_to_itself() {
  for (const auto& [variable, value] : {std::pair{"OMPI_MCA_ess_singleton_isolated", "true"},
                                        {"OMPI_MCA_orte_create_session_dirs", "false"},
                                        {"OMPI_MCA_pml", "ob1"}})
    setenv(variable, value, 0);
}

thread_local int waits_under_way = 0;  // scopes may be nested; the outermost counts
thread_local double waited = 0;        // seconds

}  // namespace

void choose_work_clock(WorkClock clock) {
  work_clock = clock == WorkClock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC;
}

double compute_seconds() { return read_work_clock() - waited; }

WaitScope::WaitScope() : start_(waits_under_way++ == 0 ? read_work_clock() : 0) {}

WaitScope::~WaitScope() {
  if (--waits_under_way == 0) waited += read_work_clock() - start_;
}

void check_mpi(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  if (MPI_Error_string(code, text.data(), &length) != MPI_SUCCESS) length = 0;
  throw MpiError(std::string(call) + " failed (" + std::string(text.data(), static_cast<std::size_t>(length)) + ")");
}

bool is_launched() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(variable) != nullptr) return true;
  return false;
}

MpiSession::MpiSession(int& argc, char**& argv) {
  if (!is_launched()) keep_to_itself();
  int provided = MPI_THREAD_SINGLE;
  check_mpi(MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
  if (provided < MPI_THREAD_FUNNELED) {
    MPI_Finalize();
    throw MpiError("MPI_Init_thread failed (this MPI cannot run beside threads)");
  }
  int ranks = 1;
  check_mpi(MPI_Comm_size(MPI_COMM_WORLD, &ranks), "MPI_Comm_size");
  choose_work_clock(ranks > 1 ? WorkClock::thread : WorkClock::usual);
}

// A failure at the end cannot be reported; the results are on disk by now.
MpiSession::~MpiSession() { MPI_Finalize(); }

Communicator Communicator::world() {
  check_mpi(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  return Communicator(MPI_COMM_WORLD);
}

Communicator::Communicator(MPI_Comm handle) : handle_(handle) {
  check_mpi(MPI_Comm_rank(handle_, &rank_), "MPI_Comm_rank");
  check_mpi(MPI_Comm_size(handle_, &size_), "MPI_Comm_size");
}

void Communicator::barrier() const {
  wait_mpi([&] { return MPI_Barrier(handle_); }, "MPI_Barrier");
}

void Communicator::mark_profiled(bool begins) const { check_mpi(MPI_Pcontrol(begins ? 1 : 0), "MPI_Pcontrol"); }

void do_before_abort(std::function<void()> action) { last_action = std::move(action); }

void Communicator::abort(int exit_code) const {
  if (const auto action = std::exchange(last_action, nullptr)) action();
  if (size_ == 1) std::_Exit(exit_code);  // no other rank to end, and nothing for MPI to tell
  MPI_Abort(handle_, exit_code);
  std::abort();  // if MPI_Abort itself failed
}

// Errors return to the caller here too, independent of what new communicators inherit from the MPI library.
OwnedCommunicator::OwnedCommunicator(MPI_Comm handle) : ranks_(handle) {
  check_mpi(MPI_Comm_set_errhandler(handle, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
}

OwnedCommunicator OwnedCommunicator::duplicate(const Communicator& ranks) {
  MPI_Comm copy = MPI_COMM_NULL;
  check_mpi(MPI_Comm_dup(ranks.handle(), &copy), "MPI_Comm_dup");
  return OwnedCommunicator(copy);
}

OwnedCommunicator OwnedCommunicator::of_range(const Communicator& ranks, int first, int last) {
  MPI_Group all = MPI_GROUP_NULL, range = MPI_GROUP_NULL;
  MPI_Comm part = MPI_COMM_NULL;
  int triplet[1][3] = {{first, last - 1, 1}};
  check_mpi(MPI_Comm_group(ranks.handle(), &all), "MPI_Comm_group");
  check_mpi(MPI_Group_range_incl(all, 1, triplet, &range), "MPI_Group_range_incl");
  // Groups that overlap may be made at the same time: the tag, unique to the range's start, keeps them apart.
  check_mpi(MPI_Comm_create_group(ranks.handle(), range, first, &part), "MPI_Comm_create_group");
  check_mpi(MPI_Group_free(&range), "MPI_Group_free");
  check_mpi(MPI_Group_free(&all), "MPI_Group_free");
  return OwnedCommunicator(part);
}

OwnedCommunicator OwnedCommunicator::in_order(const Communicator& ranks, int key) {
  MPI_Comm ordered = MPI_COMM_NULL;
  check_mpi(MPI_Comm_split(ranks.handle(), 0, key, &ordered), "MPI_Comm_split");
  return OwnedCommunicator(ordered);
}

OwnedCommunicator OwnedCommunicator::of_machine(const Communicator& ranks) {
  MPI_Comm part = MPI_COMM_NULL;
  check_mpi(MPI_Comm_split_type(ranks.handle(), MPI_COMM_TYPE_SHARED, ranks.rank(), MPI_INFO_NULL, &part),
            "MPI_Comm_split_type");
  return OwnedCommunicator(part);
}

// As in ~MpiSession, a failure here cannot be reported.
OwnedCommunicator::~OwnedCommunicator() {
  if (!ranks_) return;
  MPI_Comm handle = ranks_->handle();
  MPI_Comm_free(&handle);
}

OwnedCommunicator& OwnedCommunicator::operator=(OwnedCommunicator&& other) noexcept {
  std::swap(ranks_, other.ranks_);
  return *this;
}

}  // namespace percuss
