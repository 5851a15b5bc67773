#include "src/output/checkpoint/checkpoint_place.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "src/output/checkpoint/sealed_file.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

// A damaged file must not take the place of a whole one.
bool may_become_previous(const std::string& path, const std::string& known_whole) {
  if (known_whole.empty() || is_same_file(path, known_whole)) return true;
  return !is_same_file(find_previous_checkpoint(path), known_whole) && is_sealed(path);
}

// The older checkpoint gets a second name, so that there is one under the first name at any time; where the file system
// has no second names, it is renamed.
void keep_as_previous(const std::string& path) {
  if (::access(path.c_str(), F_OK) != 0) return;
  const std::string previous = find_previous_checkpoint(path), link = previous + ".tmp";
  ::unlink(link.c_str());
  const bool linked = ::link(path.c_str(), link.c_str()) == 0;
  if (std::rename(linked ? link.c_str() : path.c_str(), previous.c_str()) != 0)
    throw make_io_error("write", previous, errno);
  ::unlink(link.c_str());  // it stays if both are names of one file, after a kill between the two renames
}

}  // namespace

std::string find_previous_checkpoint(const std::string& path) {
  const auto dot = path.rfind(".h5");
  return (dot == std::string::npos ? path : path.substr(0, dot)) + "_previous.h5";
}

void remove_unfinished_checkpoint(const std::string& path) {
  ::unlink((path + ".tmp").c_str());
  ::unlink((find_previous_checkpoint(path) + ".tmp").c_str());
}

void replace_checkpoint(const std::string& temporary, const std::string& path, const std::string& known_whole) {
  if (may_become_previous(path, known_whole)) keep_as_previous(path);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) throw make_io_error("write", path, errno);
  sync_folder_of(path);
}

}  // namespace percuss
