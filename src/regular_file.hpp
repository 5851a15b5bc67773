#pragma once
// Checks the type of a file before it is opened. Files to read must be regular, since a pipe or a device may block its
// reader for ever, or never end.

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace percuss {

/// "a named pipe (a regular file is needed): ..." if something else than a regular file stands at `path`; empty for a
/// regular file, also behind a symbolic link, and for what is not there or cannot be looked at. Opens nothing.
inline std::string describe_irregular_file(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return "";
  const char* const kind = S_ISDIR(status.st_mode)    ? "a folder"
                           : S_ISFIFO(status.st_mode) ? "a pipe"
                           : S_ISSOCK(status.st_mode) ? "a socket"
                                                      : "a device";
  return std::string(kind) + " (a regular file is needed): name a file, or write what comes from there to one first";
}

/// Whether both paths lead to one file or folder, and it is there; false for what cannot be looked at.
inline bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) && !error;
}

}  // namespace percuss
