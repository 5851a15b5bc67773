// percuss: explicit impact dynamics with parallel contact. See program.hpp.

#include "src/app/program.hpp"

int main(int argc, char** argv) { return percuss::run_program(argc, argv); }
