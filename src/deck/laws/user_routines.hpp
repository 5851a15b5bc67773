#pragma once
// Utility routines of Abaqus that code of a user may call: who and where it is, locks, messages, the end of the run.
//
// The program exports them, so that a library finds them when it is loaded (user_routines.map).

#include <cstddef>
#include <functional>
#include <string>

namespace percuss {

/// Data of the run that the code may request.
struct UserRun {
  std::string job, folder;  // the deck's name without its ending; where results go
  int rank = 0, ranks = 1;  // of this process
  int threads = 1;
  int communicator = 0;       // of Fortran; 0: one rank alone
  std::function<void()> end;  // ends all ranks at once; does not return
};

/// Sets the data that the code gets from now on.
void set_user_run(UserRun run);

/// A text of Fortran without the blanks at its end, and one filled up with them.
std::string read_fortran(const char* text, std::size_t length);
void write_fortran(const std::string& text, char* to, std::size_t length);

}  // namespace percuss

/// A routine that the program exports, by the name that Fortran compilers give it.
#define PERCUSS_USER_ROUTINE extern "C" __attribute__((used, visibility("default")))
