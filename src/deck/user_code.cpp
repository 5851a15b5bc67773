#include "src/deck/user_code.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <map>
#include <mutex>

#include "src/error.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

/// What was loaded, by the path as decks name it. The flags stay where they are.
struct LoadedCode {
  std::mutex busy;
  std::vector<std::string> permitted;
  std::map<std::string, UserCode> loaded;
  std::deque<int> flags;
};

LoadedCode& all_code() {
  static LoadedCode code;
  return code;
}

[[noreturn]] void refuse(const std::string& file, const std::string& why, const std::string& remedy) {
  throw InputError(fmt::format("{}: error: this library is no law ({}): {}", file, why, remedy));
}

/// The entry by the names that Fortran and C compilers give it.
VumatFunction find_entry(void* library) {
  for (const char* name : {"vumat_", "vumat", "VUMAT"})
    if (void* const entry = ::dlsym(library, name)) return reinterpret_cast<VumatFunction>(entry);
  return nullptr;
}

}  // namespace

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

UserCode load_user_code(const std::string& file) {
  if (!is_user_code_permitted(file))
    throw InputError(
        fmt::format("{}: error: this library may not be loaded (it would run with your rights): add "
                    "--allow-library {} if you trust it",
                    file, file));
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  if (const auto known = code.loaded.find(file); known != code.loaded.end()) return known->second;
  void* const library = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse(file, ::dlerror(), "compile it for this machine (docs/user_laws.md)");
  const VumatFunction entry = find_entry(library);
  if (entry == nullptr) refuse(file, "it has no entry vumat_", "name its subroutine VUMAT");
  const UserCode made{entry, 0, &code.flags.emplace_back(0)};
  code.loaded.emplace(file, made);
  return made;
}

bool has_written_outside(const std::string& file) {
  LoadedCode& code = all_code();
  const std::scoped_lock lock(code.busy);
  const auto known = code.loaded.find(file);
  return known != code.loaded.end() && __atomic_load_n(known->second.has_written_outside, __ATOMIC_RELAXED) != 0;
}

}  // namespace percuss
