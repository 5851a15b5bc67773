// The main function of every test executable: MPI and Kokkos up before the first test, down after the last. Arguments:
// sources whose tests alone run.

#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>

#include "comm/communicator.hpp"
#include "tests/chosen_sources.hpp"

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  const Kokkos::ScopeGuard kokkos(argc, argv);
  return percuss::test::choose_sources(argc, argv) ? RUN_ALL_TESTS() : 1;
}
