#include "src/app/start/tools.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "comm/communicator.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

fs::path find_this_program() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
}

/// The tool of a checkout in which this program was built, or of an installation.
fs::path find_tool(const std::string& name) {
  std::error_code ignored;
  const fs::path bin = find_this_program().parent_path();
  for (const fs::path& root : {bin.parent_path().parent_path(), bin.parent_path() / "share/percuss"}) {
    fs::path file = root / "scripts" / name;
    if (fs::exists(root / "python/percuss", ignored) && fs::exists(file, ignored)) return file;
  }
  throw InputError(
      fmt::format("percuss: error: cannot find scripts/{1}, which percuss {0} runs (it belongs to the checkout or "
                  "installation that holds {2})",
                  name, name, bin.string()));
}

bool is_tool(const std::string& name) {
  const std::vector<std::string>& names = tool_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

const std::vector<std::string>& tool_names() {
  static const std::vector<std::string> names = {"import", "plot", "report", "watch", "stop",
                                                 "render", "view", "export", "sweep"};
  return names;
}

bool become_tool(int argc, char** argv) {
  if (argc < 2) return false;
  std::string name = argv[1];
  static char help[] = "--help";
  char* words_of_help[] = {argv[0], argv[2], help, nullptr};
  if (name == "help" && argc == 3 && is_tool(argv[2])) return become_tool(3, words_of_help);
  const auto has = [&](const char* option) {
    return std::find(argv + 2, argv + argc, std::string(option)) != argv + argc;
  };
  if (name == "check" && has("--report")) name = "preview";
  if (name == "info" && (has("--energies") || has("--forces"))) name = "tables";
  if (!is_tool(name) && name != "preview" && name != "tables") return false;
  if (is_launched())
    throw InputError(fmt::format("percuss: error: percuss {} needs no ranks: call it without mpirun", name));
  std::string tool = find_tool(name).string();
  ::setenv("PERCUSS_PROGRAM", find_this_program().c_str(), 1);  // for tools that call percuss
  std::vector<char*> words{tool.data()};
  words.insert(words.end(), argv + 2, argv + argc);
  words.push_back(nullptr);
  ::execv(tool.c_str(), words.data());
  throw SystemError(fmt::format("{} cannot be started ({})", tool, std::strerror(errno)));
}

}  // namespace percuss
