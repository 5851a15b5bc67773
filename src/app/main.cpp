// percuss: explicit impact dynamics with parallel contact. See program.hpp.

#include "src/app/program.hpp"
#include "src/app/threads.hpp"

int main(int argc, char** argv) {
  percuss::shorten_waiting(argv);
  return percuss::run_program(argc, argv);
}
