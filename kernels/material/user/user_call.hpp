#pragma once
// The library of a user whose code a thread runs, so that whatever ends the program there is told by its name.

namespace percuss {

/// The file of the library whose code this thread runs; null: none.
inline thread_local const char* running_library = nullptr;

/// Calls code of a library. An exception keeps the mark: nothing of the program catches it.
template <class Call>
void call_library(const char* file, const Call& call) {
  running_library = file;
  call();
  running_library = nullptr;
}

}  // namespace percuss
