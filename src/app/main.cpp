// percuss: explicit impact dynamics with parallel contact. See program.hpp.

#include "src/app/process/stop_signals.hpp"
#include "src/app/process/threads.hpp"
#include "src/app/program.hpp"

int main(int argc, char** argv) {
  percuss::hold_stop_signals();
  percuss::start_again_if_needed(argv);
  return percuss::run_program(argc, argv);
}
