#include "comm/communicator.hpp"

#include <array>
#include <cstdlib>
#include <string>

namespace percuss {

void check_mpi(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  if (MPI_Error_string(code, text.data(), &length) != MPI_SUCCESS) length = 0;
  throw MpiError(std::string(call) + " failed (" + std::string(text.data(), static_cast<std::size_t>(length)) + ")");
}

MpiSession::MpiSession(int& argc, char**& argv) {
  int provided = MPI_THREAD_SINGLE;
  check_mpi(MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
  if (provided < MPI_THREAD_FUNNELED) {
    MPI_Finalize();
    throw MpiError("MPI_Init_thread failed (this MPI cannot run beside threads)");
  }
}

// A failing end cannot be told to anybody; the results are on disk by now.
MpiSession::~MpiSession() { MPI_Finalize(); }

Communicator Communicator::world() {
  check_mpi(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  return Communicator(MPI_COMM_WORLD);
}

Communicator::Communicator(MPI_Comm handle) : handle_(handle) {
  check_mpi(MPI_Comm_rank(handle_, &rank_), "MPI_Comm_rank");
  check_mpi(MPI_Comm_size(handle_, &size_), "MPI_Comm_size");
}

void Communicator::barrier() const { check_mpi(MPI_Barrier(handle_), "MPI_Barrier"); }

void Communicator::abort(int exit_code) const {
  MPI_Abort(handle_, exit_code);
  std::abort();  // if MPI_Abort itself failed
}

}  // namespace percuss
