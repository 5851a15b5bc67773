#include "src/deck/laws/user_code.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <mutex>

#include "src/error.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

/// A library that stays loaded.
struct Library {
  void* handle = nullptr;
  int has_written_outside = 0;
};

/// What was loaded, by the path as decks name it.
struct LoadedCode {
  std::mutex busy;
  std::vector<std::string> permitted;
  std::map<std::string, Library> libraries;
};

LoadedCode& all_code() {
  static LoadedCode code;
  return code;
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
    return {known->second.handle, &known->second.has_written_outside};
  void* const handle = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse_library(file, ::dlerror(), "compile it for this machine (docs/user_laws.md)");
  Library& library = code.libraries[file];
  library.handle = handle;
  return {handle, &library.has_written_outside};
}

UserCode load_user_code(const std::string& file) {
  const LoadedLibrary library = load_library(file);
  for (const char* name : {"vumat_", "vumat", "VUMAT"})  // as Fortran and C compilers call it
    if (void* const entry = ::dlsym(library.handle, name))
      return {reinterpret_cast<VumatFunction>(entry), 0, library.has_written_outside};
  refuse_library(file, "it has no entry vumat_", "name its subroutine VUMAT");
}

bool has_written_outside(const std::string& file) {
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  const auto known = code.libraries.find(file);
  return known != code.libraries.end() && __atomic_load_n(&known->second.has_written_outside, __ATOMIC_RELAXED) != 0;
}

}  // namespace percuss
