#pragma once
// Ways by which code of a user ends the program: all of them end the run of all ranks, with one message.

#include <functional>

namespace percuss {

/// Sets what ends all ranks at once, before the process ends itself. `end` does not return.
void set_end_of_ranks(std::function<void()> end);

/// Ends all ranks with exit code 3 and one message, that of the first thread that comes here. library: its file; how:
/// it has ended the run.
[[noreturn]] void end_by_user_code(const char* library, const char* how);

/// From now on a library that ends the program while a thread runs its code (user_call.hpp) comes to
/// end_by_user_code(): by exit, as a STOP of Fortran does, by abort, an exception or a signal such as that of an access
/// outside its memory.
void watch_user_exits();

/// Gives each thread of this process the stack on which it tells of an overflow of its own one.
void guard_user_stacks();

}  // namespace percuss
