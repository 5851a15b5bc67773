#include "src/app/process/tools.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "comm/communicator.hpp"
#include "src/app/process/stop_signals.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

fs::path find_this_program() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
}

/// The folder with the Python package, of a checkout in which this program was built, or of an installation.
fs::path find_python_folder(const std::string& name) {
  std::error_code ignored;
  const fs::path bin = find_this_program().parent_path();
  for (const fs::path& root : {bin.parent_path().parent_path(), bin.parent_path() / "share/percuss"})
    if (fs::exists(root / "python/percuss/__main__.py", ignored)) return root / "python";
  throw InputError(
      fmt::format("percuss: error: there is no Python package percuss, of which percuss {} is a tool (it belongs to "
                  "the checkout or installation that holds {}): start the program there",
                  name, bin.string()));
}

bool is_tool(const std::string& name) {
  const std::vector<std::string>& names = tool_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Lets Python find the package before others of this name, and nothing in the current folder.
void set_environment(const fs::path& folder) {
  const char* given = std::getenv("PYTHONPATH");
  const std::string path = folder.string() + (given != nullptr && *given != '\0' ? std::string(":") + given : "");
  ::setenv("PYTHONPATH", path.c_str(), 1);
  ::setenv("PYTHONSAFEPATH", "1", 1);
  ::setenv("PATH", "/usr/local/bin:/usr/bin:/bin", 0);  // without it Python does not know where its interpreter is
  ::setenv("PERCUSS_LAW_FLAGS", PERCUSS_LAW_FLAGS, 1);  // for percuss build-law
  ::setenv("PERCUSS_PROGRAM", find_this_program().c_str(), 1);  // for tools that call percuss
}

std::vector<char*> point_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// How much an interpreter lacks for a tool, as the package counts it; 255 where it cannot be started.
int count_missing(const std::string& python, const std::string& tool) {
  std::vector<std::string> words{python, "-m", "percuss", "--lacks", tool};
  posix_spawn_file_actions_t silence;
  ::posix_spawn_file_actions_init(&silence);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&silence, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, python.c_str(), &silence, nullptr, point_to(words).data(), environ);
  ::posix_spawn_file_actions_destroy(&silence);
  int status = 0;
  if (error != 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return 255;
  return WEXITSTATUS(status);
}

/// PERCUSS_PYTHON, or the one that lacks less for a tool: python3 in PATH, or that of the system, which packages of a
/// distribution belong to.
std::string choose_python(const std::string& tool) {
  const char* wanted = std::getenv("PERCUSS_PYTHON");
  if (wanted != nullptr && *wanted != '\0') return wanted;
  const std::string first = "python3", system = "/usr/bin/python3";
  const int missing = count_missing(first, tool);
  return missing > 0 && count_missing(system, tool) < missing ? system : first;
}

}  // namespace

const std::vector<std::string>& tool_names() {
  static const std::vector<std::string> names = {"import", "plot", "report", "watch", "stop",
                                                 "render", "view", "export", "sweep", "build-law"};
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
  set_environment(find_python_folder(name));
  release_stop_signals();  // a tool and what it starts would hold them for ever
  std::vector<std::string> words{choose_python(name), "-m", "percuss", name};
  words.insert(words.end(), argv + 2, argv + argc);
  ::execvp(words[0].c_str(), point_to(words).data());
  throw SystemError(fmt::format("percuss {}: {} cannot be started ({}): install Python 3, or name it in PERCUSS_PYTHON",
                                name, words[0], std::strerror(errno)));
}

}  // namespace percuss
