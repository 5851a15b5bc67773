// abort_with_last_words: ends all ranks by Communicator::abort() and says what it does before.

#include <cstdio>

#include "comm/before_abort.hpp"
#include "comm/communicator.hpp"

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  const percuss::Communicator world = percuss::Communicator::world();
  percuss::do_before_abort([] { std::puts("replaced"); });
  percuss::do_before_abort([] {
    std::puts("last words");
    std::fflush(stdout);  // nothing is flushed after it
  });
  world.abort(4);
}
