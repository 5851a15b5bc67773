#include "comm/rendezvous.hpp"

#include <chrono>
#include <thread>

namespace percuss {

Rendezvous::~Rendezvous() { MPI_Wait(&waiting_, MPI_STATUS_IGNORE); }

bool Rendezvous::meet() noexcept {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(patience_);
  if (MPI_Ibarrier(ranks_->handle(), &waiting_) != MPI_SUCCESS) return false;
  int all_here = 0;
  while (MPI_Test(&waiting_, &all_here, MPI_STATUS_IGNORE) == MPI_SUCCESS && all_here == 0 && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return all_here != 0;
}

}  // namespace percuss
