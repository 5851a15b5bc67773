#include "tests/src/app/percuss_process.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace percuss {
namespace {

namespace fs = std::filesystem;

std::string quote(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

int decode(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status); }

std::string make_command(const std::vector<std::string>& arguments, const std::string& before,
                         const std::string& folder) {
  // What MPI left in the environment of the test itself would make mpirun take percuss for a part of it.
  std::string command =
      "unset $(env | grep -oE '^(OMPI|PMIX|ORTE)_[A-Za-z0-9_]*'); exec " + before + " " + quote(PERCUSS_EXECUTABLE);
  for (const std::string& argument : arguments) command += ' ' + quote(argument);
  return command + " >" + quote(folder + "/out") + " 2>" + quote(folder + "/err") + " </dev/null";
}

}  // namespace

ProcessResult run_percuss(const std::vector<std::string>& arguments, const std::string& before) {
  const TemporaryFolder folder;
  const int status = std::system(make_command(arguments, before, folder.path()).c_str());
  return {decode(status), read_file(folder.path() + "/out"), read_file(folder.path() + "/err")};
}

ProcessResult disturb_percuss(const std::vector<std::string>& arguments, const std::string& file,
                              const std::function<void(int)>& disturb, const std::string& before) {
  const TemporaryFolder folder;
  const std::string command = make_command(arguments, before, folder.path());
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  while (!fs::exists(file)) {
    if (waitpid(child, &status, WNOHANG) == child) {  // it ended by itself: the test will say so
      return {decode(status), read_file(folder.path() + "/out"), read_file(folder.path() + "/err")};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  disturb(child);
  waitpid(child, &status, 0);
  return {decode(status), read_file(folder.path() + "/out"), read_file(folder.path() + "/err")};
}

ProcessResult interrupt_percuss(const std::vector<std::string>& arguments, const std::string& file, int signal_number,
                                const std::string& before) {
  return disturb_percuss(
      arguments, file, [&](int child) { kill(child, signal_number); }, before);
}

std::string launch_on(int ranks) {
  return "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1 "
         "OMPI_MCA_btl=^tcp "
         "OMP_NUM_THREADS=1 " PERCUSS_MPIEXEC " " +
         std::to_string(ranks);
}

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "percuss_test_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::string path = path_ + "/" + name;
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + path);
  return path;
}

}  // namespace percuss
