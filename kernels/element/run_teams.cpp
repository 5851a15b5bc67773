#include "kernels/element/chunk_records.hpp"

namespace percuss {

#ifndef PERCUSS_ON_DEVICE  // its kernels are given to Kokkos one by one
void run_teams(const char* label, const ChunkPolicy& policy, void (*run)(const void*, const ChunkMember&),
               const void* kernel) {
  Kokkos::parallel_for(label, policy, [=](const ChunkMember& team) { run(kernel, team); });
}
#endif

}  // namespace percuss
