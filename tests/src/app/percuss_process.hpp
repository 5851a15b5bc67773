#pragma once
// Runs the built executable as a user does.

#include <functional>
#include <string>
#include <vector>

namespace percuss {

struct ProcessResult {
  int exit_code = -1;  // minus the signal's number if one ended it
  std::string out, err;
};

/// Runs percuss with these arguments and waits for it. `before` is put in front of the command ("mpirun -n 2").
ProcessResult run_percuss(const std::vector<std::string>& arguments, const std::string& before = "");

/// Starts percuss, waits until `file` exists, calls disturb(id of the process) and waits for its end.
ProcessResult disturb_percuss(const std::vector<std::string>& arguments, const std::string& file,
                              const std::function<void(int)>& disturb, const std::string& before = "");

/// Starts percuss, waits until `file` exists, sends it a signal and waits for its end.
ProcessResult interrupt_percuss(const std::vector<std::string>& arguments, const std::string& file, int signal_number,
                                const std::string& before = "");

/// Launcher of percuss on several ranks, for `before`.
std::string launch_on(int ranks);

/// How often a text has `what` in it.
int count(const std::string& text, const std::string& what);

/// A new, empty folder of this process; gone with its contents when this is destroyed.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

  /// Writes a file in the folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

}  // namespace percuss
