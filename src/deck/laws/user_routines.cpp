#include "src/deck/laws/user_routines.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

#include "kernels/material/user/user_fields.hpp"
#include "src/deck/laws/user_exits.hpp"

namespace percuss {
namespace {

/// The run, and the messages that the code has printed.
struct UserContext {
  UserRun run;
  std::mutex busy;
  std::map<std::string, int> messages;  // how often each
};
UserContext& context() {
  static UserContext one;
  return one;
}

/// The library to which a place in code belongs.
std::string name_library(const void* place) {
  Dl_info found{};
  const bool is_known = ::dladdr(place, &found) != 0 && found.dli_fname != nullptr;
  return is_known ? std::filesystem::path(found.dli_fname).filename().string() : "a library";
}

[[noreturn]] void end_run(const std::string& library, const char* how) { end_by_user_code(library.c_str(), how); }

/// The next value of a message.
struct MessageValues {
  const int* integer;
  const double* real;
  const char* word;  // of eight letters each

  std::string take(char kind) {
    if (kind == 'I') return std::to_string(*integer++);
    if (kind == 'R') return fmt::format("{:g}", *real++);
    word += 8;
    return read_fortran(word - 8, 8);
  }
};

/// A message with its values for %I, %R and %S.
std::string fill_message(const std::string& form, MessageValues values) {
  std::string text;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const char kind = i + 1 < form.size() ? form[i + 1] : ' ';
    const bool is_value = form[i] == '%' && (kind == 'I' || kind == 'R' || kind == 'S');
    if (is_value)
      text += values.take(kind);
    else
      text += form[i];
    i += is_value ? 1 : 0;
  }
  return text;
}

/// A message, known by its form, is printed some times, then that it continues.
void print_message(const std::string& library, const char* kind, const std::string& form, const std::string& text,
                   int most = 5) {
  constexpr std::size_t most_forms = 1000;
  UserContext& all = context();
  const std::scoped_lock lock(all.busy);
  if (all.messages.size() > most_forms) return;
  if (all.messages.size() == most_forms) std::fputs("note: further messages of that code are not printed\n", stderr);
  const int count = ++all.messages[form];
  if (count > most) return;
  std::fputs(fmt::format("{}{}: {}\n", kind, library, text).c_str(), stderr);
  if (count == most) std::fputs("note: that message is not printed again\n", stderr);
}

void copy_name(const std::string& text, char* to, int* count, std::size_t length) {
  write_fortran(text, to, length);
  *count = static_cast<int>(std::min(text.size(), length));
}

constexpr int most_locks = 100;
std::mutex* find_lock(const int* id) {
  static std::array<std::mutex, most_locks> locks;
  return *id >= 1 && *id <= most_locks ? &locks[static_cast<std::size_t>(*id - 1)] : nullptr;
}

/// Copies what VGETVRM returns for the points of this thread; the status: 0, or 1 where there is no such quantity.
int copy_quantity(const std::string& library, const std::string& quantity, double* values) {
  if (asked_points != nullptr && asked_points->tell(quantity, values)) return 0;
  const std::string text =
      asked_points == nullptr
          ? "VGETVRM answers in a VUSDFLD alone: call it there"
          : fmt::format(
                "VGETVRM has no {} here (there are S, LE, TEMP, SDV, and PEEQ beside a VUHARD): use one of these",
                quantity);
  print_message(library, "warning: ", text, text, 1);
  return 1;
}

void issue(const std::string& library, int kind, const std::string& form, const MessageValues& values) {
  const char* const word = kind == 1 ? "note: " : kind == -1 ? "warning: " : "error: ";
  print_message(library, word, form, fill_message(form, values));
  if (kind == -3) end_run(library, "by a message that ends it");
}

}  // namespace

void set_user_run(UserRun run) {
  set_end_of_ranks(run.end);
  context().run = std::move(run);
}

std::string read_fortran(const char* text, std::size_t length) {
  while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\0')) --length;
  return {text, length};
}

void write_fortran(const std::string& text, char* to, std::size_t length) {
  std::fill_n(to, length, ' ');
  std::copy_n(text.begin(), std::min(text.size(), length), to);
}

}  // namespace percuss

using percuss::context;

PERCUSS_USER_ROUTINE void vgetjobname_(char* name, int* count, std::size_t length) {
  percuss::copy_name(context().run.job, name, count, length);
}
PERCUSS_USER_ROUTINE void vgetoutdir_(char* name, int* count, std::size_t length) {
  percuss::copy_name(context().run.folder, name, count, length);
}
PERCUSS_USER_ROUTINE void getjobname_(char* name, int* count, std::size_t length) { vgetjobname_(name, count, length); }
PERCUSS_USER_ROUTINE void getoutdir_(char* name, int* count, std::size_t length) { vgetoutdir_(name, count, length); }
PERCUSS_USER_ROUTINE void vgetnumcpus_(int* count) { *count = context().run.ranks; }
PERCUSS_USER_ROUTINE void vgetrank_(int* rank) { *rank = context().run.rank; }
PERCUSS_USER_ROUTINE void getnumcpus_(int* count) { vgetnumcpus_(count); }
PERCUSS_USER_ROUTINE void getrank_(int* rank) { vgetrank_(rank); }
PERCUSS_USER_ROUTINE int getcommunicator_() { return context().run.communicator; }

PERCUSS_USER_ROUTINE int getnumthreads_() { return context().run.threads; }
/// Number of the thread from 0, in the order in which threads ask.
PERCUSS_USER_ROUTINE int get_thread_id_() {
  static std::atomic<int> next = 0;
  thread_local const int own = next++;
  return own;
}

PERCUSS_USER_ROUTINE void mutexinit_(const int*) {}
PERCUSS_USER_ROUTINE void mutexlock_(const int* id) {
  if (std::mutex* const lock = percuss::find_lock(id); lock != nullptr) return lock->lock();
  percuss::end_run(percuss::name_library(__builtin_return_address(0)), "it asks for a mutex that is not 1 to 100");
}
PERCUSS_USER_ROUTINE void mutexunlock_(const int* id) {
  if (std::mutex* const lock = percuss::find_lock(id); lock != nullptr) lock->unlock();
}

PERCUSS_USER_ROUTINE void xplb_abqerr_(const int* kind, const char* form, const int* integers, const double* reals,
                                       const char* words, std::size_t length, std::size_t) {
  percuss::issue(percuss::name_library(__builtin_return_address(0)), *kind, percuss::read_fortran(form, length),
                 {integers, reals, words});
}
PERCUSS_USER_ROUTINE void stdb_abqerr_(const int* kind, const char* form, const int* integers, const double* reals,
                                       const char* words, std::size_t length, std::size_t) {
  percuss::issue(percuss::name_library(__builtin_return_address(0)), *kind, percuss::read_fortran(form, length),
                 {integers, reals, words});
}
/// Quantities of numbers alone: the integers and the flags stay as they are. The length of the flags, which comes last,
/// is not read.
PERCUSS_USER_ROUTINE void vgetvrm_(const char* quantity, double* values, int*, char*, int* status, std::size_t length) {
  std::string name = percuss::read_fortran(quantity, length);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  *status = percuss::copy_quantity(percuss::name_library(__builtin_return_address(0)), name, values);
}

PERCUSS_USER_ROUTINE void xplb_exit_() {
  percuss::end_run(percuss::name_library(__builtin_return_address(0)), "XPLB_EXIT");
}
PERCUSS_USER_ROUTINE void xit_() { percuss::end_run(percuss::name_library(__builtin_return_address(0)), "XIT"); }
