#include "src/deck/laws/user_code.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

#include "kernels/material/user/user_call.hpp"
#include "src/deck/laws/library_file.hpp"
#include "src/deck/laws/user_exits.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

/// A library that stays loaded.
struct Library {
  void* handle = nullptr;
  int has_written_outside = 0;

  LoadedLibrary describe(const std::string& file) { return {handle, &has_written_outside, file.c_str()}; }
};

/// Loaded libraries, by the path as decks name it.
struct LoadedCode {
  std::mutex busy;
  std::vector<std::string> permitted;
  std::map<std::string, Library> libraries;
  std::set<std::vector<double>> step_starts;
};

LoadedCode& all_code() {
  static LoadedCode code;
  return code;
}

std::string to_capitals(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
  return word;
}

}  // namespace

void refuse_library(const std::string& file, const std::string& why, const std::string& remedy) {
  throw InputError(fmt::format("{}: error: this library is no law ({}): {}", file, why, remedy));
}

void permit_user_code(const std::vector<std::string>& files) {
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  code.permitted = files;
}

bool is_user_code_permitted(const std::string& file) {
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  std::error_code ignored;
  for (const std::string& permitted : code.permitted)
    if (fs::equivalent(permitted, file, ignored)) return true;
  return false;
}

LoadedLibrary load_library(const std::string& file) {
  if (!is_user_code_permitted(file))
    throw InputError(
        fmt::format("{}: error: this library may not be loaded (it would run with your rights): add "
                    "--allow-library {} if you trust it",
                    file, file));
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  if (const auto known = code.libraries.find(file); known != code.libraries.end())
    return known->second.describe(known->first);
  if (const std::string fault = find_library_fault(file); !fault.empty())
    refuse_library(file, fault, "compile or copy it once more");
  watch_user_exits();
  void* handle = nullptr;
  call_library(file.c_str(), [&] { handle = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL); });
  if (handle == nullptr) refuse_library(file, ::dlerror(), "compile it for this machine (docs/user_laws.md)");
  const auto made = code.libraries.emplace(file, Library{handle}).first;
  return made->second.describe(made->first);
}

void* find_user_entry(const std::string& file, const std::string& subroutine) {
  const LoadedLibrary library = load_library(file);
  for (const std::string& name : {subroutine + "_", subroutine, to_capitals(subroutine)})  // as compilers call it
    if (void* const entry = ::dlsym(library.handle, name.c_str()); entry != nullptr) return entry;
  return nullptr;
}

UserCode load_user_code(const std::string& file, const std::string& subroutine) {
  void* const entry = find_user_entry(file, subroutine);
  if (entry == nullptr)
    refuse_library(file, fmt::format("it has no entry {}_", subroutine),
                   fmt::format("name its subroutine {}", to_capitals(subroutine)));
  UserCode code;
  const LoadedLibrary library = load_library(file);
  code.has_written_outside = library.has_written_outside;
  code.file = library.file;
  if (subroutine == "vuhard")
    code.vuhard = reinterpret_cast<VuhardFunction>(entry);
  else
    code.vumat = reinterpret_cast<VumatFunction>(entry);
  code.vusdfld = reinterpret_cast<VusdfldFunction>(find_user_entry(file, "vusdfld"));
  return code;
}

void set_step_starts(const std::vector<double>& starts, UserCode& code) {
  for (std::size_t i = 0; i < starts.size(); ++i)
    if (!(starts[i] > (i > 0 ? starts[i - 1] : 0)))
      throw InputError(
          fmt::format("error: step_starts has {} behind {} (times must be positive and rise): correct its order",
                      starts[i], i > 0 ? starts[i - 1] : 0));
  LoadedCode& all = all_code();
  const std::scoped_lock lock(all.busy);
  const std::vector<double>& kept = *all.step_starts.insert(starts).first;
  code.step_starts = kept.data();
  code.step_count = static_cast<int>(kept.size());
}

bool has_written_outside(const std::string& file) {
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  const auto known = code.libraries.find(file);
  return known != code.libraries.end() && __atomic_load_n(&known->second.has_written_outside, __ATOMIC_RELAXED) != 0;
}

}  // namespace percuss
