#include <cstdio>

#include "src/app/commands.hpp"
#include "src/deck/reading/deck_schema.hpp"

namespace percuss {

ExitCode schema_command() {
  std::fputs(write_deck_schema().c_str(), stdout);  // program.cpp tells whether it arrived
  return ExitCode::done;
}

}  // namespace percuss
